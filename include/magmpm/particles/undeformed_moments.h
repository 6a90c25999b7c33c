#pragma once

#include <magmpm/geometry/region_moments.h>
#include <magmpm/particles/particle_set.h>

namespace magmpm
{
  /**
   * Undeformed volume of this rank's particles of a body and its moments, each particle taken as a point.
   *
   * @param origin  about which [m]; near the body little cancels.
   */
  template <int dim>
  RegionMoments<dim>
  undeformed_moments(const ParticleSet<dim> &particles, const Vector<dim> &origin);
} // namespace magmpm
