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
   * What accelerations of the nodes become on magnetic particles, as G2P of APIC makes velocities: a_p, and
   * A_p = 4/dx^2 sum_i N_ip a_i (x_i - x_p)^T, of which P2G makes force again.
   *
   * @param accelerations  [m/s^2], ghosts up to date.
   */
  template <int dim>
  void
  accelerations_to_particles(const NodeField<dim, SingleVector> &accelerations,
                             const BlockSet<dim> &blocks,
                             const Lattice<dim> &lattice,
                             std::vector<Body<dim>> &bodies);

  /** What a vector on the nodes becomes on magnetic particles. */
  template <int dim>
  void
  interpolate_to_particles(const NodeField<dim, SingleVector> &field,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           const ParticleProperty quantity,
                           std::vector<Body<dim>> &bodies);
} // namespace magmpm
