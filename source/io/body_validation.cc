#include <magmpm/io/body_geometry.h>
#include <magmpm/io/given_parameters.h>
#include <magmpm/io/parameter_names.h>
#include <magmpm/io/section_validation.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** That the shape is given, all of it and nothing else. */
    template <int dim>
    void
    check_shape(const ParameterRegister &declarations,
                const std::string &section,
                const BodyParameters<dim> &body)
    {
      const std::vector<std::string> corners = {"Lower corner", "Upper corner"};
      const std::vector<std::string> axis    = {"Axis", "Length"};
      if (body.shape == ShapeType::box)
        {
          check_given(declarations, section, corners, {"Centre", "Radius"}, "Shape = box");
          if constexpr (dim == 3)
            check_given(declarations, section, {}, axis, "Shape = box");
          for (int d = 0; d < dim; ++d)
            if (!(body.upper_corner[d] > body.lower_corner[d]))
              throw declarations.error(section + "/Upper corner",
                                       std::string("along ") + axis_names[d] +
                                         " it must lie above " + section + "/Lower corner (" +
                                         to_text(body.lower_corner[d]) + " m).");
          return;
        }

      const bool cylinder      = (body.shape == ShapeType::cylinder);
      const std::string reason = cylinder ? "Shape = cylinder" : "Shape = sphere";
      check_given(declarations, section, {"Centre", "Radius"}, corners, reason);
      if constexpr (dim == 3)
        check_given(declarations,
                    section,
                    cylinder ? axis : std::vector<std::string>(),
                    cylinder ? std::vector<std::string>() : axis,
                    reason);
      if (cylinder && !(norm(body.axis) > 0.))
        throw declarations.error(section + "/Axis", "it must have a length greater than 0.");
    }

    template <int dim>
    void
    check_inside_box(const ParameterRegister &declarations,
                     const std::string &section,
                     const BodyParameters<dim> &body,
                     const Lattice<dim> &lattice)
    {
      const Extent<dim> reach = extent(body);
      for (int d = 0; d < dim; ++d)
        {
          const double lower = lattice.lower_corner[d], upper = lattice.upper_corner()[d];
          const double tolerance = 1e-6 * lattice.spacing;
          const bool below       = reach.lower[d] < lower - tolerance;
          if (below || reach.upper[d] > upper + tolerance)
            throw declarations.error(
              section + (body.shape == ShapeType::box ? (below ? "/Lower corner" : "/Upper corner")
                                                      : "/Centre"),
              "the body reaches to " + std::string(1, axis_names[d]) + " = " +
                to_text(below ? reach.lower[d] : reach.upper[d]) +
                " m, outside of the box, which is from " + to_text(lower) + " to " +
                to_text(upper) + " m there. Move the body or enlarge the box.");
        }
    }
  } // namespace

  template <int dim>
  void
  check_bodies(const ParameterRegister &declarations,
               const ParameterInput<dim> &input,
               const Parameters<dim> &parameters)
  {
    const std::string list = "Bodies/List of bodies";
    if (parameters.bodies.empty())
      throw declarations.error(list, "a scene needs at least one body.");

    for (const BodyParameters<dim> &body : parameters.bodies)
      {
        const std::string section = "Bodies/" + body.name;
        const auto &names         = input.material_names;
        if (std::find(names.begin(), names.end(), body.material) == names.end())
          throw declarations.error(section + "/Material",
                                   "there is no material of this name. Materials/List of "
                                   "materials is '" +
                                     comma_separated(names) + "'" +
                                     did_you_mean(body.material, names));
        check_shape(declarations, section, body);
        check_inside_box(declarations, section, body, parameters.lattice);
      }

    for (std::size_t i = 0; i < parameters.bodies.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (overlap(parameters.bodies[i], parameters.bodies[j]))
          throw declarations.error(list,
                                   "the bodies '" + parameters.bodies[j].name + "' and '" +
                                     parameters.bodies[i].name +
                                     "' overlap at the start; move them apart.");
  }

  template void
  check_bodies(const ParameterRegister &, const ParameterInput<2> &, const Parameters<2> &);
  template void
  check_bodies(const ParameterRegister &, const ParameterInput<3> &, const Parameters<3> &);
} // namespace magmpm
