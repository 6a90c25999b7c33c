#pragma once

#include <magmpm/parameters/parameters.h>

namespace magmpm::verification
{
  /**
   * How far the magnetic force that particles carry between solves is from that of a solve in the same step,
   * over some of the steps of a run: of the sum of the force over its size, or over a tenth of the sum of the sizes
   * where forces cancel, of torque and virial about the centre of mass over the Frobenius norm of sum f x^T.
   */
  struct CarriedForceErrors
  {
    struct Measure
    {
      double worst = 0., rms = 0.;
    };

    Measure force, torque, virial;
    unsigned int n_steps = 0, n_solves = 0; ///< of the run, without those that it is compared with
    unsigned int n_compared = 0;
  };

  /**
   * Runs a scene. At every @p interval -th step another scene takes the same step from the same state, but
   * solves for it. Collective.
   */
  template <int dim>
  CarriedForceErrors
  carried_force_errors(const Parameters<dim> &parameters,
                       const double end_time,
                       const unsigned int interval);
} // namespace magmpm::verification
