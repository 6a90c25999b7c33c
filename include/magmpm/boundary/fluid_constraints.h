#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/boundary/solid_contact.h>
#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>

#include <mpi.h>

#include <array>
#include <vector>

namespace magmpm
{
  /** A node of a constraint. */
  template <int dim>
  struct FluidTerm
  {
    Index<dim> node;
    double weight;
    Vector<dim>
      mirror; ///< -1 for components of the velocity that a wall between turns around, 1 for the others
    double mass;          ///< [kg]
    Vector<dim> velocity; ///< before contact [m/s]
  };

  /**
   * What a fluid obeys at a surface of a rigid body. A node g with mass inside the body, at the depth d, has
   * the image x' = x_g + 2 d n outside, n the outward normal. Contact is about the velocity relative to the body
   * that the lattice has on the surface between them,
   *   w = (v_g - u(x_g)) + sum_j W_j (v_j - u(x_j)),
   * with multilinear weights W_j of the nodes around x' that have mass: at a plane through nodes w = 0 is the
   * fold of WallImages. Nodes behind walls are images of those in front.
   */
  template <int dim>
  struct FluidConstraint
  {
    int body;
    int n_terms = 0;
    std::array<FluidTerm<dim>, 1 + (1 << dim)> terms; ///< the first is the node inside
    Vector<dim> normal;                               ///< out of the body
    Vector<dim> from_centre; ///< of the body, the mean of the nodes' places with their weights [m]
    double weight = 0.;      ///< sum of them
  };

  /**
   * The constraints at all bodies with a surface, on all ranks, in the same order. Collective.
   *
   * @param solids           nodes that it acts on are not meant.
   * @param negligible_mass  nodes with less are left alone [kg].
   * @param field            {velocity [m/s], mass [kg]}, ghosts up to date.
   */
  template <int dim>
  std::vector<FluidConstraint<dim>>
  find_fluid_constraints(const std::vector<RigidBody<dim>> &bodies,
                         const SolidContact<dim> &solids,
                         const WallParameters<dim> &walls,
                         const BlockSet<dim> &blocks,
                         const Lattice<dim> &lattice,
                         const double negligible_mass,
                         const NodeField<dim> &field,
                         const MPI_Comm communicator);
} // namespace magmpm
