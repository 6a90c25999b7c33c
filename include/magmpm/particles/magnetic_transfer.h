#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /**
   * Density of magnetic content, P2G of the grains of each particle, Eq. (27): volume J V_0 over dx^dim,
   * and saturation, susceptibility and grains of the undeformed material times V_0/dx^dim. Grains move with the material, so their number per particle never changes.
   */
  template <int dim>
  void
  magnetic_content_to_lattice(std::vector<Body<dim>> &bodies,
                              const BlockSet<dim> &blocks,
                              const Lattice<dim> &lattice,
                              NodeField<dim, NodeContent> &content);

  /** The mass of magnetic particles alone [kg]: what magnetic force acts on. */
  template <int dim>
  void
  magnetic_mass_to_lattice(std::vector<Body<dim>> &bodies,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           NodeField<dim, SingleScalar> &mass);

  /**
   * What magnetic particles that take an acceleration from the nodes give back to them as force:
   *   sum_p m_p N_ip sum_j N_jp a_j.
   *
   * @param accelerations  ghosts up to date.
   * @param forces         on return the sums over this rank's particles, also on ghosts.
   */
  template <int dim>
  void
  carried_force_on_lattice(std::vector<Body<dim>> &bodies,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           const NodeField<dim, SingleVector> &accelerations,
                           NodeField<dim, SingleVector> &forces);

  /** What a vector on the nodes becomes on magnetic particles. */
  template <int dim>
  void
  interpolate_to_particles(const NodeField<dim, SingleVector> &field,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           const ParticleProperty quantity,
                           std::vector<Body<dim>> &bodies);
} // namespace magmpm
