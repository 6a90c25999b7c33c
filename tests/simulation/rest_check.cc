#include "catch.h"

#include <magmpm/simulation/rest_check.h>

using namespace magmpm;

TEST_CASE("rest must last to end a run", "[simulation]")
{
  // Slower than 0.1 m/s from t = 1 on, for 0.5 s; a moment of speed in between begins it anew.
  RestParameters parameters;
  parameters.stops    = true;
  parameters.speed    = 0.1;
  parameters.duration = 0.5;
  RestCheck rest(parameters);
  const auto look = [&](const double time, const double speed) {
    rest.note_speed(speed * speed, time);
    return rest.is_over(time);
  };
  CHECK_FALSE(look(0.9, 0.2));
  CHECK_FALSE(look(1., 0.09));
  CHECK_FALSE(look(1.4, 0.));
  CHECK_FALSE(look(1.45, 0.1)); // not below
  CHECK_FALSE(look(1.6, 0.05));
  CHECK_FALSE(look(2., 0.05));
  CHECK(look(2.1, 0.05));

  // Whoever does not ask for it does not get it, and nobody looks.
  CHECK_FALSE(RestCheck(RestParameters()).is_over(2.1));
  CHECK(rest.is_due(10));
  CHECK_FALSE(RestCheck(RestParameters()).is_due(10));
  CHECK_FALSE(rest.is_due(11));
}
