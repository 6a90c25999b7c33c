#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/rest_section.h>

namespace magmpm
{
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

  void
  check_rest(const ParameterRegister &declarations, const RestParameters &rest)
  {
    const std::vector<std::string> limits = {"Speed", "Time"};
    if (rest.stops)
      check_given(declarations, "Rest", limits, {}, "Stop when at rest = true");
    else
      check_given(declarations, "Rest", {}, limits, "Stop when at rest = false");
  }
} // namespace magmpm
