#pragma once

#include <magmpm/elliptic/elliptic_problem.h>
#include <magmpm/magnetics/material_points.h>
#include <magmpm/magnetics/material_sample.h>
#include <magmpm/mesh/block_partition.h>

#include <vector>

namespace magmpm
{
  /**
   * The split magnetic force on the nodes of the active blocks,
   *   f_i = mu_0 int [-h ((h + M).grad N_i) + |h|^2/2 grad N_i] + int N_i mu_0 (M.grad) H_ext.
   * The stress h (x) (h + M) of the field that the material makes itself is not symmetric: h + M is
   * what is contracted with grad N_i. The stress of H_ext never enters, so that there are no ghost
   * forces near a strong magnet. In a laminate each product is that of its phase, and the mean over
   * both is taken. The integral is over the cells of active blocks, with the quadratures
   * of the solve: 3^dim points for the stress that a vacuum would have, the octants for what material
   * adds. Nodes whose B-spline reaches beyond active blocks are left at zero.
   *
   * @param force  [N] on owned nodes, summed over the ranks; ghosts zero. Collective.
   */
  template <int dim>
  void
  compute_split_force(const EllipticProblem<dim> &potential,
                      const MaterialPoints<dim> &material,
                      const BlockPartition<dim> &partition,
                      NodeField<dim, SingleVector> &force);

  /**
   * H in the material phase, averaged to nodes: int f N_i H / int f N_i, zero without material.
   *
   * @param field  H [A/m], ghosts updated. Collective.
   */
  template <int dim>
  void
  compute_material_field(const EllipticProblem<dim> &potential,
                         const MaterialPoints<dim> &material,
                         const BlockPartition<dim> &partition,
                         NodeField<dim, SingleVector> &field);

  /** The medium of this rank in the octants of cells with material. */
  template <int dim>
  std::vector<MaterialSample<dim>>
  sample_material(const EllipticProblem<dim> &potential, const MaterialPoints<dim> &material);
} // namespace magmpm
