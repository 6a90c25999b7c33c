#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/box_faces.h>
#include <magmpm/surface/volume_fraction.h>

#include <vector>

namespace magmpm
{
  /**
   * The J of a fluid follows div v at its particle. What the lattice does not resolve adds up over
   * many steps: particles come as close to one another as they like while their J stays near one, and
   * a pool at rest sinks to half its volume. So J is drawn, every few steps, towards that of the
   * lattice, the volume that the particles around leave to each of them,
   *
   *   J <- J + (1 - exp(-t/tau)) (J_lattice - J),   J_lattice = 1/sum_i N_ip v_i,
   *   v_i = sum_p N_ip V_0/dx^dim / (share of the node's B-spline inside of the walls),
   *
   * with tau = 3 dx/c: slow beside sound in a cell, fast beside what flows. Next to a free surface,
   * where v_i of one of the nodes is below 0.9, J is left alone: there the B-splines see too little.
   * In a spray, where sum_i N_ip v_i is below 0.4, it is drawn towards 1: a particle alone is an
   * oscillator that a time step for waves in the bulk makes unstable once J is off by a fifth.
   * Fluids count together; a solid body or magnet beside them is a free surface to them.
   */

  /** Steps from one relaxation to the next. */
  inline constexpr int relaxation_period = 5;

  /** Whether there is any J to relax. */
  template <int dim>
  bool
  has_fluid(const std::vector<Body<dim>> &bodies);

  /** What the nodes know of fluids; all zero beyond walls. */
  struct NodeFluid
  {
    static constexpr NodeScalar<NodeFluid> fraction     = {0}; ///< v_i
    static constexpr NodeScalar<NodeFluid> inside       = {1}; ///< 1 inside of walls
    static constexpr NodeScalar<NodeFluid> near_surface = {2}; ///< 1 where v_i is below 0.9

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(fraction);
      f(inside);
      f(near_surface);
    }
  };

  /** The material whose volume_fraction() is v_i, but for the share inside of the walls. */
  template <int dim>
  MaterialSelection
  undeformed_fluids(const std::vector<Body<dim>> &bodies);

  /** Makes it of their volume_fraction(), on all nodes that this has. */
  template <int dim>
  NodeField<dim, NodeFluid>
  fluid_on_nodes(const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 const OpenFaces<dim> &open,
                 const NodeField<dim, SingleScalar> &volume_fraction);

  /** |J - J_lattice| over particles of fluids that are not next to a free surface. */
  struct DensityError
  {
    double sum         = 0.;
    double n_particles = 0.;
  };

  /**
   * Relaxes J of all fluids.
   *
   * @param field  ghosts up to date.
   * @param time   since the last relaxation [s].
   * @return what it found, of this rank's particles.
   */
  template <int dim>
  DensityError
  relax_volume_ratios(const NodeField<dim, NodeFluid> &field,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      const double time,
                      std::vector<Body<dim>> &bodies);
} // namespace magmpm
