#pragma once

#include <magmpm/elliptic/elliptic_preconditioner.h>

namespace magmpm
{
  /**
   * Geometric multigrid with local smoothing on the levels of the mesh, in single precision: a V-cycle
   * of Chebyshev smoothers (degree 5) around EllipticOperator, down to the root cells of the box. Seven
   * to nine iterations where K is from 2 to 100, eighteen at 1000.
   *
   * The coefficient of active cells is their own. In each octant of a coarser cell it is a mean over the
   * octants of the child there, half the arithmetic and half the harmonic one: surfaces then stay in place
   * on all levels.
   */
  template <int dim>
  class MultigridPreconditioner : public EllipticPreconditioner<dim>
  {
  public:
    explicit MultigridPreconditioner(const EllipticSpace<dim> &space);
    ~MultigridPreconditioner() override;

    void
    rebuild(const JacobianData<dim> &jacobian) override;

    void
    vmult(PotentialVector &dst, const PotentialVector &src) const override;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace magmpm
