#include <magmpm/magnetics/ml_preconditioner.h>
#include <magmpm/magnetics/multigrid_preconditioner.h>

namespace magmpm
{
  template <int dim>
  std::unique_ptr<PotentialPreconditioner<dim>>
  make_preconditioner(const Preconditioner type, const PotentialSpace<dim> &space)
  {
    if (type == Preconditioner::ml)
      return std::make_unique<MLPreconditioner<dim>>(space);
    return std::make_unique<MultigridPreconditioner<dim>>(space);
  }

  template std::unique_ptr<PotentialPreconditioner<2>>
  make_preconditioner(const Preconditioner, const PotentialSpace<2> &);
  template std::unique_ptr<PotentialPreconditioner<3>>
  make_preconditioner(const Preconditioner, const PotentialSpace<3> &);
} // namespace magmpm
