#include <magmpm/coupling/force_moments.h>
#include <magmpm/simulation/scene.h>

#include <verification/mechanics/carried_force_errors.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    template <int dim>
    Matrix<dim>
    skew_part(const Matrix<dim> &matrix)
    {
      Matrix<dim> skew;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          skew(i, j) = 0.5 * (matrix(i, j) - matrix(j, i));
      return skew;
    }

    void
    add_error(const double error, CarriedForceErrors::Measure &measure)
    {
      measure.worst = std::max(measure.worst, error);
      measure.rms += error * error;
    }

    template <int dim>
    void
    compare(const ForceMoments<dim> &carried,
            const ForceMoments<dim> &solved,
            CarriedForceErrors &errors)
    {
      const Matrix<dim> difference = carried.virial() + (-1.) * solved.virial();
      const Matrix<dim> skew       = skew_part(difference);
      const double size            = frobenius_norm(solved.virial());
      add_error(norm(carried.force - solved.force) /
                  std::max(norm(solved.force), 0.1 * solved.size),
                errors.force);
      add_error(frobenius_norm(skew) / size, errors.torque);
      add_error(frobenius_norm(difference + (-1.) * skew) / size, errors.virial);
      ++errors.n_compared;
    }
  } // namespace

  template <int dim>
  CarriedForceErrors
  carried_force_errors(const Parameters<dim> &parameters,
                       const double end_time,
                       const unsigned int interval)
  {
    Parameters<dim> solving       = parameters;
    solving.solve_trigger.trigger = SolveTriggerParameters::Trigger::every_step;
    Scene<dim> scene(parameters, MPI_COMM_WORLD), other(solving, MPI_COMM_WORLD);
    scene.begin();
    CarriedForceErrors errors;
    while (scene.time() < end_time)
      {
        ++errors.n_steps;
        if (errors.n_steps % interval != 0)
          {
            scene.step({end_time, false, {}});
            continue;
          }
        const std::vector<Section> sections = scene.save();
        other.load(sections, [&](std::vector<Body<dim>> &bodies) { bodies = scene.bodies(); });
        scene.step({end_time, false, {}});
        other.step({end_time, false, {}});
        compare(force_moments(scene.bodies(), parameters.lattice, MPI_COMM_WORLD),
                force_moments(other.bodies(), parameters.lattice, MPI_COMM_WORLD),
                errors);
      }
    errors.n_solves = scene.magnetics().state().n_solves;
    for (CarriedForceErrors::Measure *measure : {&errors.force, &errors.torque, &errors.virial})
      measure->rms = std::sqrt(measure->rms / std::max(1U, errors.n_compared));
    return errors;
  }

  template CarriedForceErrors
  carried_force_errors(const Parameters<2> &, const double, const unsigned int);
  template CarriedForceErrors
  carried_force_errors(const Parameters<3> &, const double, const unsigned int);
} // namespace magmpm::verification
