#pragma once

#include <magmpm/elliptic/elliptic_parameters.h>
#include <magmpm/materials/magnetization.h>

#include <array>

namespace magmpm
{
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
    MaterialIndicator indicator = MaterialIndicator::sharp;
    EllipticParameters solver;

    /** Shielded faces (-x, +x, -y, ...): natural condition; the others are open (Robin). */
    std::array<bool, 2 *dim> shielded = {};

    MagnetizationModel
    model() const
    {
      return {law, curve};
    }
  };
} // namespace magmpm
