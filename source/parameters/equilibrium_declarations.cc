#include <magmpm/parameters/parameter_sections.h>

namespace magmpm
{
  template <int dim>
  void
  declare_attraction(ParameterRegister &declarations,
                     ParameterInput<dim> &input,
                     PointAttraction<dim> &attraction)
  {
    const auto section = declarations.enter("Attraction");
    declarations.add("Strength",
                     input.attraction_strength,
                     "m/s^2",
                     "Acceleration g0 of an artificial force towards a point, g0 (r0/r)^p, r the "
                     "distance from it; or 'match magnets': as much as makes the total force at "
                     "the start equal to that of the magnets, which do not act then. Not given: "
                     "there is none.",
                     Presence::optional);
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

  void
  declare_rest(ParameterRegister &declarations, RestParameters &rest)
  {
    const auto section = declarations.enter("Rest");
    declarations.add(
      "Damping rate",
      rest.damping_rate,
      "1/s",
      "Takes speed away from all material, dv/dt = -rate v, to reach an equilibrium.",
      not_negative);
    declarations.add(
      "Stop when at rest",
      rest.stops,
      "Whether the run ends, with a last frame, when all material has come to rest.");
    declarations.add("Speed",
                     rest.speed,
                     "m/s",
                     "With Stop when at rest: material is at rest while the root mean square of "
                     "its speed, by mass, is below this ..",
                     positive,
                     Presence::optional);
    declarations.add("Time", rest.duration, "s", ".. for so long.", positive, Presence::optional);
  }

  template void
  declare_attraction(ParameterRegister &, ParameterInput<2> &, PointAttraction<2> &);
  template void
  declare_attraction(ParameterRegister &, ParameterInput<3> &, PointAttraction<3> &);
} // namespace magmpm
