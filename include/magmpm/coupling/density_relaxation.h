#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /**
   * The J of a fluid follows div v at its particle. What the lattice does not resolve adds up over many steps.
   * Every few steps two things are mended.
   *
   * Density. Particles may come as close to one another as they like while their J stays near one, and a pool
   * at rest sinks to half its volume. The volumes that they claim to have tell,
   *   psi_i = sum_p N_ip J_p V_0/dx^dim,
   * with images behind walls and completed by solids and rigid bodies: inside of a fluid it is 1, however the
   * fluid is stratified. J follows
   *   J <- J (1 - (1 - exp(-t/tau)) sum_i N_ip e_i),   tau = 20 dx/c,
   * with the excess e_i = psi_i - 1 where psi is above 0.8 on all nodes around, and e_i = max(psi_i - 1.1, 0)
   * near a free surface, where B-splines see too little. Without the margin there, noise of particles would
   * count in one direction alone, and stirred water would swell. In a spray, where sum_i N_ip psi_i is below
   * 0.4, J is drawn towards 1 in 3 dx/c: a particle alone is an oscillator that a time step for waves in the
   * bulk makes unstable once J is off by a fifth.
   *
   * Noise. A lattice with one pressure a node does not see what 2^dim particles around it differ in. With S the
   * mean over nodes, (S J)_p = sum_i N_ip (sum_q N_iq V_0 J_q)/(sum_q N_iq V_0),
   *   J <- J - (1 - S)^2 J/2.
   * S is symmetric in the product with V_0, its eigenvalues are between 0 and 1, and S 1 = 1: the sum of V_0 J
   * is kept, the elastic energy K/2 sum V_0 (1 - J)^2 never grows, and a field of the wave number k is damped
   * by (k dx/2)^4/8.
   */

  /** Steps from one relaxation to the next. */
  inline constexpr int relaxation_period = 5;

  /** Whether there is any J to relax. */
  template <int dim>
  bool
  has_fluid(const std::vector<Body<dim>> &bodies);

  /**
   * The bulk moduli of fluids [Pa], each once. Fluids of one modulus are smoothed together: across the interface
   * of others the pressure goes on, but not J.
   */
  template <int dim>
  std::vector<double>
  bulk_moduli(const std::vector<Body<dim>> &bodies);

  /** Sums over particles of N_i V/dx^dim. */
  struct NodeClaims
  {
    static constexpr NodeScalar<NodeClaims> fluid = {
      0}; ///< V = J V_0 of fluids of one bulk modulus
    static constexpr NodeScalar<NodeClaims> undeformed = {1}; ///< V = V_0 of them
    static constexpr NodeScalar<NodeClaims> solid      = {2}; ///< V = J V_0 of solids

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(fluid);
      f(undeformed);
      f(solid);
    }
  };

  /** @param with_solids  whether they count too. @param claims  on return this rank's part, ghosts too. */
  template <int dim>
  void
  scatter_claims(std::vector<Body<dim>> &bodies,
                 const double bulk_modulus,
                 const bool with_solids,
                 const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 NodeField<dim, NodeClaims> &claims);

  /** What the nodes know of fluids. */
  struct NodeFluid
  {
    static constexpr NodeScalar<NodeFluid> fraction     = {0}; ///< psi_i
    static constexpr NodeScalar<NodeFluid> excess       = {1}; ///< e_i
    static constexpr NodeScalar<NodeFluid> near_surface = {
      2}; ///< 1 where psi is below 0.8 on a node around
    static constexpr NodeScalar<NodeFluid> mean_ratio = {
      3}; ///< of J, of fluids of one bulk modulus

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(fraction);
      f(excess);
      f(near_surface);
      f(mean_ratio);
    }
  };

  /** All but the mean ratio, on owned nodes. @param fraction  ghosts up to date. */
  template <int dim>
  void
  find_excess(const BlockSet<dim> &blocks,
              const NodeField<dim, SingleScalar> &fraction,
              NodeField<dim, NodeFluid> &field);

  /** |psi - 1| over particles of fluids that are not next to a free surface. */
  struct DensityError
  {
    double sum         = 0.;
    double n_particles = 0.;
  };

  /** By body, by particle: what the mean over nodes does not hold, (1 - S) J. */
  using Residuals = std::vector<std::vector<double>>;

  /**
   * Relaxes the density of fluids of a bulk modulus, and finds the residuals of the J that they had.
   *
   * @param field  ghosts up to date.
   * @param time   since the last relaxation [s].
   * @param error  what it found, of this rank's particles, is added.
   */
  template <int dim>
  void
  relax_volume_ratios(const NodeField<dim, NodeFluid> &field,
                      const double bulk_modulus,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      const double time,
                      Residuals &residuals,
                      DensityError &error,
                      std::vector<Body<dim>> &bodies);

  /** Sums of N_i V_0 (1 - S) J/dx^dim. @param sums  on return this rank's part, ghosts too. */
  template <int dim>
  void
  scatter_residuals(std::vector<Body<dim>> &bodies,
                    const double bulk_modulus,
                    const Residuals &residuals,
                    const BlockSet<dim> &blocks,
                    const Lattice<dim> &lattice,
                    NodeField<dim, SingleScalar> &sums);

  /** J <- J - (1 - S)^2 J/2. @param means  of the residuals, S (1 - S) J on the nodes; ghosts up to date. */
  template <int dim>
  void
  take_noise(const NodeField<dim, SingleScalar> &means,
             const double bulk_modulus,
             const Residuals &residuals,
             const BlockSet<dim> &blocks,
             const Lattice<dim> &lattice,
             std::vector<Body<dim>> &bodies);
} // namespace magmpm
