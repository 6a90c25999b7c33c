#include <magmpm/base/constants.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/magnetics/magnetic_force.h>

namespace magmpm
{
  namespace
  {
    /** The vector of one of several points. */
    template <int dim, typename Lanes>
    Vector<dim>
    lane_of(const Vector<dim, Lanes> &vectors, const int lane)
    {
      Vector<dim> vector;
      for (int d = 0; d < dim; ++d)
        vector[d] = vectors[d][lane];
      return vector;
    }

    template <int dim, typename Lanes>
    Matrix<dim>
    lane_of(const Matrix<dim, Lanes> &matrices, const int lane)
    {
      Matrix<dim> matrix;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          matrix(i, j) = matrices(i, j)[lane];
      return matrix;
    }

    /**
     * Calls action(lattice cell, h = -grad phi at its points) for the lattice cells of this rank that lie
     * in owned active blocks.
     */
    template <int dim, typename Action>
    void
    for_active_cells(const EllipticProblem<dim> &potential,
                     const MaterialPoints<dim> &material,
                     const Action &action)
    {
      potential.for_gradients(
        [&](const unsigned int cell) { return material.cells().is_active(cell); },
        [&](const unsigned int cell, const PointVectors<dim> &gradients) {
          PointVectors<dim> self_field;
          for (int q = 0; q < n_points<dim>; ++q)
            self_field[q] = -1. * gradients[q];
          action(cell, self_field);
        });
    }

    /** h (x) h - |h|^2/2 I [A^2/m^2]. */
    template <int dim, typename Number>
    Matrix<dim, Number>
    vacuum_stress(const Vector<dim, Number> &h)
    {
      return outer(h, h) + (-0.5 * norm_square(h)) * identity<dim, Number>();
    }

    /**
     * h (x) (h + M) - |h|^2/2 I [A^2/m^2]: the first index is that of the force. The mean over the phases
     * of a laminate, each with the fields of that phase.
     */
    template <int dim, typename Number>
    Matrix<dim, Number>
    laminate_stress(const Vector<dim, Number> &h,
                    const LaminateResponse<dim, Number> &medium,
                    const Number &fraction)
    {
      const Vector<dim, Number> inside  = h + (1. - fraction) * medium.jump;
      const Vector<dim, Number> outside = h - fraction * medium.jump;
      return fraction * vacuum_stress(inside) + outer(inside, medium.mean.magnetization) +
             (1. - fraction) * vacuum_stress(outside);
    }

    /** What is tested by dN_i/dx_axis, by axis, and what is tested by N_i. */
    template <int dim>
    struct PointForces
    {
      std::array<PointValues<dim>, dim> stress = {};
      PointValues<dim> body                    = {};

      void
      set_stress(const int q, const double factor, const Matrix<dim> &tensor)
      {
        for (int axis = 0; axis < dim; ++axis)
          {
            Vector<dim> column;
            for (int d = 0; d < dim; ++d)
              column[d] = factor * tensor(d, axis);
            stress[axis].set(SingleVector::value, q, column);
          }
      }
    };

    /** The forces at the points of a cell with material, ready to be tested. */
    template <int dim>
    void
    set_forces(const MaterialPoints<dim> &material,
               const unsigned int first_point,
               const PointVectors<dim> &self_field,
               const double inverse_spacing,
               PointForces<dim> &forces)
    {
      material.for_batches(
        first_point,
        [&](const int q) { return self_field[q]; },
        [&](const int first, const int n, const auto &batch) {
          const auto tensors = laminate_stress(batch.self_field, batch.response, batch.fraction);
          for (int lane = 0; lane < n; ++lane)
            {
              const int q         = first + lane;
              const double weight = constants::vacuum_permeability * material.cells().weight(q);
              forces.set_stress(q, -weight * inverse_spacing, lane_of(tensors, lane));
              const Vector<dim> density = material.source_gradient(first_point + q) *
                                          lane_of(batch.response.mean.magnetization, lane);
              forces.body.set(SingleVector::value, q, weight * density);
            }
        });
    }

    /** H in the material phase: the sources' and the material's own [A/m]. */
    template <int dim>
    Vector<dim>
    material_field(const Vector<dim> &source_field,
                   const typename MaterialPoints<dim>::Batch &batch,
                   const int lane)
    {
      return source_field +
             lane_of(batch.self_field + (1. - batch.fraction) * batch.response.jump, lane);
    }

    /** Whether all blocks are active that hold cells under the B-spline of a node. */
    template <int dim>
    bool
    is_covered(const BlockSet<dim> &blocks, const int slot, const int node)
    {
      // The B-spline reaches 3/2 dx: from the cell whose lower node lies two before to that one after.
      using Window           = NodeWindow<dim, 2, 1>;
      constexpr auto corners = Window::template box_offsets<2>();
      const auto &around     = blocks.neighbours(slot);
      const int first        = Window::of_block(node) - 2 * corners.back();
      for (const int corner : corners)
        if (around[Window::place(first + 3 * corner).neighbour] == invalid_slot)
          return false;
      return true;
    }

    /** int f N_i H and int f N_i. */
    struct WeightedField
    {
      static constexpr NodeVector<WeightedField> field  = {0};
      static constexpr NodeScalar<WeightedField> weight = {n_lanes - 1};

      template <typename Function>
      static constexpr void
      for_each(Function &&f)
      {
        f(field);
        f(weight);
      }
    };
  } // namespace

  template <int dim>
  void
  compute_split_force(const EllipticProblem<dim> &potential,
                      const MaterialPoints<dim> &material,
                      const BlockPartition<dim> &partition,
                      NodeField<dim, SingleVector> &force)
  {
    const BlockSet<dim> &blocks     = partition.blocks();
    const double inverse_spacing    = 1. / material.cells().spacing();
    const CellStencil<dim> &stencil = material.cells().stencil();
    force.reinit(blocks.size());

    for_active_cells(
      potential, material, [&](const unsigned int cell, const PointVectors<dim> &self_field) {
        PointForces<dim> forces;
        const unsigned int first = material.first_point(cell);
        if (first != material.none)
          set_forces(material, first, self_field, inverse_spacing, forces);
        else
          for (int q = 0; q < n_points<dim>; ++q)
            forces.set_stress(q,
                              -constants::vacuum_permeability * material.cells().weight(q) *
                                inverse_spacing,
                              vacuum_stress(self_field[q]));
        StencilValues<dim> nodes = {};
        for (int axis = 0; axis < dim; ++axis)
          stencil.add_tested_by_derivative(forces.stress[axis], axis, nodes);
        if (first != material.none)
          stencil.add_tested(forces.body, nodes);
        material.cells().scatter_add(nodes, cell, force);
      });

    partition.add_ghosts_to_owners(force);
    for_nodes(blocks, [&](const int slot, const int node) {
      if (!is_covered<dim>(blocks, slot, node))
        force.set(SingleVector::value, slot, node, {});
    });
  }

  template <int dim>
  void
  compute_material_field(const EllipticProblem<dim> &potential,
                         const MaterialPoints<dim> &material,
                         const BlockPartition<dim> &partition,
                         NodeField<dim, SingleVector> &field)
  {
    const BlockSet<dim> &blocks     = partition.blocks();
    const CellStencil<dim> &stencil = material.cells().stencil();
    NodeField<dim, WeightedField> sums(blocks.size());
    for_active_cells(
      potential, material, [&](const unsigned int cell, const PointVectors<dim> &self_field) {
        const unsigned int first = material.first_point(cell);
        if (first == material.none)
          return;
        PointValues<dim> values = {};
        material.for_batches(
          first,
          [&](const int q) { return self_field[q]; },
          [&](const int first_of_batch, const int n, const auto &batch) {
            for (int lane = 0; lane < n; ++lane)
              {
                const int q         = first_of_batch + lane;
                const double weight = material.cells().weight(q) *
                                      material.volume_fraction(first + q);
                const Vector<dim> total =
                  material_field(material.source_field(first + q), batch, lane);
                values.set(WeightedField::field, q, weight * total);
                values.set(WeightedField::weight, q, weight);
              }
          });
        StencilValues<dim> nodes = {};
        stencil.add_tested(values, nodes);
        material.cells().scatter_add(nodes, cell, sums);
      });

    partition.add_ghosts_to_owners(sums);
    field.reinit(blocks.size());
    for_nodes(blocks, [&](const int slot, const int node) {
      const double weight = sums.get(WeightedField::weight, slot, node);
      Vector<dim> mean    = sums.get(WeightedField::field, slot, node);
      for (int d = 0; d < dim && weight > 0.; ++d)
        mean[d] /= weight;
      field.set(SingleVector::value, slot, node, mean);
    });
    partition.update_ghosts(field);
  }

  template <int dim>
  std::vector<MaterialSample<dim>>
  sample_material(const EllipticProblem<dim> &potential, const MaterialPoints<dim> &material)
  {
    std::vector<MaterialSample<dim>> samples(material.size());
    for_active_cells(
      potential, material, [&](const unsigned int cell, const PointVectors<dim> &self_field) {
        const unsigned int first = material.first_point(cell);
        if (first == material.none)
          return;
        material.for_batches(
          first,
          [&](const int q) { return self_field[q]; },
          [&](const int first_of_batch, const int n, const auto &batch) {
            for (int lane = 0; lane < n; ++lane)
              {
                const int q              = first_of_batch + lane;
                const unsigned int point = first + q;
                samples[point]           = {material.cells().point(cell, q),
                                            material.cells().weight(q),
                                            material.volume_fraction(point),
                                            material_field(material.source_field(point), batch, lane),
                                            lane_of(batch.response.mean.magnetization, lane),
                                            material.fraction(point) * material.number_density(point)};
              }
          });
      });
    return samples;
  }

#define MAGMPM_INSTANTIATE(dim)                                                           \
  template void compute_split_force(const EllipticProblem<dim> &,                         \
                                    const MaterialPoints<dim> &,                          \
                                    const BlockPartition<dim> &,                          \
                                    NodeField<dim, SingleVector> &);                      \
  template void compute_material_field(const EllipticProblem<dim> &,                      \
                                       const MaterialPoints<dim> &,                       \
                                       const BlockPartition<dim> &,                       \
                                       NodeField<dim, SingleVector> &);                   \
  template std::vector<MaterialSample<dim>> sample_material(const EllipticProblem<dim> &, \
                                                            const MaterialPoints<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
