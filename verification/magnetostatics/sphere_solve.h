#pragma once

#include <verification/magnetostatics/sampled_setup.h>
#include <verification/magnetostatics/sources.h>

#include <string>

namespace magmpm::verification
{
  inline const char *
  to_string(const Preconditioner preconditioner)
  {
    return preconditioner == Preconditioner::gmg  ? "GMG"
           : preconditioner == Preconditioner::ml ? "ML"
                                                  : "MueLu";
  }

  inline constexpr Preconditioner all_preconditioners[] = {Preconditioner::gmg,
                                                           Preconditioner::ml,
                                                           Preconditioner::muelu};

  /** One linear system, solved to 1e-8 of its right hand side from zero. */
  struct SphereSolve
  {
    NewtonReport newton;
    unsigned long long n_unknowns;
    double set_up_seconds; ///< of mesh dependent tables, matrix and preconditioner, on this rank
    double cg_seconds;
  };

  /**
   * A sphere (cylinder in 2D) of the linear law in a uniform field, radius @p radius_in_cells dx, in the
   * middle of an open box 32 times as wide as the radius: cells grow by 2^5 towards its faces.
   */
  template <int dim>
  SphereSolve
  solve_sphere(const Preconditioner preconditioner,
               const double susceptibility,
               const int radius_in_cells = 8)
  {
    constexpr double spacing = 0.01;
    MagneticsParameters<dim> parameters;
    parameters.law                     = MagnetizationLaw::linear;
    parameters.solver.preconditioner   = preconditioner;
    parameters.solver.newton_tolerance = 2e-8; // a linear system is solved to half of it
    SampledSetup<dim> setup(4 * radius_in_cells, spacing, 8., parameters);

    Vector<dim> centre, field;
    for (int d = 0; d < dim; ++d)
      centre[d] = spacing * (2. * radius_in_cells + 0.13 * (d + 1));
    setup.set_bodies({sphere<dim>(centre, spacing * radius_in_cells, {1e6, susceptibility})}, 3);
    field[0]       = 1e3;
    field[dim - 1] = 2e3;
    const SolveReport report =
      setup.problem.solve(setup.content, ExternalField<dim>({uniform_source<dim>(field)}));

    auto seconds = setup.timer.seconds();
    return {report.newton,
            report.n_unknowns,
            seconds["Set up potential"] + seconds["Solve potential: Jacobian"] +
              seconds["Solve potential: preconditioner"],
            seconds["Solve potential: CG"]};
  }
} // namespace magmpm::verification
