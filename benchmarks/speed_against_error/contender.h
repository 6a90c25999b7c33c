#pragma once

#include <magmpm/magnetics/magnetics_parameters.h>

#include <baselines/paper_scheme/paper_scheme.h>

#include <speed_against_error/experiment.h>

#include <functional>

namespace magmpm::benchmarks
{
  /** What one solve took. */
  struct SolveCost
  {
    double seconds    = 0.; ///< of one core, the whole magnetic part
    int newton_steps  = 0;
    int cg_iterations = 0;
  };

  /** What one run of a contender took and found. */
  struct Outcome
  {
    SolveCost cold; ///< from the particles, with everything set up, to the force on the nodes
    SolveCost warm; ///< the same after the body has moved by 0.1 dx, with what is left from before
    unsigned long long n_unknowns = 0;
    MagneticState state; ///< before it moved
  };

  enum class Scheme
  {
    magmpm,
    paper,     ///< as it is, with Neumann faces
    paper_open ///< with the open faces that it does not have in the paper
  };

  inline constexpr Scheme all_schemes[] = {Scheme::magmpm, Scheme::paper, Scheme::paper_open};

  inline const char *
  to_string(const Scheme scheme)
  {
    constexpr const char *names[] = {"magmpm", "paper", "paper with open faces"};
    return names[static_cast<int>(scheme)];
  }

  /** A scheme with all its choices made. */
  struct Contender
  {
    Scheme scheme;
    std::string name;
    std::function<Outcome(const Experiment &)> run;
    double coarsest = 0.; ///< R/dx that its box has room for
  };

  /**
   * magmpm in a potential box of 8 R or more, with open faces. Cold: mesh, distribution and
   * sorting of particles, function space, preconditioner, solve, force, its way to the particles.
   * Warm: P2G, indicator, solve, force.
   *
   * @param tolerance  of Newton's method, relative to the residual at zero potential.
   */
  Contender
  magmpm_contender(const Preconditioner preconditioner,
                   const int cell_edge,
                   const MaterialIndicator indicator,
                   const double tolerance);

  /**
   * The paper's scheme with its fastest preconditioner. Cold: memory, P2G, solve from zero, force.
   * Warm: P2G, solve from the last potential, force.
   *
   * @param half_width  of the box, in radii.
   */
  Contender
  paper_contender(const paper_scheme::BoxFaces faces,
                  const double half_width,
                  const double tolerance);
} // namespace magmpm::benchmarks
