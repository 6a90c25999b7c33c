#include <magmpm/base/number_text.h>
#include <magmpm/simulation/rest_check.h>

namespace magmpm
{
  void
  RestCheck::note_speed(const double mean_square_speed, const double time)
  {
    if (!(mean_square_speed < parameters.speed * parameters.speed))
      since = -1.;
    else if (since < 0.)
      since = time;
  }

  bool
  RestCheck::is_over(const double time) const
  {
    return parameters.stops && since >= 0. && time - since >= parameters.duration;
  }

  std::string
  RestCheck::reason() const
  {
    return "all material is at rest: slower than " + with_prefix(parameters.speed, "m/s") +
           " (root mean square) for " + with_prefix(parameters.duration, "s");
  }
} // namespace magmpm
