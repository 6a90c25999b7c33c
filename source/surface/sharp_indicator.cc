#include <magmpm/lattice/node_window.h>
#include <magmpm/mesh/mirror_images.h>
#include <magmpm/mesh/node_filters.h>
#include <magmpm/surface/sharp_indicator.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr double lowest_correction  = 0.5;
    constexpr double highest_correction = 5.;
    constexpr int n_smoothing_passes    = 3;

    /** Nodes that hold less than this of their cell get no correction: f falls off faster than v. */
    constexpr double negligible_volume = 1e-9;

    /** A clipped correction counts where a node holds more than this of its cell. */
    constexpr double counted_volume = 1e-3;
  } // namespace

  template <int dim>
  void
  SharpIndicator<dim>::reinit(const BlockPartition<dim> &partition,
                              const Lattice<dim> &lattice,
                              const std::array<bool, 2 * dim> &shielded,
                              const LatticeCells<dim> &cells,
                              const NodeField<dim> &volumes,
                              const std::function<bool(const Vector<dim> &)> &is_excluded)
  {
    sharp.reinit(partition, lattice, shielded, volumes);

    points.clear();
    first_point_of_cell.assign(cells.size(), none);
    NodeField<dim> field; // int f N_i, then q
    field.reinit(partition.blocks().size());
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      if (cells.is_active(cell))
        find_fractions(cells, cell, is_excluded, field);
    find_correction(partition, lattice, shielded, volumes, field);
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      if (first_point_of_cell[cell] != none)
        complete_points(cells, cell, field);
  }

  template <int dim>
  void
  SharpIndicator<dim>::find_fractions(const LatticeCells<dim> &cells,
                                      const unsigned int cell,
                                      const std::function<bool(const Vector<dim> &)> &is_excluded,
                                      NodeField<dim> &tested_fraction)
  {
    using Sharp             = SharpFraction<dim>;
    const double per_volume = 1. / std::pow(cells.spacing(), dim);
    StencilValues<dim> nodes;
    PointValues<dim> values;
    cells.gather(sharp.field(), cell, nodes);
    bool has_volume = false;
    for (int i = 0; i < n_stencil_nodes<dim> && !has_volume; ++i)
      has_volume = nodes[i * n_lanes + Sharp::volume] > 0.;
    if (!has_volume)
      return;

    cells.stencil().interpolate(nodes, values);
    std::array<Point, n_points<dim>> here;
    bool has_material = false;
    for (int q = 0; q < n_points<dim>; ++q)
      {
        double *lanes    = &values[q * n_lanes];
        double &fraction = here[q].fraction;
        fraction         = Sharp::fraction(lanes[Sharp::volume], lanes[Sharp::full]);
        if (fraction > 0. && is_excluded(cells.point(cell, q)))
          fraction = 0.;
        has_material = has_material || fraction > 0.;
        std::fill_n(lanes, n_lanes, 0.);
        lanes[0] = fraction * cells.weight(q) * per_volume;
      }
    if (!has_material)
      return;

    first_point_of_cell[cell] = static_cast<unsigned int>(points.size());
    points.insert(points.end(), here.begin(), here.end());
    nodes.fill(0.);
    cells.stencil().add_tested(values, nodes);
    cells.scatter_add(nodes, cell, tested_fraction);
  }

  template <int dim>
  void
  SharpIndicator<dim>::find_correction(const BlockPartition<dim> &partition,
                                       const Lattice<dim> &lattice,
                                       const std::array<bool, 2 * dim> &shielded,
                                       const NodeField<dim> &volumes,
                                       NodeField<dim> &field)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    partition.add_ghosts_to_owners(field);
    partition.update_ghosts(field);
    add_mirror_images(partition, lattice, shielded, field);

    // Smoothed together: lane 0 is W, lane 1 is A; then lane 0 is their ratio.
    const auto smooth_passes = [&] {
      for (int pass = 0; pass < n_smoothing_passes; ++pass)
        {
          smooth(partition, field);
          copy_mirror_images(partition, lattice, shielded, field);
        }
    };
    for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
      field.node(slot, node)[1] = volumes.node(slot, node)[0];
    });
    smooth_passes();

    clipped_corrections = 0;
    for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
      double *lanes         = field.node(slot, node);
      const bool has_volume = lanes[0] > negligible_volume;
      const double ratio    = has_volume ? lanes[1] / lanes[0] : 1.;
      lanes[0]              = std::clamp(ratio, lowest_correction, highest_correction);
      clipped_corrections += slot < blocks.n_owned() && lanes[1] > counted_volume &&
                             ratio != lanes[0];
      lanes[1] = 0.;
    });
    smooth_passes();
  }

  template <int dim>
  void
  SharpIndicator<dim>::complete_points(const LatticeCells<dim> &cells,
                                       const unsigned int cell,
                                       const NodeField<dim> &correction)
  {
    const auto first = points.begin() + first_point_of_cell[cell];
    StencilValues<dim> nodes;
    PointValues<dim> values;
    cells.gather(correction, cell, nodes);
    cells.stencil().interpolate(nodes, values);
    for (int q = 0; q < n_points<dim>; ++q)
      first[q].correction = values[q * n_lanes];

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
          gradient[d] = derivatives[d][q * n_lanes + SharpFraction<dim>::volume];
        first[q].normal = SharpFraction<dim>::normal(gradient);
      }
  }

  template class SharpIndicator<2>;
  template class SharpIndicator<3>;
} // namespace magmpm
