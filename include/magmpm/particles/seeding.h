#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>

#include <functional>
#include <string>
#include <vector>

namespace magmpm
{
  /** What no particle may lie in: the nearest point of a rigid body's surface, in the world. */
  template <int dim>
  using Obstacle = std::function<SurfaceDistance<dim>(const Vector<dim> &)>;

  /**
   * Fills a body's shape with particles, at rest or in the body's motion, n^dim (or, face-centred, half as
   * many) for the part of the shape in each lattice cell (cell_parts(): small parts join a neighbour). A
   * part of volume V, centroid c and second moments V S about it gets them at
   *   x = c + 2 sqrt(3) S^(1/2) xi,   xi in [-1/2, 1/2]^dim,
   * with the root that is symmetric. For solids xi are the Gauss points of a cell and the volumes
   * V times their weights, so that for n > 1 volume, centroid and moments of inertia of the particles are
   * those of the part, and a full cell has them at its Gauss points. For fluids xi are the centres of
   * n^dim equal parts of a cell, all with the same volume, at which full cells are evenly filled. Jitter
   * moves xi by up to jitter/(2 n) along each axis.
   *
   * Such places may lie a little outside of the shape. Those that lie behind a wall or in an obstacle
   * are moved to its surface.
   *
   * Of a list of points each becomes a particle, with the volume in the file or else dx^dim/n^dim.
   *
   * Positions, jitter and ids are functions of the place on the lattice or in the list alone; ranks share
   * the work by layers of cells, so that all of them together seed the same particles whatever their
   * number.
   *
   * @param body_number  makes ids of different bodies different.
   * @param obstacles    rigid bodies where they are at the start; they may touch the shape.
   * @throw InputError   if the shape cannot be made (make_shape()).
   */
  template <int dim>
  void
  seed_particles(const BodyParameters<dim> &parameters,
                 const Lattice<dim> &lattice,
                 const unsigned int body_number,
                 const unsigned int rank,
                 const unsigned int n_ranks,
                 Body<dim> &body,
                 const std::vector<Obstacle<dim>> &obstacles = {});
} // namespace magmpm
