#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/input_file.h>
#include <magmpm/parameters/shape_section.h>

#include <algorithm>

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
        "Centre", shape.centre, "m", "Of what is round: its centre.", Presence::optional);
      declarations.add("Radius",
                       shape.radius,
                       "m",
                       "Of what is round: its radius, the outer one of a tube or ring.",
                       positive,
                       Presence::optional);
      declarations.add("Inner radius",
                       shape.inner_radius,
                       "m",
                       "Of a tube or ring: the radius of the hole.",
                       positive,
                       Presence::optional);
      if constexpr (dim == 3)
        {
          declarations.add("Axis",
                           shape.axis,
                           "-",
                           "Of a cylinder, tube or ring: direction of its axis, of any length.",
                           Presence::optional);
          declarations.add("Length",
                           shape.length,
                           "m",
                           "Of a cylinder or tube: its length along the axis.",
                           positive,
                           Presence::optional);
        }
      else
        for (const char *name : {"Axis", "Length"})
          declarations.refuse(name, "a cylinder needs Dimension = 3.");
      declarations.add("Of",
                       shape.part_names,
                       {},
                       "Of a union, difference or intersection: names of two or more shapes of the "
                       "section Shapes. A difference is the first without all others; let these "
                       "reach beyond it where they cut it open.");
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
                                                             {"sphere", ShapeType::sphere},
                                                             {"ring", ShapeType::ring},
                                                             {"union", ShapeType::union_of},
                                                             {"difference", ShapeType::difference},
                                                             {"intersection",
                                                              ShapeType::intersection}};
    if (dim == 3)
      {
        shapes.emplace_back("cylinder", ShapeType::cylinder);
        shapes.emplace_back("tube", ShapeType::tube);
        shapes.emplace_back("mesh", ShapeType::mesh);
      }
    if (may_be_points)
      shapes.emplace_back("points", ShapeType::points);
    declarations.add("Shape",
                     shape.type,
                     shapes,
                     "Its shape; a sphere is a disc in 2D, a ring is a torus, in 2D a disc with a "
                     "hole; a cylinder, a tube and a mesh need Dimension = 3.");
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

  namespace
  {
    /** The parameters of a kind of shape. */
    struct KindOfShape
    {
      ShapeType type;
      std::string reason; ///< "Shape = box"
      std::vector<std::string> needed, allowed;
    };

    const std::vector<std::string> placing = {"Scale", "Rotation", "Translation"};

    const std::vector<KindOfShape> kinds = {
      {ShapeType::box, "Shape = box", {"Lower corner", "Upper corner"}, {}},
      {ShapeType::sphere, "Shape = sphere", {"Centre", "Radius"}, {}},
      {ShapeType::cylinder, "Shape = cylinder", {"Centre", "Radius", "Axis", "Length"}, {}},
      {ShapeType::tube, "Shape = tube", {"Centre", "Radius", "Inner radius", "Axis", "Length"}, {}},
      {ShapeType::ring, "Shape = ring", {"Centre", "Radius", "Inner radius", "Axis"}, {}},
      {ShapeType::union_of, "Shape = union", {"Of"}, {}},
      {ShapeType::difference, "Shape = difference", {"Of"}, {}},
      {ShapeType::intersection, "Shape = intersection", {"Of"}, {}},
      {ShapeType::mesh, "Shape = mesh", {"File"}, placing},
      {ShapeType::points, "Shape = points", {"File"}, placing}};

    /** That what this kind of shape needs is given and what only others have is not. */
    template <int dim>
    void
    check_given_for(const ParameterRegister &declarations,
                    const std::string &section,
                    const ShapeType type)
    {
      const auto is_in = [](const std::string &name, const std::vector<std::string> &names) {
        return std::find(names.begin(), names.end(), name) != names.end();
      };
      const auto own = std::find_if(kinds.begin(), kinds.end(), [&](const KindOfShape &kind) {
        return kind.type == type;
      });
      std::vector<std::string> needed, unused;
      for (const std::string &name : own->needed)
        if (declarations.is_declared(section + "/" + name)) // a ring has no axis in 2D
          needed.push_back(name);
      for (const KindOfShape &other : kinds)
        for (const auto &names : {other.needed, other.allowed})
          for (const std::string &name : names)
            if (declarations.is_declared(section + "/" + name) && !is_in(name, own->needed) &&
                !is_in(name, own->allowed))
              unused.push_back(name);
      check_given(declarations, section, needed, unused, own->reason);
    }

    template <int dim>
    void
    check_lengths(const ParameterRegister &declarations,
                  const std::string &section,
                  const ShapeParameters<dim> &parameters)
    {
      if (parameters.type == ShapeType::box)
        for (int d = 0; d < dim; ++d)
          if (!(parameters.upper_corner[d] > parameters.lower_corner[d]))
            throw declarations.error(section + "/Upper corner",
                                     std::string("along ") + axis_names[d] + " it must lie above " +
                                       section + "/Lower corner (" +
                                       to_text(parameters.lower_corner[d]) + " m).");
      const bool has_hole = parameters.type == ShapeType::tube ||
                            parameters.type == ShapeType::ring;
      if (has_hole && !(parameters.inner_radius < parameters.radius))
        throw declarations.error(section + "/Inner radius",
                                 "it must be smaller than " + section + "/Radius (" +
                                   to_text(parameters.radius) + " m).");
      const bool has_axis = parameters.type == ShapeType::cylinder ||
                            parameters.type == ShapeType::tube ||
                            (parameters.type == ShapeType::ring && dim == 3);
      if (has_axis && !(norm(parameters.axis) > 0.))
        throw declarations.error(section + "/Axis", "it must have a length greater than 0.");
    }

    bool
    is_made_of_others(const ShapeType type)
    {
      return type == ShapeType::union_of || type == ShapeType::difference ||
             type == ShapeType::intersection;
    }
  } // namespace

  template <int dim>
  std::unique_ptr<Shape<dim>>
  check_shape(const ParameterRegister &declarations,
              const std::string &section,
              const NamedShapes<dim> &named,
              ShapeParameters<dim> &parameters)
  {
    check_given_for<dim>(declarations, section, parameters.type);
    check_lengths(declarations, section, parameters);
    std::string culprit = section + "/File";
    if (is_made_of_others(parameters.type))
      {
        culprit = section + "/Of";
        take_parts(declarations, section, named, parameters);
      }
    else if (parameters.type == ShapeType::mesh || parameters.type == ShapeType::points)
      parameters.file = find_input_file(declarations, culprit, parameters.file);
    else
      return make_shape(parameters);
    try
      {
        return make_shape(parameters);
      }
    catch (const InputError &error)
      {
        throw InputError(declarations.where(culprit) + ": " + error.what());
      }
  }

  template <int dim>
  void
  check_inside_box(const ParameterRegister &declarations,
                   const std::string &section,
                   const ShapeType type,
                   const BoundingBox<dim> &reach,
                   const Lattice<dim> &lattice)
  {
    for (int d = 0; d < dim; ++d)
      {
        const double lower = lattice.lower_corner[d], upper = lattice.upper_corner()[d];
        const double tolerance = 1e-6 * lattice.spacing;
        const bool below       = reach.lower[d] < lower - tolerance;
        if (!below && !(reach.upper[d] > upper + tolerance))
          continue;
        const std::string culprit = type == ShapeType::box
                                      ? (below ? "/Lower corner" : "/Upper corner")
                                    : type == ShapeType::mesh || type == ShapeType::points
                                      ? "/Translation"
                                    : is_made_of_others(type) ? "/Of"
                                                              : "/Centre";
        throw declarations.error(section + culprit,
                                 "the body reaches to " + std::string(1, axis_names[d]) + " = " +
                                   to_text(below ? reach.lower[d] : reach.upper[d]) +
                                   " m, outside of the box, which is from " + to_text(lower) +
                                   " to " + to_text(upper) +
                                   " m there. Move the body or enlarge the box.");
      }
  }

  template void
  declare_shape(ParameterRegister &, ShapeParameters<2> &, bool);
  template void
  declare_shape(ParameterRegister &, ShapeParameters<3> &, bool);
  template std::unique_ptr<Shape<2>>
  check_shape(const ParameterRegister &,
              const std::string &,
              const NamedShapes<2> &,
              ShapeParameters<2> &);
  template std::unique_ptr<Shape<3>>
  check_shape(const ParameterRegister &,
              const std::string &,
              const NamedShapes<3> &,
              ShapeParameters<3> &);
  template void
  check_inside_box(const ParameterRegister &,
                   const std::string &,
                   ShapeType,
                   const BoundingBox<2> &,
                   const Lattice<2> &);
  template void
  check_inside_box(const ParameterRegister &,
                   const std::string &,
                   ShapeType,
                   const BoundingBox<3> &,
                   const Lattice<3> &);
} // namespace magmpm
