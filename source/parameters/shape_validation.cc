#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/input_file.h>
#include <magmpm/parameters/section_validation.h>

#include <algorithm>

namespace magmpm
{
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
      std::vector<std::string> unused;
      for (const KindOfShape &other : kinds)
        for (const auto &names : {other.needed, other.allowed})
          for (const std::string &name : names)
            if (declarations.is_declared(section + "/" + name) && !is_in(name, own->needed) &&
                !is_in(name, own->allowed))
              unused.push_back(name);
      check_given(declarations, section, own->needed, unused, own->reason);
    }
  } // namespace

  template <int dim>
  std::unique_ptr<Shape<dim>>
  check_shape(const ParameterRegister &declarations,
              const std::string &section,
              ShapeParameters<dim> &parameters)
  {
    check_given_for<dim>(declarations, section, parameters.type);
    if (parameters.type == ShapeType::box)
      for (int d = 0; d < dim; ++d)
        if (!(parameters.upper_corner[d] > parameters.lower_corner[d]))
          throw declarations.error(section + "/Upper corner",
                                   std::string("along ") + axis_names[d] + " it must lie above " +
                                     section + "/Lower corner (" +
                                     to_text(parameters.lower_corner[d]) + " m).");
    if (parameters.type == ShapeType::cylinder && !(norm(parameters.axis) > 0.))
      throw declarations.error(section + "/Axis", "it must have a length greater than 0.");
    if (parameters.type != ShapeType::mesh && parameters.type != ShapeType::points)
      return make_shape(parameters);

    const std::string file = section + "/File";
    parameters.file        = find_input_file(declarations, file, parameters.file);
    try
      {
        return make_shape(parameters);
      }
    catch (const InputError &error)
      {
        throw InputError(declarations.where(file) + ": " + error.what());
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
                                      : "/Centre";
        throw declarations.error(section + culprit,
                                 "the body reaches to " + std::string(1, axis_names[d]) + " = " +
                                   to_text(below ? reach.lower[d] : reach.upper[d]) +
                                   " m, outside of the box, which is from " + to_text(lower) +
                                   " to " + to_text(upper) +
                                   " m there. Move the body or enlarge the box.");
      }
  }

  template std::unique_ptr<Shape<2>>
  check_shape(const ParameterRegister &, const std::string &, ShapeParameters<2> &);
  template std::unique_ptr<Shape<3>>
  check_shape(const ParameterRegister &, const std::string &, ShapeParameters<3> &);
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
