#include <magmpm/elliptic/elliptic_solver.h>
#include <magmpm/elliptic/ml_preconditioner.h>
#include <magmpm/elliptic/muelu_solver.h>
#include <magmpm/elliptic/multigrid_preconditioner.h>

namespace magmpm
{
  template <int dim>
  std::unique_ptr<EllipticSolver<dim>>
  make_elliptic_solver(const Preconditioner type, const EllipticSpace<dim> &space)
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

  template std::unique_ptr<EllipticSolver<2>>
  make_elliptic_solver(const Preconditioner, const EllipticSpace<2> &);
  template std::unique_ptr<EllipticSolver<3>>
  make_elliptic_solver(const Preconditioner, const EllipticSpace<3> &);
} // namespace magmpm
