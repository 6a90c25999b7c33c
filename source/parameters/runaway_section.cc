#include <magmpm/parameters/runaway_section.h>

namespace magmpm
{
  void
  declare_runaway_limits(ParameterRegister &declarations, RunawayLimits &limits)
  {
    const auto section = declarations.enter("Runaway limits");
    declarations.add("Minimum volume ratio",
                     limits.min_volume_ratio,
                     "-",
                     "A particle with a J below this has failed the run.",
                     {0., 1., false, true});
    declarations.add("Maximum volume ratio",
                     limits.max_volume_ratio,
                     "-",
                     "A particle with a J above this has failed the run.",
                     {1., any_number.maximum, true, false});
    declarations.add(
      "Maximum speed ratio",
      limits.max_speed_ratio,
      "-",
      "A particle faster than this, times the wave speed of its undeformed material, "
      "has failed the run.",
      positive);
  }
} // namespace magmpm
