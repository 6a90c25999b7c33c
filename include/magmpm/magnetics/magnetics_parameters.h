#pragma once

#include <magmpm/materials/magnetization.h>

#include <array>

namespace magmpm
{
  enum class Preconditioner
  {
    gmg,  ///< geometric multigrid on deal.II's MatrixFree
    ml,   ///< algebraic multigrid on the assembled matrix: Trilinos ML, on Epetra
    muelu ///< the same: Trilinos MueLu, with matrix and CG on Tpetra
  };

  /** What counts as material at a point. */
  enum class MaterialIndicator
  {
    sharp, ///< a volume fraction that falls from 1 to 0 at the surface, and a laminate in cut cells
    smeared ///< the grain density that the particles spread on the lattice, as in the paper
  };

  /** How the potential problem is posed and solved. */
  template <int dim>
  struct MagneticsParameters
  {
    MagnetizationLaw law = MagnetizationLaw::langevin;
    std::shared_ptr<const MagnetizationCurve> curve; ///< of the law table
    MaterialIndicator indicator   = MaterialIndicator::sharp;
    Preconditioner preconditioner = Preconditioner::gmg;
    double newton_tolerance       = 1e-10; ///< of the residual, relative to that of zero potential
    int max_newton_steps          = 25;
    int max_cg_iterations         = 500;

    /** Shielded faces (-x, +x, -y, ...): natural condition; the others are open (Robin). */
    std::array<bool, 2 *dim> shielded = {};

    MagnetizationModel
    model() const
    {
      return {law, curve};
    }
  };
} // namespace magmpm
