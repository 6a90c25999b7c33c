#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /**
   * alpha of FMPM, exp(-2 dt c/dx) with the wave speed c of the undeformed material: what is given back of
   * what a transfer to and fro would lose, so that the loss counts time, not steps. 0 with APIC.
   */
  template <int dim>
  double
  share_given_back(const Body<dim> &body, const double spacing, const double time_step);

  /**
   * The lattice's velocity once to the particles and back, as APIC takes it:
   *   (m P v)_i = sum_p m_p N_ip [ v_p + C_p (x_i - x_p) ],
   *   v_p = sum_i N_ip v_i,  C_p = 4/dx^2 sum_i N_ip v_i (x_i - x_p)^T.
   * P is symmetric in the product of the masses, with eigenvalues from 0 to 1; it keeps linear fields.
   * Nodes with next to no mass get v - P v of the order of dt a in every step, which the particles
   * never see.
   *
   * Of each particle alone, sum_i m_p N_ip [ v_i - v_p - C_p (x_i - x_p) ] and its moment are zero: so the
   * loss of some particles, each with a factor of its own, carries no momentum and no angular momentum.
   *
   * @param factors   of the masses, by body.
   * @param velocity  v, ghosts up to date.
   * @param sums      on return the sums over this rank's particles, also on ghosts: momentum as above, and mass.
   * @param group     the contact group whose particles count.
   */
  template <int dim>
  void
  filter_velocity(std::vector<Body<dim>> &bodies,
                  const std::vector<double> &factors,
                  const BlockSet<dim> &blocks,
                  const Lattice<dim> &lattice,
                  const NodeField<dim> &velocity,
                  NodeField<dim> &sums,
                  const int group = every_group);
} // namespace magmpm
