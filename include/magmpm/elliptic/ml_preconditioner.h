#pragma once

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <magmpm/elliptic/elliptic_preconditioner.h>
#include <magmpm/elliptic/jacobian_assembler.h>

namespace magmpm
{
  /**
   * Smoothed aggregation (Trilinos ML) on the assembled Jacobian, Chebyshev smoother. 15 to 18
   * iterations where K is from 2 to 1000; seven times the memory of multigrid.
   */
  template <int dim>
  class MLPreconditioner : public EllipticPreconditioner<dim>
  {
  public:
    explicit MLPreconditioner(const EllipticSpace<dim> &space);

    void
    rebuild(const JacobianData<dim> &jacobian) override;

    void
    vmult(PotentialVector &dst, const PotentialVector &src) const override;

    /** The Jacobian of the last rebuild(). */
    const dealii::TrilinosWrappers::SparseMatrix &
    matrix() const
    {
      return system_matrix;
    }

  private:
    const JacobianAssembler<dim> assembler;
    dealii::TrilinosWrappers::SparseMatrix system_matrix;
    dealii::TrilinosWrappers::PreconditionAMG amg;
  };
} // namespace magmpm
