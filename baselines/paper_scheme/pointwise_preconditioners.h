#pragma once

#include <baselines/paper_scheme/potential_stencil.h>

namespace magmpm::paper_scheme
{
  /** None: z = r. */
  class IdentityPreconditioner
  {
  public:
    /** @return r.z */
    double
    apply(const NodeVector &r_vector, NodeVector &z_vector) const
    {
      const double *const r = r_vector.data();
      double *const z       = z_vector.data();
      double product        = 0.;
#pragma omp simd reduction(+ : product)
      for (std::ptrdiff_t i = 0; i < r_vector.size(); ++i)
        {
          z[i] = r[i];
          product += r[i] * r[i];
        }
      return product;
    }
  };

  /** Jacobi: z = r over the diagonal. */
  class JacobiPreconditioner
  {
  public:
    template <int dim>
    void
    reinit(const PotentialStencil<dim> &jacobian)
    {
      inverse.reinit(jacobian.node_grid().size(), 0);
      jacobian.compute_diagonal(inverse);
      for (std::ptrdiff_t i = 0; i < inverse.size(); ++i)
        inverse[i] = 1. / inverse[i];
    }

    /** @return r.z */
    double
    apply(const NodeVector &r_vector, NodeVector &z_vector) const
    {
      const double *const r = r_vector.data();
      const double *const d = inverse.data();
      double *const z       = z_vector.data();
      double product        = 0.;
#pragma omp simd reduction(+ : product)
      for (std::ptrdiff_t i = 0; i < inverse.size(); ++i)
        {
          z[i] = d[i] * r[i];
          product += r[i] * z[i];
        }
      return product;
    }

  private:
    NodeVector inverse;
  };
} // namespace magmpm::paper_scheme
