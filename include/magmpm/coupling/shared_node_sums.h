#pragma once

#include <magmpm/boundary/group_contact_law.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>

#include <vector>

/**
 * What two contact groups leave on the nodes that they share, in two passes over the particles near these: what
 * material is there, from which the directions follow along which they may touch, and the gaps along
 * these. Side 0 is the first group, a, side 1 the second, b.
 */
namespace magmpm
{
  /** Of each side, sums of J V_0 grad N_i, N_i m, N_i J V_0 and N_i J V_0 (lambda + 2 mu). */
  struct SharedNodeMaterial
  {
    static constexpr NodeVector<SharedNodeMaterial>
    volume_gradient(const int side)
    {
      return {6 * side};
    }

    static constexpr NodeScalar<SharedNodeMaterial>
    mass(const int side)
    {
      return {6 * side + 3};
    }

    static constexpr NodeScalar<SharedNodeMaterial>
    volume(const int side)
    {
      return {6 * side + 4};
    }

    static constexpr NodeScalar<SharedNodeMaterial>
    stiffness(const int side)
    {
      return {6 * side + 5};
    }

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      for (int side = 0; side < 2; ++side)
        {
          f(volume_gradient(side));
          f(mass(side));
          f(volume(side));
          f(stiffness(side));
        }
    }
  };

  /** What a side has at a node. */
  template <int dim>
  inline SharedMaterial<dim>
  material_at(const NodeField<dim, SharedNodeMaterial> &field,
              const int side,
              const int slot,
              const int node)
  {
    const double volume = field.get(SharedNodeMaterial::volume(side), slot, node);
    return {field.get(SharedNodeMaterial::mass(side), slot, node),
            volume,
            field.get(SharedNodeMaterial::stiffness(side), slot, node) / volume,
            field.get(SharedNodeMaterial::volume_gradient(side), slot, node)};
  }

  /** Of each side along each direction, sums of weights and of weights times the way to the node. */
  struct SharedNodeGaps
  {
    static constexpr NodeScalar<SharedNodeGaps>
    weight(const int side, const int direction)
    {
      return {2 * (3 * side + direction)};
    }

    /** [m] */
    static constexpr NodeScalar<SharedNodeGaps>
    weighted_way(const int side, const int direction)
    {
      return {2 * (3 * side + direction) + 1};
    }

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      for (int side = 0; side < 2; ++side)
        for (int direction = 0; direction < 3; ++direction)
          {
            f(weight(side, direction));
            f(weighted_way(side, direction));
          }
    }
  };

  /**
   * Adds the material of a group.
   *
   * @param shared    1 on nodes that both groups reach, ghosts too.
   * @param material  this rank's particles are added, also on ghosts.
   */
  template <int dim>
  void
  add_shared_material(const std::vector<Body<dim>> &bodies,
                      const int group,
                      const int side,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      const NodeField<dim, SingleScalar> &shared,
                      NodeField<dim, SharedNodeMaterial> &material);

  /**
   * Adds the gaps of a group. The way of a particle of a to the node at x_i along the direction n is
   *   s = (x_i - x_p).n - sum_k |n . F H e_k|,
   * of one of b with -n; the gap is the sum of the means of both sides, with weights
   *   w = N_i S_p exp(-s/(0.1 dx) - y^2/(2 (0.35 dx)^2)),
   * the surface S_p of the particle that looks along n and its distance y from the line through the node along n:
   * beside a contact of curved surfaces the gap is not that of their nearest places. Particles of fluids, which have no
   * faces, count as cubes that lie along the lattice.
   *
   * @param material  sums of all ranks, ghosts up to date.
   */
  template <int dim>
  void
  add_shared_gaps(const std::vector<Body<dim>> &bodies,
                  const int group,
                  const int side,
                  const BlockSet<dim> &blocks,
                  const Lattice<dim> &lattice,
                  const NodeField<dim, SingleScalar> &shared,
                  const NodeField<dim, SharedNodeMaterial> &material,
                  NodeField<dim, SharedNodeGaps> &gaps);
} // namespace magmpm
