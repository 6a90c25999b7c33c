#pragma once

#include <magmpm/base/exceptions.h>

#include <baselines/paper_scheme/potential_stencil.h>

#include <string>

namespace magmpm::paper_scheme
{
  namespace internal
  {
    /** r -= alpha q. @return |r| */
    double
    update_residual(const double alpha, const NodeVector &q, NodeVector &r);

    /** x += alpha p, then p = z + beta p, in one pass over the memory. */
    void
    update_solution_and_direction(const double alpha,
                                  const double beta,
                                  const NodeVector &z,
                                  NodeVector &x,
                                  NodeVector &p);
  } // namespace internal

  /** The vectors that CG works on, kept between solves. */
  struct ConjugateGradientsMemory
  {
    NodeVector r, z, p, q;
  };

  /**
   * Solves J x = b by preconditioned conjugate gradients from x = 0. If J is singular, b must be
   * orthogonal to its null space; x then has a component in it that means nothing, and that the
   * caller removes.
   *
   * @param tolerance  on |b - J x|, relative to |b|.
   * @return iterations.
   * @throw RunError if @p max_iterations do not suffice.
   */
  template <int dim, typename Preconditioner>
  int
  conjugate_gradients(const PotentialStencil<dim> &jacobian,
                      const Preconditioner &preconditioner,
                      const NodeVector &b,
                      const double tolerance,
                      const int max_iterations,
                      ConjugateGradientsMemory &memory,
                      NodeVector &x)
  {
    NodeVector &r = memory.r, &z = memory.z, &p = memory.p, &q = memory.q;
    x.reinit(b);
    r                  = b;
    const double limit = tolerance * r.l2_norm();
    double r_z         = preconditioner.apply(r, z);
    p                  = z;
    for (int iteration = 1; iteration <= max_iterations; ++iteration)
      {
        const double alpha = r_z / jacobian.apply(p, q);
        const double norm  = internal::update_residual(alpha, q, r);
        if (norm <= limit)
          {
            x.add(alpha, p);
            return iteration;
          }
        const double previous = r_z;
        r_z                   = preconditioner.apply(r, z);
        internal::update_solution_and_direction(alpha, r_z / previous, z, x, p);
      }
    throw RunError("The linear system of the paper's scheme was not solved in " +
                   std::to_string(max_iterations) + " iterations of CG.");
  }
} // namespace magmpm::paper_scheme
