#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>

#include <string>

namespace magmpm
{
  /**
   * Fills a body's shape with particles: n per edge of each lattice cell, regular or jittered, each
   * with the volume dx^dim/n^dim and at rest or in the body's motion. Of a list of points each becomes
   * a particle, with the volume in the file or else that one. Positions, jitter and ids are
   * functions of the place on the lattice or in the list alone; ranks share the work by rows, so that
   * all of them together seed the same particles whatever their number.
   *
   * @param body_number  makes ids of different bodies different.
   * @throw InputError   if the shape cannot be made (make_shape()).
   */
  template <int dim>
  void
  seed_particles(const BodyParameters<dim> &parameters,
                 const Lattice<dim> &lattice,
                 const unsigned int body_number,
                 const unsigned int rank,
                 const unsigned int n_ranks,
                 Body<dim> &body);
} // namespace magmpm
