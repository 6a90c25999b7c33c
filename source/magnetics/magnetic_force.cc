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

    /** h = -grad phi, at the points of QGauss(3) and in the octants. */
    template <int dim>
    struct SelfField
    {
      PointVectors<dim> at_points;
      OctantVectors<dim> in_octants;
    };

    /** Calls action(lattice cell, h) for the lattice cells of this rank that lie in owned active blocks. */
    template <int dim, typename Action>
    void
    for_active_cells(const EllipticProblem<dim> &potential,
                     const MaterialPoints<dim> &material,
                     const Action &action)
    {
      potential.for_gradients(
        [&](const unsigned int cell) { return material.cells().is_active(cell); },
        [&](const unsigned int cell,
            const PointVectors<dim> &at_points,
            const OctantVectors<dim> &in_octants) {
          SelfField<dim> h;
          for (int q = 0; q < n_points<dim>; ++q)
            h.at_points[q] = -1. * at_points[q];
          for (int q = 0; q < n_octants<dim>; ++q)
            h.in_octants[q] = -1. * in_octants[q];
          action(cell, h);
        });
    }

    /**
     * Calls action(octant, its point, batch, lane of the batch) for the points of a cell with material.
     */
    template <int dim, typename Action>
    void
    for_octants(const MaterialPoints<dim> &material,
                const unsigned int cell,
                const SelfField<dim> &h,
                const Action &action)
    {
      const unsigned int first_point = material.first_point(cell);
      if (first_point != material.none)
        material.for_batches(
          first_point,
          [&](const int octant) { return h.in_octants[octant]; },
          [&](const int first, const int n, const auto &batch) {
            for (int lane = 0; lane < n; ++lane)
              action(first + lane, first_point + first + lane, batch, lane);
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
     * What material adds to the stress of the vacuum, h (x) (h + M) - |h|^2/2 I [A^2/m^2]: the first index
     * is that of the force. The mean over the phases of a laminate, each with the fields of that phase.
     */
    template <int dim, typename Number>
    Matrix<dim, Number>
    material_stress(const Vector<dim, Number> &h,
                    const LaminateResponse<dim, Number> &medium,
                    const Number &fraction)
    {
      const Vector<dim, Number> inside  = h + (1. - fraction) * medium.jump;
      const Vector<dim, Number> outside = h - fraction * medium.jump;
      return fraction * vacuum_stress(inside) + outer(inside, medium.mean.magnetization) +
             (1. - fraction) * vacuum_stress(outside) + (-1.) * vacuum_stress(h);
    }

    /** What is tested by dN_i/dx_axis at the points of a rule, by axis. */
    template <int dim, int n>
    struct TestedStress
    {
      std::array<PointValues<dim, n>, dim> columns = {};

      void
      set(const int q, const double factor, const Matrix<dim> &tensor)
      {
        for (int axis = 0; axis < dim; ++axis)
          {
            Vector<dim> column;
            for (int d = 0; d < dim; ++d)
              column[d] = factor * tensor(d, axis);
            columns[axis].set(SingleVector::value, q, column);
          }
      }

      void
      add_to(const CellQuadrature<dim, n> &rule, StencilValues<dim> &nodes) const
      {
        for (int axis = 0; axis < dim; ++axis)
          rule.add_tested_by_derivative(columns[axis], axis, nodes);
      }
    };

    /** The part of the vacuum in the force on the nodes around a cell. */
    template <int dim>
    void
    add_vacuum_force(const CellQuadrature<dim, n_points_1d> &rule,
                     const double inverse_spacing,
                     const SelfField<dim> &h,
                     StencilValues<dim> &nodes)
    {
      TestedStress<dim, n_points_1d> stress;
      for (int q = 0; q < n_points<dim>; ++q)
        stress.set(q,
                   -constants::vacuum_permeability * rule.weight(q) * inverse_spacing,
                   vacuum_stress(h.at_points[q]));
      stress.add_to(rule, nodes);
    }

    /** What material adds to it. */
    template <int dim>
    void
    add_material_force(const MaterialPoints<dim> &material,
                       const unsigned int cell,
                       const SelfField<dim> &h,
                       StencilValues<dim> &nodes)
    {
      const double inverse_spacing = 1. / material.cells().spacing();
      TestedStress<dim, n_octants_1d> stress;
      PointValues<dim, n_octants_1d> body = {};
      for_octants(
        material,
        cell,
        h,
        [&](const int octant, const unsigned int point, const auto &batch, const int lane) {
          const double weight = constants::vacuum_permeability *
                                material.quadrature().weight(octant);
          stress.set(octant,
                     -weight * inverse_spacing,
                     lane_of(material_stress(batch.self_field, batch.response, batch.fraction),
                             lane));
          const Vector<dim> density = material.source_gradient(point) *
                                      lane_of(batch.response.mean.magnetization, lane);
          body.set(SingleVector::value, octant, weight * density);
        });
      stress.add_to(material.quadrature(), nodes);
      material.quadrature().add_tested(body, nodes);
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
    const BlockSet<dim> &blocks = partition.blocks();
    const auto vacuum_rule      = material.cells().template quadrature<n_points_1d>();
    force.reinit(blocks.size());

    for_active_cells(potential, material, [&](const unsigned int cell, const SelfField<dim> &h) {
      StencilValues<dim> nodes = {};
      add_vacuum_force(vacuum_rule, 1. / material.cells().spacing(), h, nodes);
      if (material.first_point(cell) != material.none)
        add_material_force(material, cell, h, nodes);
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
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, WeightedField> sums(blocks.size());
    for_active_cells(potential, material, [&](const unsigned int cell, const SelfField<dim> &h) {
      if (material.first_point(cell) == material.none)
        return;
      PointValues<dim, n_octants_1d> values = {};
      for_octants(
        material,
        cell,
        h,
        [&](const int octant, const unsigned int point, const auto &batch, const int lane) {
          const double weight = material.quadrature().weight(octant) *
                                material.volume_fraction(point);
          const Vector<dim> total = material_field(material.source_field(point), batch, lane);
          values.set(WeightedField::field, octant, weight * total);
          values.set(WeightedField::weight, octant, weight);
        });
      StencilValues<dim> nodes = {};
      material.quadrature().add_tested(values, nodes);
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
    for_active_cells(potential, material, [&](const unsigned int cell, const SelfField<dim> &h) {
      for_octants(
        material,
        cell,
        h,
        [&](const int octant, const unsigned int point, const auto &batch, const int lane) {
          samples[point] = {material.position(point),
                            material.quadrature().weight(octant),
                            material.volume_fraction(point),
                            material_field(material.source_field(point), batch, lane),
                            lane_of(batch.response.mean.magnetization, lane),
                            material.fraction(point) * material.number_density(point)};
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
