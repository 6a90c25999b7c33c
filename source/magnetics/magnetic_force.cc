#include <deal.II/base/mpi.h>
#include <deal.II/matrix_free/fe_evaluation.h>

#include <magmpm/base/constants.h>
#include <magmpm/magnetics/magnetic_force.h>

namespace magmpm
{
  namespace
  {
    /** h = -grad phi at the points of one cell. */
    template <int dim>
    using PointFields = std::array<Vector<dim>, n_points<dim>>;

    /**
     * Calls action(lattice cell, self field at its points) for the lattice cells of this rank that
     * lie in owned active blocks.
     */
    template <int dim, typename Action>
    void
    for_active_cells(const PotentialSolution<dim> &solution,
                     const MaterialPoints<dim> &material,
                     const Action &action)
    {
      const PotentialSpace<dim> &space = *solution.space;
      const auto &cells                = *space.matrix_free;

      solution.potential.update_ghost_values();
      dealii::FEEvaluation<dim, potential_degree, n_points_1d> phi(cells);
      PointFields<dim> self_field;
      for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
        {
          bool is_evaluated = false;
          for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
            {
              const unsigned int cell = space.lattice_cell(batch, lane);
              if (cell == invalid_entry || material.slot(cell) == invalid_slot)
                continue;
              if (!is_evaluated)
                {
                  phi.reinit(batch);
                  phi.read_dof_values(solution.potential);
                  phi.evaluate(dealii::EvaluationFlags::gradients);
                  is_evaluated = true;
                }
              for (int q = 0; q < n_points<dim>; ++q)
                for (int d = 0; d < dim; ++d)
                  self_field[q][d] = -phi.get_gradient(q)[d][lane];
              action(cell, self_field);
            }
        }
      solution.potential.zero_out_ghost_values();
    }

    /** h (x) (h + M) - |h|^2/2 I [A^2/m^2]: the first index is that of the force. */
    template <int dim>
    Matrix<dim>
    self_stress(const Vector<dim> &h, const Vector<dim> &magnetization)
    {
      return outer(h, h + magnetization) + (-0.5 * norm_square(h)) * identity<dim>();
    }

    /** Its mean over the phases of a laminate, each with the fields of that phase. */
    template <int dim>
    Matrix<dim>
    laminate_stress(const Vector<dim> &h,
                    const LaminateResponse<dim> &medium,
                    const double fraction)
    {
      if (!(fraction > 0.))
        return self_stress(h, Vector<dim>());
      const Vector<dim> inside  = h + (1. - fraction) * medium.jump;
      const Vector<dim> outside = h - fraction * medium.jump;
      return fraction * self_stress(inside, (1. / fraction) * medium.mean.magnetization) +
             (1. - fraction) * self_stress(outside, Vector<dim>());
    }

    /** H in the material phase of a point: the sources' and the material's own [A/m]. */
    template <int dim>
    Vector<dim>
    material_field(const MaterialPoints<dim> &material,
                   const unsigned int point,
                   const Vector<dim> &self_field)
    {
      return material.source_field(point) + self_field +
             (1. - material.fraction(point)) * material.response(point, self_field).jump;
    }

    /** Calls action(slot, node) for all nodes of owned blocks. */
    template <int dim, typename Action>
    void
    for_owned_nodes(const BlockSet<dim> &blocks, const Action &action)
    {
      for (int slot = 0; slot < blocks.n_owned(); ++slot)
        for (int node = 0; node < nodes_per_block<dim>; ++node)
          action(slot, node);
    }

    /**
     * Whether all blocks are active that hold cells under the B-spline of a node: it reaches 3/2 dx,
     * from nodes 0 and 1 of a block into the one below, from node 3 into the one above.
     */
    template <int dim>
    bool
    is_covered(const BlockSet<dim> &blocks, const int slot, int node)
    {
      int reach[dim];
      for (int d = 0; d < dim; ++d, node /= block_edge)
        {
          const int place = node % block_edge;
          reach[d]        = (place < 2 ? -1 : (place == block_edge - 1 ? 1 : 0));
        }
      for (int corner = 0; corner < power(2, dim); ++corner)
        {
          int neighbour = 0;
          for (int d = 0; d < dim; ++d)
            neighbour += power(3, d) * (1 + ((corner >> d) & 1) * reach[d]);
          if (blocks.neighbours(slot)[neighbour] == invalid_slot)
            return false;
        }
      return true;
    }
  } // namespace

  template <int dim>
  void
  compute_split_force(const PotentialSolution<dim> &solution,
                      const MaterialPoints<dim> &material,
                      const BlockPartition<dim> &partition,
                      NodeField<dim> &force)
  {
    const BlockSet<dim> &blocks     = partition.blocks();
    const double inverse_spacing    = 1. / solution.space->mesh.lattice().spacing;
    const CellStencil<dim> &stencil = material.stencil();
    force.reinit(blocks.size());

    for_active_cells(
      solution, material, [&](const unsigned int cell, const PointFields<dim> &self_field) {
        // By axis of the derivative: what is tested by dN_i/dx_axis; and what is tested by N_i.
        std::array<PointValues<dim>, dim> stress = {};
        PointValues<dim> body                    = {};
        const unsigned int first                 = material.first_point(cell);
        for (int q = 0; q < n_points<dim>; ++q)
          {
            const double weight = constants::vacuum_permeability * material.weight(q);
            Matrix<dim> tensor;
            if (first == material.none)
              tensor = self_stress(self_field[q], Vector<dim>());
            else
              {
                const LaminateResponse<dim> medium = material.response(first + q, self_field[q]);
                const double fraction              = material.fraction(first + q);
                tensor                    = laminate_stress(self_field[q], medium, fraction);
                const Vector<dim> density = material.source_gradient(first + q) *
                                            medium.mean.magnetization;
                for (int d = 0; d < dim; ++d)
                  body[q * n_lanes + d] = weight * density[d];
              }
            for (int axis = 0; axis < dim; ++axis)
              for (int d = 0; d < dim; ++d)
                stress[axis][q * n_lanes + d] = -weight * inverse_spacing * tensor(d, axis);
          }
        StencilValues<dim> nodes = {};
        for (int axis = 0; axis < dim; ++axis)
          stencil.add_tested_by_derivative(stress[axis], axis, nodes);
        if (first != material.none)
          stencil.add_tested(body, nodes);
        stencil.scatter_add(nodes, blocks, material.slot(cell), material.corner(cell), force);
      });

    partition.add_ghosts_to_owners(force);
    for_owned_nodes(blocks, [&](const int slot, const int node) {
      if (!is_covered<dim>(blocks, slot, node))
        std::fill_n(force.node(slot, node), dim, 0.);
    });
  }

  template <int dim>
  void
  compute_material_field(const PotentialSolution<dim> &solution,
                         const MaterialPoints<dim> &material,
                         const BlockPartition<dim> &partition,
                         NodeField<dim> &field)
  {
    const BlockSet<dim> &blocks     = partition.blocks();
    const CellStencil<dim> &stencil = material.stencil();
    field.reinit(blocks.size());
    // The weight takes the fourth lane: this is why it is free to the caller.
    for_active_cells(
      solution, material, [&](const unsigned int cell, const PointFields<dim> &self_field) {
        const unsigned int first = material.first_point(cell);
        if (first == material.none)
          return;
        PointValues<dim> values = {};
        for (int q = 0; q < n_points<dim>; ++q)
          {
            const double weight     = material.weight(q) * material.volume_fraction(first + q);
            const Vector<dim> total = material_field(material, first + q, self_field[q]);
            for (int d = 0; d < dim; ++d)
              values[q * n_lanes + d] = weight * total[d];
            values[q * n_lanes + n_lanes - 1] = weight;
          }
        StencilValues<dim> nodes = {};
        stencil.add_tested(values, nodes);
        stencil.scatter_add(nodes, blocks, material.slot(cell), material.corner(cell), field);
      });

    partition.add_ghosts_to_owners(field);
    for_owned_nodes(blocks, [&](const int slot, const int node) {
      double *lanes       = field.node(slot, node);
      const double weight = lanes[n_lanes - 1];
      for (int d = 0; d < dim && weight > 0.; ++d)
        lanes[d] /= weight;
      lanes[n_lanes - 1] = 0.;
    });
    partition.update_ghosts(field);
  }

  template <int dim>
  std::vector<MaterialSample<dim>>
  sample_material(const PotentialSolution<dim> &solution, const MaterialPoints<dim> &material)
  {
    std::vector<MaterialSample<dim>> samples(material.size());
    for_active_cells(
      solution, material, [&](const unsigned int cell, const PointFields<dim> &self_field) {
        const unsigned int first = material.first_point(cell);
        if (first == material.none)
          return;
        for (int q = 0; q < n_points<dim>; ++q)
          samples[first + q] = {material.cell_position(cell) + material.point_position(q),
                                material.weight(q),
                                material.volume_fraction(first + q),
                                material_field(material, first + q, self_field[q]),
                                material.response(first + q, self_field[q]).mean.magnetization,
                                material.fraction(first + q) * material.number_density(first + q)};
      });
    return samples;
  }

#define MAGMPM_INSTANTIATE(dim)                                                             \
  template void compute_split_force(const PotentialSolution<dim> &,                         \
                                    const MaterialPoints<dim> &,                            \
                                    const BlockPartition<dim> &,                            \
                                    NodeField<dim> &);                                      \
  template void compute_material_field(const PotentialSolution<dim> &,                      \
                                       const MaterialPoints<dim> &,                         \
                                       const BlockPartition<dim> &,                         \
                                       NodeField<dim> &);                                   \
  template std::vector<MaterialSample<dim>> sample_material(const PotentialSolution<dim> &, \
                                                            const MaterialPoints<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
