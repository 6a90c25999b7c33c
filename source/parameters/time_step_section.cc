#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/time_step_section.h>

namespace magmpm
{
  void
  declare_time_step(ParameterRegister &declarations, TimeStepParameters &time_step)
  {
    const auto section = declarations.enter("Time step");
    declarations.add_or_auto("Time step",
                             time_step.fixed_step,
                             "s",
                             "dt of all steps; auto: each as long as the limits below allow.",
                             positive);
    declarations.add("Allow unstable time step",
                     time_step.allow_unstable,
                     "Whether a given dt may be longer than the limits below: such a run may go "
                     "astray. Otherwise it ends where a limit falls below dt.");
    declarations.add("Maximum",
                     time_step.maximum,
                     "s",
                     "With Time step = auto: dt is never longer; not given: no such limit.",
                     positive,
                     Presence::optional);
    declarations.add("Elastic factor",
                     time_step.elastic_factor,
                     "-",
                     "dt <= factor dx/(c + |v|), c the wave speed.",
                     positive);
    declarations.add(
      "Viscous factor", time_step.viscous_factor, "-", "dt <= factor rho dx^2/mu_N.", positive);
    declarations.add("Force factor",
                     time_step.force_factor,
                     "-",
                     "dt <= factor sqrt(dx/|a|), a the acceleration.",
                     positive);
    declarations.add("Affine factor",
                     time_step.affine_factor,
                     "-",
                     "dt <= factor/|C|, C the velocity gradient.",
                     positive);
    declarations.add("Capillary factor",
                     time_step.capillary_factor,
                     "-",
                     "dt <= factor sqrt(rho dx^3/gamma), of a fluid with surface tension.",
                     positive);
  }

  void
  check_time_step(const ParameterRegister &declarations,
                  const TimeStepParameters &step,
                  const double frame_interval)
  {
    if (step.fixed_step > 0.)
      check_given(declarations, "Time step", {}, {"Maximum"}, "a given Time step/Time step");
    if (step.fixed_step > frame_interval)
      throw declarations.error("Time step/Time step",
                               "it must not be longer than Output/Frame interval (" +
                                 to_text(frame_interval) + " s).");
  }
} // namespace magmpm
