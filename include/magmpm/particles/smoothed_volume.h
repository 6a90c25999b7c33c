#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/materials/parameter_conversion.h>
#include <magmpm/particles/body.h>

#include <vector>

/**
 * The pressure of nearly incompressible solids. Four particles in a cell (eight in 3D), of which each keeps
 * its own volume, are more constraints than the lattice has ways to move: a bent strip two cells thick is 5 %
 * too stiff at Poisson's ratio 0.49, 10 % at 0.499, and single pressures are noise. So only lambda_0 = 9 mu of
 * lambda acts on a particle's own ln J; the rest, kappa, on what the lattice sees of it:
 *
 *   E = sum_p V_p [ mu/2 (tr F F^T - dim) - mu ln J + lambda_0/2 (ln J)^2 ] + 1/2 sum_k K_k theta_k^2,
 *   theta_k = 1/K_k sum_p V_p kappa h_kp ln J_p,   K_k = sum_p V_p kappa h_kp,
 *   tau_p = mu (F F^T - I) + (lambda_0 ln J + kappa sum_k h_kp theta_k) I,
 *
 * V_p undeformed volumes, h_k the hat (linear in each direction) about the centre of cell k. Of such hats
 * the slopes of the quadratic B-splines are made: what div v can be is no finer. The points of a particle
 * are the 2^dim lowest nodes of its stencil, moved by dx/2, so they are stored on these.
 *
 * S = h K^-1 h^T is symmetric in the product of V kappa, with eigenvalues from 0 to 1, and keeps constants.
 * The force is minus the derivative of E with the hats at rest; that particles pass under them is left out,
 * as it would cost momentum: a bar stretched by half and back loses or gains 1e-3 of the work by that.
 * A particle without neighbours within reach of its hats has its own ln J.
 *
 * The volumetric stress that particles carry is that in place of lambda ln J in the law of the material,
 *   lambda_0 ln J_p + kappa sum_k h_kp theta_k,
 * found before each P2G and before energies are summed. No pressure enters the von Mises stress.
 */
namespace magmpm
{
  /**
   * Of ln J at the centre of the cell above a node: at first the sum of V_p h ln J_p, then their mean. All lanes
   * of a node, as NodeMotion: arenas copy these faster.
   */
  struct NodeStrain
  {
    static constexpr NodeScalar<NodeStrain> strain = {0};           ///< [m^dim], then [-]
    static constexpr NodeScalar<NodeStrain> weight = {n_lanes - 1}; ///< sum of V_p h [m^dim]

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(strain);
      f(weight);
    }
  };

  /** Bodies that are smoothed together. */
  struct SmoothedMaterial
  {
    LameModuli moduli;
    int contact_group;
  };

  /**
   * The nearly incompressible solids. Bodies with the same moduli in the same contact group are smoothed together,
   * as pieces of one; of different ones each apart, since they share the pressure across their
   * interface but not the strain.
   */
  template <int dim>
  std::vector<SmoothedMaterial>
  smoothed_materials(const std::vector<Body<dim>> &bodies);

  /**
   * Sums over the particles of a material.
   *
   * @param field  on return the sums over this rank's particles, also on ghosts.
   */
  template <int dim>
  void
  sum_strain(std::vector<Body<dim>> &bodies,
             const SmoothedMaterial &material,
             const BlockSet<dim> &blocks,
             const Lattice<dim> &lattice,
             NodeField<dim, NodeStrain> &field);

  /** Makes means of the sums on owned nodes; zero where there is nothing. */
  template <int dim>
  void
  divide_by_weight(const BlockSet<dim> &blocks, NodeField<dim, NodeStrain> &field);

  /**
   * The volumetric stress of the particles of a material, at the places and in the state of sum_strain().
   *
   * @param field  means, ghosts up to date.
   */
  template <int dim>
  void
  find_volumetric_stress(const NodeField<dim, NodeStrain> &field,
                         const SmoothedMaterial &material,
                         const BlockSet<dim> &blocks,
                         const Lattice<dim> &lattice,
                         std::vector<Body<dim>> &bodies);
} // namespace magmpm
