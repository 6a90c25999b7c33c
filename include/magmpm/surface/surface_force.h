#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/lattice/node_images.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/surface_content.h>
#include <magmpm/surface/surface_stress.h>
#include <magmpm/surface/wetted_bodies.h>
#include <magmpm/surface/wetted_walls.h>

#include <array>

namespace magmpm
{
  /** What the force of surfaces is made of, on nodes, ghosts up to date, images behind walls not there. */
  template <int dim>
  struct SurfaceFields
  {
    /** In rigid bodies the image of what is in front. */
    NodeField<dim, SurfaceContent> content;

    /** Whether all of it has the largest tension: otherwise content tells. */
    bool is_uniform = true;

    /** The share of nodes in rigid bodies; without blocks if there are none. */
    NodeField<dim, SingleScalar> rigid_share;

    /** The same with the cosines of contact angles; without blocks if all of these are 90 degrees. */
    NodeField<dim, SingleScalar> rigid_wetting;

    NodeImages<dim> images; ///< of what is in front of rigid bodies
  };

  /**
   * The force of surface tension on nodes, f_i = -int T grad N_i, with the stress T of SurfaceStress. From the
   * content c of the nodes, with its images behind walls,
   *   v = S (c - dx^2/4 Laplace_h c),   w = min(1, max of v over 5^dim nodes/0.8),
   * S one pass of (1/4, 1/2, 1/4) along each axis: without it, or with the w of SharpFraction, drops are
   * not at rest. Wetted walls and bodies add theirs (wetted_walls.h, wetted_bodies.h). T is symmetric
   * and B-splines reproduce what is linear, so the forces have no sum and no torque.
   */
  template <int dim>
  class SurfaceForce
  {
  public:
    SurfaceForce(const Lattice<dim> &lattice, const WettedWalls<dim> &walls);

    /**
     * Collective.
     *
     * @param force  on owned nodes, in units of gamma dx^(dim-2); that on nodes behind walls is on those
     *                    in front, as the motion there goes.
     * @return this rank's part of the surface energy over gamma dx^(dim-1).
     */
    double
    find(const BlockPartition<dim> &partition,
         const SurfaceFields<dim> &fields,
         NodeField<dim, SingleVector> &force);

  private:
    using Stress     = SurfaceStress<dim>;
    using NodeValues = typename Stress::NodeValues;

    /** v on owned nodes, ghosts updated. */
    void
    find_volumes(const BlockPartition<dim> &partition, const SurfaceFields<dim> &fields);

    /** v, w and tension around a block. @return whether there is any. */
    bool
    find_nodes(const BlockSet<dim> &blocks,
               const SurfaceFields<dim> &fields,
               const int slot,
               typename Stress::Nodes &nodes) const;

    /** Adds the force on the nodes around a block of bodies that are wetted. @return their energy. */
    double
    wet_bodies(const BlockSet<dim> &blocks,
               const SurfaceFields<dim> &fields,
               const int slot,
               const typename Stress::Nodes &nodes,
               std::array<NodeValues, dim> &force) const;

    /** The tension around a block where it differs. @return whether there is any. */
    bool
    find_tension(const BlockSet<dim> &blocks,
                 const NodeField<dim, SurfaceContent> &content,
                 const int slot,
                 typename Stress::Nodes &nodes) const;

    /** w around a block that has a surface. */
    void
    find_full(const BlockSet<dim> &blocks, const int slot, NodeValues &full) const;

    /** Adds what acts on the nodes around a block to those in front of walls. */
    void
    add_to_field(const BlockSet<dim> &blocks,
                 const int slot,
                 std::array<NodeValues, dim> &forces,
                 NodeField<dim, SingleVector> &field) const;

    /** Whether a block is in the box. */
    bool
    is_in_box(const Index<dim> &block, const int layers_beyond = 0) const;

    const Lattice<dim> lattice;
    const WettedWalls<dim> walls;
    const Stress stress;
    const WettedBodies<dim> bodies;
    NodeField<dim, SingleScalar> volumes; ///< v
  };
} // namespace magmpm
