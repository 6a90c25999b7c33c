#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <magmpm/magnetics/magnetics_parameters.h>
#include <magmpm/magnetics/open_boundary.h>
#include <magmpm/magnetics/potential_space.h>

#include <functional>
#include <memory>

namespace magmpm
{
  /** What the Jacobian is made of: see PotentialOperator. */
  template <int dim>
  struct JacobianData
  {
    /** The n_points<dim> tensors I + dM/dH of a lattice cell, or a null pointer without material. */
    std::function<const dealii::SymmetricTensor<2, dim> *(const unsigned int)> permeability;

    const OpenBoundary<dim> &boundary;
  };

  /** A symmetric positive definite approximation of the inverse of the Jacobian, for CG. */
  template <int dim>
  class PotentialPreconditioner
  {
  public:
    virtual ~PotentialPreconditioner() = default;

    /** Adapts to a Jacobian. Collective. */
    virtual void
    rebuild(const JacobianData<dim> &jacobian) = 0;

    virtual void
    vmult(PotentialVector &dst, const PotentialVector &src) const = 0;
  };

  /** The preconditioner that the parameters ask for, on one state of the mesh; to be rebuilt first. */
  template <int dim>
  std::unique_ptr<PotentialPreconditioner<dim>>
  make_preconditioner(const Preconditioner type, const PotentialSpace<dim> &space);
} // namespace magmpm
