#include <magmpm/elliptic/ml_preconditioner.h>
#include <magmpm/elliptic/muelu_solver.h>
#include <magmpm/elliptic/multigrid_preconditioner.h>
#include <magmpm/elliptic/potential_solver.h>

namespace magmpm
{
  template <int dim>
  std::unique_ptr<PotentialSolver<dim>>
  make_potential_solver(const Preconditioner type, const PotentialSpace<dim> &space)
  {
    switch (type)
      {
        case Preconditioner::ml:
          return std::make_unique<MLPreconditioner<dim>>(space);
        case Preconditioner::muelu:
          return std::make_unique<MueLuSolver<dim>>(space);
        case Preconditioner::gmg:
          break;
      }
    return std::make_unique<MultigridPreconditioner<dim>>(space);
  }

  template std::unique_ptr<PotentialSolver<2>>
  make_potential_solver(const Preconditioner, const PotentialSpace<2> &);
  template std::unique_ptr<PotentialSolver<3>>
  make_potential_solver(const Preconditioner, const PotentialSpace<3> &);
} // namespace magmpm
