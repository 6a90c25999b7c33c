#include <magmpm/base/exceptions.h>
#include <magmpm/simulation/time_step_control.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  constexpr double dx       = 0.01;
  constexpr double no_frame = 1e9; ///< the next frame is far away

  TimeStepParameters
  adaptive()
  {
    TimeStepParameters parameters;
    parameters.elastic_factor = 0.4;
    parameters.viscous_factor = 0.12;
    parameters.force_factor   = 0.3;
    parameters.affine_factor  = 0.25;
    return parameters;
  }

  TimeStepParameters
  fixed(const double step, const bool allow_unstable)
  {
    TimeStepParameters parameters = adaptive();
    parameters.fixed_step         = step;
    parameters.allow_unstable     = allow_unstable;
    return parameters;
  }

  /** Steps until the frame at @p interval is met exactly; checks that none is a sliver. */
  int
  steps_of_a_frame(const TimeStepControl &control,
                   const StepConditions &conditions,
                   const double interval,
                   const double least)
  {
    double time = 0.;
    int n       = 0;
    while (time < (1. - 1e-9) * interval && n < 1000)
      {
        const TimeStep step = control.next_step(conditions, time, interval);
        CHECK(step.length >= least);
        time += step.length;
        ++n;
      }
    CHECK(time == Approx(interval).epsilon(1e-12));
    return n;
  }
} // namespace

TEST_CASE("each limit of the time step binds in turn", "[simulation]")
{
  // Conditions of which one limits the step, with the formula of the header worked out by hand. The
  // others are set such that they allow twice the step.
  const TimeStepControl control(adaptive(), dx);
  const StepConditions lax = {
    0.2, // elastic: 0.4 dx/0.2 = 0.02
    0.,
    0.,   //
    6e-4, // viscous: 0.12 dx^2/6e-4 = 0.02
    2.25, // force: 0.3 sqrt(dx/2.25) = 0.02
    12.5  // affine: 0.25/12.5 = 0.02
  };
  const auto check = [&](const StepConditions &conditions, const std::string &limit) {
    const TimeStep step = control.next_step(conditions, 0., no_frame);
    CHECK(step.limit == limit);
    CHECK(step.length == Approx(0.01).epsilon(1e-12));
  };
  StepConditions conditions = lax;
  conditions.signal_speed   = 0.4;
  check(conditions, "elastic");
  conditions                     = lax;
  conditions.magnetic_wave_speed = 0.2; // adds to the signal
  check(conditions, "elastic");
  conditions                = lax;
  conditions.collider_speed = 0.4; // alone
  check(conditions, "elastic");
  conditions                     = lax;
  conditions.kinematic_viscosity = 1.2e-3;
  check(conditions, "viscous");
  conditions              = lax;
  conditions.acceleration = 9.;
  check(conditions, "force");
  conditions                 = lax;
  conditions.affine_velocity = 25.;
  check(conditions, "affine");

  TimeStepParameters bounded = adaptive();
  bounded.maximum            = 0.01;
  const TimeStep step        = TimeStepControl(bounded, dx).next_step(lax, 0., no_frame);
  CHECK(step.limit == "maximum");
  CHECK(step.length == 0.01);
}

TEST_CASE("without anything that moves the next frame is the only limit", "[simulation]")
{
  // All conditions zero, as for a body at rest without a wave speed: no limit divides by zero, and
  // the step is the way to the frame.
  const TimeStep step = TimeStepControl(adaptive(), dx).next_step(StepConditions(), 0., 0.125);
  CHECK(step.limit == "frame end");
  CHECK(step.length == 0.125);
}

TEST_CASE("adaptive steps meet frames without slivers", "[simulation]")
{
  // Stable steps of 0.01 towards frames at 0.1, at 0.1 plus a thousandth of a step, and short of it.
  // The last two steps share what is left, so none is shorter than half a step.
  const TimeStepControl control(adaptive(), dx);
  StepConditions conditions;
  conditions.signal_speed = 0.4;
  CHECK(steps_of_a_frame(control, conditions, 0.1, 0.0099999) == 10);
  CHECK(steps_of_a_frame(control, conditions, 0.10001, 0.005) == 11);
  CHECK(steps_of_a_frame(control, conditions, 0.09999, 0.005) == 10);
  CHECK(steps_of_a_frame(control, conditions, 0.095, 0.005) == 10);
  CHECK(steps_of_a_frame(control, conditions, 0.0031, 0.0031) == 1);

  // Which limit bound is said: the frame only where it shortened the step.
  CHECK(control.next_step(conditions, 0., 0.0200001).limit == "elastic");
  const TimeStep half = control.next_step(conditions, 0., 0.016);
  CHECK(half.limit == "frame end");
  CHECK(half.length == Approx(0.008).epsilon(1e-12));
  const TimeStep last = control.next_step(conditions, 0., 0.008);
  CHECK(last.limit == "frame end");
  CHECK(last.length == 0.008);
}

TEST_CASE("a fixed step is fixed, and only cut to meet a frame", "[simulation]")
{
  // Steps of 5e-5 in frames of 2 ms: 40 of them, as in the paper, although the sum of 39 steps has
  // been rounded. In frames that are no multiple the last step is what is left, and says so.
  const TimeStepControl control(fixed(5e-5, true), dx);
  StepConditions conditions;
  conditions.signal_speed = 1e9; // would limit any other step
  CHECK(steps_of_a_frame(control, conditions, 2e-3, 4.9999e-5) == 40);
  CHECK(control.next_step(conditions, 0., 1.).length == 5e-5);
  CHECK(control.next_step(conditions, 0., 1.).limit == "fixed");
  CHECK(control.next_step(conditions, 0., 9e-5).length == 5e-5);
  CHECK(control.next_step(conditions, 0., 5e-5 * (1. - 1e-12)).limit == "fixed");

  const TimeStep rest = control.next_step(conditions, 0., 4e-5);
  CHECK(rest.length == 4e-5);
  CHECK(rest.limit == "frame end");
}

TEST_CASE("a fixed step beyond a limit is refused", "[simulation]")
{
  // A step of 0.01, which the conditions just allow (0.4 dx/0.4), is taken; twice that speed halves
  // the limit. At the start of a run the fault is in the input, later the run has come to it.
  const TimeStepControl control(fixed(0.01, false), dx);
  StepConditions conditions;
  conditions.signal_speed = 0.4;
  CHECK(control.next_step(conditions, 0., no_frame).length == 0.01);
  CHECK(control.next_step(conditions, 0., no_frame).limit == "fixed");
  conditions.signal_speed = 0.8;
  const std::string message =
    "s the given Time step/Time step (0.01 s) is longer than the elastic limit, 0.005 s: Elastic "
    "factor times dx/(c + |v|), c + |v| = 0.8 m/s, and 0 m/s of magnetic waves; a magnet moves at "
    "0 "
    "m/s. Take 'Time step = auto' or a shorter one in the section 'Time step', or, for a run that "
    "may go astray, 'Allow unstable time step = true'.";
  CHECK_THROWS_AS(control.next_step(conditions, 0., no_frame), InputError);
  CHECK_THROWS_AS(control.next_step(conditions, 2., no_frame), RunError);
  CHECK_THROWS_WITH(control.next_step(conditions, 0., no_frame), "at t = 0 " + message);
  CHECK_THROWS_WITH(control.next_step(conditions, 2., no_frame), "at t = 2 " + message);

  // Every other limit refuses too, with what it is made of.
  const auto says = [&](const std::string &part) {
    std::string text;
    try
      {
        control.next_step(conditions, 0., no_frame);
      }
    catch (const InputError &error)
      {
        text = error.what();
      }
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
    conditions = StepConditions();
  };
  says("c + |v| = 0.8 m/s");
  conditions.magnetic_wave_speed = 0.8;
  says("and 0.8 m/s of magnetic waves");
  conditions.collider_speed = 0.8;
  says("a magnet moves at 0.8 m/s");
  conditions.kinematic_viscosity = 2.4e-3;
  says("the viscous limit, 0.005 s: Viscous factor times rho dx^2/mu_N, mu_N/rho = 0.0024 m^2/s");
  conditions.acceleration = 36.;
  says("the force limit, 0.005 s: Force factor times sqrt(dx/|a|), |a| = 36 m/s^2");
  conditions.affine_velocity = 50.;
  says("the affine limit, 0.005 s: Affine factor over |C|, |C| = 50 1/s");
}
