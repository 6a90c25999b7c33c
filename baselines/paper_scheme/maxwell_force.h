#pragma once

#include <baselines/paper_scheme/material_nodes.h>
#include <baselines/paper_scheme/potential_stencil.h>

namespace magmpm::paper_scheme
{
  /** Which nodes have force: two readings of the paper's "cells saturated by material points". */
  enum class ForceRegion
  {
    reached_nodes, ///< every node with n_i > 0, the more accurate one
    full_cells     ///< nodes with a particle in the cell of edge dx around them
  };

  /**
   * Forces on @p nodes, Eqs. (32), (42): the central differences of the Maxwell stress
   * H B - mu_0/2 |H|^2 I on the nodes of @p region (zero elsewhere), times dx^dim, averaged with
   * R_ij, the product over the axes of (1/6, 2/3, 1/6). What R_ij brings to nodes without mass
   * (n_i = 0) is lost, as in the paper.
   *
   * @param phi  the potential [A].
   * @return [N], in the order of @p nodes; in 2D [N/m].
   */
  template <int dim>
  std::vector<Vector<dim>>
  maxwell_forces(const NodeGrid<dim> &grid,
                 const NodeVector &phi,
                 const std::vector<MaterialNode<dim>> &nodes,
                 const MagnetizationLaw law,
                 const ExternalField<dim> &sources,
                 const ForceRegion region);

  /** Sum of nodal forces [N]. */
  template <int dim>
  Vector<dim>
  total_force(const std::vector<Vector<dim>> &forces);

  /** sum f_i (x_i - c)^T [N m]: the traction on the surface, with its lever arm. */
  template <int dim>
  Matrix<dim>
  virial(const std::vector<MaterialNode<dim>> &nodes,
         const std::vector<Vector<dim>> &forces,
         const Vector<dim> &centre);

  /** sum (x_i - c) x f_i [N m]. */
  template <int dim>
  Vector<n_axial_components<dim>>
  torque(const std::vector<MaterialNode<dim>> &nodes,
         const std::vector<Vector<dim>> &forces,
         const Vector<dim> &centre);
} // namespace magmpm::paper_scheme
