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
      dealii::FEEvaluation<dim, potential_degree, n_points_1d, 1, double, CellLanes<double>> phi(
        cells);
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
    const BlockSet<dim> &blocks  = partition.blocks();
    const double inverse_spacing = 1. / solution.space->mesh.lattice().spacing;
    const CellStencil<dim> stencil;
    force.reinit(blocks.size());

    for_active_cells(
      solution, material, [&](const unsigned int cell, const PointFields<dim> &self_field) {
        // By axis of the derivative: what is tested by dN_i/dx_axis; and what is tested by N_i.
        std::array<PointValues<dim>, dim> stress = {};
        PointValues<dim> body                    = {};
        const unsigned int first                 = material.first_point(cell);
        for (int q = 0; q < n_points<dim>; ++q)
          {
            const Vector<dim> &h = self_field[q];
            const double weight  = constants::vacuum_permeability * material.weight(q);
            Vector<dim> flux     = h;
            if (first != material.none)
              {
                const Vector<dim> m       = material.response(first + q, h).magnetization;
                const Vector<dim> density = material.source_gradient(first + q) * m;
                flux += m;
                for (int d = 0; d < dim; ++d)
                  body[q * n_lanes + d] = weight * density[d];
              }
            for (int axis = 0; axis < dim; ++axis)
              for (int d = 0; d < dim; ++d)
                stress[axis][q * n_lanes + d] =
                  weight * inverse_spacing *
                  ((axis == d ? 0.5 * norm_square(h) : 0.) - h[d] * flux[axis]);
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
    const BlockSet<dim> &blocks = partition.blocks();
    const CellStencil<dim> stencil;
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
            const Vector<dim> total = self_field[q] + material.source_field(first + q);
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
    std::vector<MaterialSample<dim>> samples;
    for_active_cells(
      solution, material, [&](const unsigned int cell, const PointFields<dim> &self_field) {
        const unsigned int first = material.first_point(cell);
        if (first == material.none)
          return;
        for (int q = 0; q < n_points<dim>; ++q)
          samples.push_back({material.cell_position(cell) + material.point_position(q),
                             material.weight(q),
                             material.volume_fraction(first + q),
                             self_field[q] + material.source_field(first + q),
                             material.response(first + q, self_field[q]).magnetization});
      });
    return samples;
  }

#define MAGMPM_INSTANTIATE(dim)                                        \
  template void compute_split_force(const PotentialSolution<dim> &,    \
                                    const MaterialPoints<dim> &,       \
                                    const BlockPartition<dim> &,       \
                                    NodeField<dim> &);                 \
  template void compute_material_field(const PotentialSolution<dim> &, \
                                       const MaterialPoints<dim> &,    \
                                       const BlockPartition<dim> &,    \
                                       NodeField<dim> &);              \
  template std::vector<MaterialSample<dim>> sample_material(           \
    const PotentialSolution<dim> &, const MaterialPoints<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
