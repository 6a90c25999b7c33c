#include <magmpm/base/number_text.h>
#include <magmpm/simulation/rest_check.h>

namespace magmpm
{
  void
  RestCheck::note_speed(const double mean_square_speed, RunState &state) const
  {
    if (!(mean_square_speed < parameters.speed * parameters.speed))
      state.rest_since = -1.;
    else if (state.rest_since < 0.)
      state.rest_since = state.time;
  }

  bool
  RestCheck::is_over(const RunState &state) const
  {
    return parameters.stops && state.rest_since >= 0. &&
           state.time - state.rest_since >= parameters.duration;
  }

  std::string
  RestCheck::reason() const
  {
    return "all material is at rest: slower than " + with_prefix(parameters.speed, "m/s") +
           " (root mean square) for " + with_prefix(parameters.duration, "s");
  }
} // namespace magmpm
