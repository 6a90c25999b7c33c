#include <magmpm/parameters/attraction_section.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/parameter_names.h>

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
  declare_attraction(ParameterRegister &declarations, PointAttraction<dim> &attraction)
  {
    const auto section = declarations.enter("Attraction");
    declarations.add_text(
      "Strength",
      "",
      "m/s^2",
      "Acceleration g0 of an artificial force towards a point, g0 (r0/r)^p, r the "
      "distance from it; or 'match magnets': as much as makes the total force at "
      "the start equal to that of the magnets, which do not act then. Not given: "
      "there is none.");
    declarations.add("Point", attraction.point, "m", "Where it draws to.", Presence::optional);
    declarations.add("Reference distance",
                     attraction.reference_distance,
                     "m",
                     "r0, the distance from the point where the acceleration is g0.",
                     positive);
    declarations.add("Exponent", attraction.exponent, "-", "p.", {-8., 8.});
    declarations.add_or_auto("Core radius",
                             attraction.core_radius,
                             "m",
                             "Within this distance from the point the acceleration falls linearly "
                             "to zero; auto: dx.",
                             positive);
    declarations.add(
      "Bodies", attraction.bodies, {}, "Names of the bodies that it acts on; empty: all.");
  }

  template <int dim>
  void
  convert_attraction(const ParameterRegister &declarations,
                     const AttractionSetting &setting,
                     PointAttraction<dim> &attraction)
  {
    const std::string strength = "Attraction/Strength";
    if (!declarations.given(strength))
      {
        check_given(declarations, "Attraction", {}, {"Point"}, "an Attraction without Strength");
        return;
      }
    const std::string &given   = declarations.value(strength);
    attraction.matches_magnets = (given == "match magnets");
    attraction.acceleration    = positive_number(given);
    if (!attraction.is_wanted())
      throw declarations.error(strength,
                               "must be a number > 0 [m/s^2], or 'match magnets'. To have none, "
                               "remove this line.");
    check_given(declarations, "Attraction", {"Point"}, {}, "an Attraction");
    if (attraction.core_radius == 0.)
      attraction.core_radius = setting.spacing;
    check_names(declarations, attraction.bodies, setting.body_names);
    if (attraction.matches_magnets && !(setting.has_potential && setting.has_magnets))
      throw declarations.error(strength,
                               !setting.has_magnets
                                 ? "there are no magnets to match. Give the acceleration."
                                 : "no body is magnetic, so that magnets exert no force. Give the "
                                   "acceleration.");
  }

#define INSTANTIATE(dim)                                                         \
  template void declare_attraction(ParameterRegister &, PointAttraction<dim> &); \
  template void convert_attraction(                                              \
    const ParameterRegister &, const AttractionSetting &, PointAttraction<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
