#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/parameter_names.h>
#include <magmpm/parameters/section_validation.h>

#include <algorithm>
#include <cstdlib>

namespace magmpm
{
  namespace
  {
    /** The number that a text is, if it is one above zero, otherwise 0. */
    double
    positive_number(const std::string &text)
    {
      char *end           = nullptr;
      const double number = std::strtod(text.c_str(), &end);
      return (end != text.c_str() && *end == '\0' && number > 0. && number < 1e300) ? number : 0.;
    }

    template <int dim>
    void
    check_names(const ParameterRegister &declarations,
                const std::vector<std::string> &names,
                const std::vector<std::string> &body_names)
    {
      for (const std::string &name : names)
        if (std::find(body_names.begin(), body_names.end(), name) == body_names.end())
          throw declarations.error("Attraction/Bodies",
                                   "there is no body '" + name + "'. Bodies/List of bodies is '" +
                                     comma_separated(body_names) + "'" +
                                     did_you_mean(name, body_names));
    }
  } // namespace

  template <int dim>
  void
  convert_attraction(const ParameterRegister &declarations,
                     const ParameterInput<dim> &input,
                     Parameters<dim> &parameters)
  {
    PointAttraction<dim> &attraction = parameters.attraction;
    const std::string strength       = "Attraction/Strength";
    if (!declarations.given(strength))
      {
        check_given(declarations, "Attraction", {}, {"Point"}, "an Attraction without Strength");
        return;
      }
    attraction.matches_magnets = (input.attraction_strength == "match magnets");
    attraction.acceleration    = positive_number(input.attraction_strength);
    if (!attraction.is_wanted())
      throw declarations.error(strength,
                               "must be a number > 0 [m/s^2], or 'match magnets'. To have none, "
                               "remove this line.");
    check_given(declarations, "Attraction", {"Point"}, {}, "an Attraction");
    if (attraction.core_radius == 0.)
      attraction.core_radius = parameters.lattice.spacing;
    check_names<dim>(declarations, attraction.bodies, input.body_names);
    if (!attraction.matches_magnets)
      return;
    if (!parameters.mesh.carries_potential || parameters.sources.empty())
      throw declarations.error(strength,
                               parameters.sources.empty()
                                 ? "there are no magnets to match. Give the acceleration."
                                 : "no body is magnetic, so that magnets exert no force. Give the "
                                   "acceleration.");
    parameters.output.write_fields = false; // there will be none
  }

  template <int dim>
  void
  check_rest(const ParameterRegister &declarations, const Parameters<dim> &parameters)
  {
    const std::vector<std::string> limits = {"Speed", "Time"};
    if (parameters.rest.stops)
      check_given(declarations, "Rest", limits, {}, "Stop when at rest = true");
    else
      check_given(declarations, "Rest", {}, limits, "Stop when at rest = false");
  }

#define INSTANTIATE(dim)                                                        \
  template void convert_attraction(                                             \
    const ParameterRegister &, const ParameterInput<dim> &, Parameters<dim> &); \
  template void check_rest(const ParameterRegister &, const Parameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
