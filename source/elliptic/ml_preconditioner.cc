#include <magmpm/elliptic/ml_preconditioner.h>

namespace magmpm
{
  template <int dim>
  MLPreconditioner<dim>::MLPreconditioner(const EllipticSpace<dim> &space)
    : assembler(space)
  {
    const auto &owned = space.dof_handler.locally_owned_dofs();
    system_matrix.reinit(owned, owned, assembler.sparsity_pattern(), space.mesh.communicator());
  }

  template <int dim>
  void
  MLPreconditioner<dim>::rebuild(const JacobianData<dim> &jacobian)
  {
    system_matrix = 0.;
    assembler.add_to(jacobian, system_matrix);
    system_matrix.compress(dealii::VectorOperation::add);

    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData parameters;
    parameters.elliptic              = true;
    parameters.higher_order_elements = true;
    parameters.smoother_type         = "Chebyshev";
    parameters.smoother_sweeps       = 2;
    parameters.aggregation_threshold = 0.02;
    parameters.coarse_type           = "Amesos-KLU";
    amg.clear();
    amg.initialize(system_matrix, parameters);
  }

  template <int dim>
  void
  MLPreconditioner<dim>::vmult(PotentialVector &dst, const PotentialVector &src) const
  {
    amg.vmult(dst, src);
  }

  template class MLPreconditioner<2>;
  template class MLPreconditioner<3>;
} // namespace magmpm
