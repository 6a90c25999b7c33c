#include <magmpm/lattice/node_window.h>
#include <magmpm/mesh/node_filters.h>
#include <magmpm/surface/sharp_indicator.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr double lowest_correction  = 0.5;
    constexpr double highest_correction = 5.;

    /** Nodes that hold less than this of their cell get no correction: f falls off faster than v. */
    constexpr double negligible_volume = 1e-9;

    /** A clipped correction counts where a node holds more than this of its cell. */
    constexpr double counted_volume = 1e-3;

    /** W and A. */
    struct TestedAndScattered
    {
      static constexpr NodeScalar<TestedAndScattered> tested    = {0};
      static constexpr NodeScalar<TestedAndScattered> scattered = {1};

      template <typename Function>
      static constexpr void
      for_each(Function &&f)
      {
        f(tested);
        f(scattered);
      }
    };

    /** S. */
    template <int dim>
    void
    smooth_thrice(const BlockPartition<dim> &partition, NodeNumbers<dim> &field)
    {
      for (int pass = 0; pass < 3; ++pass)
        smooth(partition, field);
    }
  } // namespace

  template <int dim>
  void
  SharpIndicator<dim>::reinit(const BlockPartition<dim> &partition,
                              const LatticeCells<dim> &cells,
                              const NodeField<dim, SingleScalar> &volumes,
                              const std::function<bool(const Vector<dim> &)> &is_excluded)
  {
    sharp.reinit(partition, volumes);

    points.clear();
    first_point_of_cell.assign(cells.size(), none);
    NodeField<dim, SingleScalar> field(partition.blocks().size()); // int f N_i, then q
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      if (cells.is_active(cell))
        find_fractions(cells, cell, is_excluded, field);
    find_correction(partition, volumes, field);
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      if (first_point_of_cell[cell] != none)
        complete_points(cells, cell, field);
  }

  template <int dim>
  void
  SharpIndicator<dim>::find_fractions(const LatticeCells<dim> &cells,
                                      const unsigned int cell,
                                      const std::function<bool(const Vector<dim> &)> &is_excluded,
                                      NodeField<dim, SingleScalar> &tested_fraction)
  {
    using Nodes             = typename SharpFraction<dim>::Nodes;
    const double per_volume = 1. / std::pow(cells.spacing(), dim);
    StencilValues<dim> nodes;
    PointValues<dim> values;
    cells.gather(sharp.field(), cell, nodes);
    bool has_volume = false;
    for (int i = 0; i < n_stencil_nodes<dim> && !has_volume; ++i)
      has_volume = nodes.get(Nodes::volume, i) > 0.;
    if (!has_volume)
      return;

    cells.stencil().interpolate(nodes, values);
    std::array<Point, n_points<dim>> here;
    bool has_material = false;
    for (int q = 0; q < n_points<dim>; ++q)
      {
        double &fraction = here[q].fraction;
        fraction         = SharpFraction<dim>::fraction(values.get(Nodes::volume, q),
                                                values.get(Nodes::full, q));
        if (fraction > 0. && is_excluded(cells.point(cell, q)))
          fraction = 0.;
        has_material = has_material || fraction > 0.;
      }
    if (!has_material)
      return;

    first_point_of_cell[cell] = static_cast<unsigned int>(points.size());
    points.insert(points.end(), here.begin(), here.end());
    values.fill(0.);
    for (int q = 0; q < n_points<dim>; ++q)
      values.set(SingleScalar::value, q, here[q].fraction * cells.weight(q) * per_volume);
    nodes.fill(0.);
    cells.stencil().add_tested(values, nodes);
    cells.scatter_add(nodes, cell, tested_fraction);
  }

  template <int dim>
  void
  SharpIndicator<dim>::find_correction(const BlockPartition<dim> &partition,
                                       const NodeField<dim, SingleScalar> &volumes,
                                       NodeField<dim, SingleScalar> &field)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    partition.add_ghosts_to_owners(field, Parity());
    partition.update_ghosts(field);

    using Both = TestedAndScattered;
    NodeField<dim, Both> both(blocks.size());
    for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
      both.set(Both::tested, slot, node, field.get(SingleScalar::value, slot, node));
      both.set(Both::scattered, slot, node, volumes.get(SingleScalar::value, slot, node));
    });
    smooth_thrice(partition, both);

    clipped_corrections = 0;
    for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
      const double tested    = both.get(Both::tested, slot, node);
      const double scattered = both.get(Both::scattered, slot, node);
      const double ratio     = (tested > negligible_volume ? scattered / tested : 1.);
      const double clipped   = std::clamp(ratio, lowest_correction, highest_correction);
      clipped_corrections += slot < blocks.n_owned() && scattered > counted_volume &&
                             ratio != clipped;
      field.set(SingleScalar::value, slot, node, clipped);
    });
    smooth_thrice(partition, field);
  }

  template <int dim>
  void
  SharpIndicator<dim>::complete_points(const LatticeCells<dim> &cells,
                                       const unsigned int cell,
                                       const NodeField<dim, SingleScalar> &correction)
  {
    const auto first = points.begin() + first_point_of_cell[cell];
    StencilValues<dim> nodes;
    PointValues<dim> values;
    cells.gather(correction, cell, nodes);
    cells.stencil().interpolate(nodes, values);
    for (int q = 0; q < n_points<dim>; ++q)
      first[q].correction = values.get(SingleScalar::value, q);

    // Where all is full, or empty, no normal is asked for.
    if (std::none_of(first, first + n_points<dim>, [](const Point &point) {
          return point.fraction > 0. && point.fraction < 1.;
        }))
      return;
    std::array<PointValues<dim>, dim> derivatives;
    cells.gather(sharp.field(), cell, nodes);
    for (int d = 0; d < dim; ++d)
      cells.stencil().interpolate_derivative(nodes, d, derivatives[d]);
    for (int q = 0; q < n_points<dim>; ++q)
      {
        Vector<dim> gradient;
        for (int d = 0; d < dim; ++d)
          gradient[d] = derivatives[d].get(SharpFraction<dim>::Nodes::volume, q);
        first[q].normal = SharpFraction<dim>::normal(gradient);
      }
  }

  template class SharpIndicator<2>;
  template class SharpIndicator<3>;
} // namespace magmpm
