#include <magmpm/parameters/parameter_sections.h>

namespace magmpm
{
  namespace
  {
    template <int dim>
    void
    declare_primitives(ParameterRegister &declarations, ShapeParameters<dim> &shape)
    {
      declarations.add(
        "Lower corner", shape.lower_corner, "m", "Of a box: its lower corner.", Presence::optional);
      declarations.add(
        "Upper corner", shape.upper_corner, "m", "Of a box: its upper corner.", Presence::optional);
      declarations.add(
        "Centre", shape.centre, "m", "Of a sphere or cylinder: its centre.", Presence::optional);
      declarations.add("Radius",
                       shape.radius,
                       "m",
                       "Of a sphere or cylinder: its radius.",
                       positive,
                       Presence::optional);
      if constexpr (dim == 3)
        {
          declarations.add("Axis",
                           shape.axis,
                           "-",
                           "Of a cylinder: direction of its axis, of any length.",
                           Presence::optional);
          declarations.add("Length",
                           shape.length,
                           "m",
                           "Of a cylinder: its length along the axis.",
                           positive,
                           Presence::optional);
        }
      else
        for (const char *name : {"Axis", "Length"})
          declarations.refuse(name, "a cylinder needs Dimension = 3.");
    }

    template <int dim>
    void
    declare_file(ParameterRegister &declarations,
                 ShapeParameters<dim> &shape,
                 const std::string &of_what,
                 const std::string &formats)
    {
      declarations.add("File",
                       shape.file,
                       "-",
                       of_what + "its file, " + formats +
                         ", looked for beside the parameter file, then in the working directory.",
                       Presence::optional);
      declarations.add("Scale",
                       shape.scale,
                       "-",
                       of_what +
                         "factor on the coordinates in the file, which are metres; 0.001 if "
                         "they are millimetres. Not given: 1.",
                       positive,
                       Presence::optional);
      declarations.add("Rotation",
                       shape.rotation,
                       "rad",
                       of_what +
                         "axis times angle by which it is turned about the file's origin "
                         "after scaling" +
                         (dim == 3 ? "; 0, 0, 1.5708 turns by 90 degrees about z." : ".") +
                         " Not given: 0.",
                       Presence::optional);
      declarations.add("Translation",
                       shape.translation,
                       "m",
                       of_what + "where the file's origin comes to lie. Not given: 0.",
                       Presence::optional);
    }
  } // namespace

  template <int dim>
  void
  declare_shape(ParameterRegister &declarations,
                ShapeParameters<dim> &shape,
                const bool may_be_points)
  {
    std::vector<std::pair<std::string, ShapeType>> shapes = {{"box", ShapeType::box},
                                                             {"sphere", ShapeType::sphere}};
    if (dim == 3)
      {
        shapes.emplace_back("cylinder", ShapeType::cylinder);
        shapes.emplace_back("mesh", ShapeType::mesh);
      }
    if (may_be_points)
      shapes.emplace_back("points", ShapeType::points);
    declarations.add("Shape",
                     shape.type,
                     shapes,
                     "Its shape; a sphere is a disc in 2D, a cylinder and a mesh need Dimension = "
                     "3.");
    declare_primitives(declarations, shape);
    const std::string csv = std::string("lines of x, y") + (dim == 3 ? ", z" : "") +
                            " and perhaps a volume, otherwise that of a regular particle, as CSV";
    if (dim == 3)
      declare_file(declarations,
                   shape,
                   may_be_points ? "Of a mesh or points: " : "Of a mesh: ",
                   "closed triangles as STL, OBJ or PLY" + (may_be_points ? ", " + csv : ""));
    else if (may_be_points)
      declare_file(declarations, shape, "Of points: ", csv);
    else
      for (const char *name : {"File", "Scale", "Rotation", "Translation"})
        declarations.refuse(name, "a mesh needs Dimension = 3.");
  }

  template void
  declare_shape(ParameterRegister &, ShapeParameters<2> &, bool);
  template void
  declare_shape(ParameterRegister &, ShapeParameters<3> &, bool);
} // namespace magmpm
