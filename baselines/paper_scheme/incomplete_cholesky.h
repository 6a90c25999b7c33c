#pragma once

#include <baselines/paper_scheme/potential_stencil.h>

namespace magmpm::paper_scheme
{
  /**
   * Incomplete Cholesky factors without fill, (D + L) D^-1 (D + L^T), of the seven-point part of
   * the Jacobian (all of it for isotropic dM/dH; the products of two axes that anisotropy adds are
   * left to CG). L is that of the matrix itself, so only D is stored.
   *
   * Modified: the fraction @p modification of the fill that is left away goes to the diagonal,
   * which turns the O(n) iterations of the plain factors (n nodes along an edge) into O(sqrt(n)). A
   * pivot below a quarter of the diagonal is replaced by the diagonal (Bridson 2015), as happens to
   * the last pivots of each sublattice of a singular matrix.
   */
  template <int dim>
  class IncompleteCholesky
  {
  public:
    explicit IncompleteCholesky(const NodeGrid<dim> &grid);

    void
    reinit(const PotentialStencil<dim> &jacobian, const double modification);

    /** @return r.z */
    double
    apply(const NodeVector &r, NodeVector &z) const;

  private:
    const NodeGrid<dim> grid;
    const CoefficientRows<dim> *rows = nullptr;
    NodeVector inverse; ///< of D
    mutable std::vector<double> chain;

    void
    factorize_line(const std::ptrdiff_t line,
                   const double modification,
                   const NodeVector &diagonal);

    void
    substitute_forward(const NodeVector &r, NodeVector &z) const;
    double
    substitute_backward(const NodeVector &r, NodeVector &z) const;
  };
} // namespace magmpm::paper_scheme
