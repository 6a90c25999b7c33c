#include <magmpm/magnetics/material_points.h>
#include <magmpm/mesh/mirror_images.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** Lanes of the content. */
    enum ContentLane
    {
      volume,
      saturation,
      susceptibility,
      grains
    };

    /**
     * Of |grad v| dx, at which the normal has lost 30 % of its length: at surfaces |grad v| dx is about
     * 1/2, in the middle of isolated particles and thin sheets 0.
     */
    constexpr double smallest_gradient = 1e-3;
  } // namespace

  template <int dim>
  MaterialPoints<dim>::MaterialPoints(const BackgroundMesh<dim> &mesh,
                                      const BlockPartition<dim> &partition,
                                      const MagneticsParameters<dim> &parameters)
    : partition(partition)
    , the_lattice(mesh.lattice())
    , law(parameters.model())
    , is_sharp(parameters.indicator == MaterialIndicator::sharp)
    , shielded(parameters.shielded)
    , the_stencil(mesh.parameters().cell_edge)
  {
    const double half_edge = 0.5 * mesh.parameters().cell_edge * the_lattice.spacing;
    for (int q = 0; q < n_points<dim>; ++q)
      {
        weights[q] = 1.;
        for (int d = 0, rest = q; d < dim; ++d, rest /= n_points_1d)
          {
            weights[q] *= half_edge * CellStencil<dim>::weights_1d[rest % n_points_1d];
            positions[q][d] = half_edge * CellStencil<dim>::points_1d[rest % n_points_1d];
          }
      }
  }

  template <int dim>
  void
  MaterialPoints<dim>::reinit(const std::vector<Index<dim>> &lattice_cells,
                              const NodeField<dim> &content,
                              const ExternalField<dim> &sources)
  {
    NodeField<dim> mirrored(content);
    add_mirror_images(partition, the_lattice, shielded, mirrored);

    points.clear();
    total_weight = 0.;
    first_moment = Vector<dim>();
    locate_cells(lattice_cells);
    if (is_sharp)
      find_fractions(mirrored, sources);
    else
      find_smeared_cells(mirrored);
    for (const Cell &cell : cells)
      if (cell.first_point != none)
        set_medium(cell, mirrored, sources);
  }

  template <int dim>
  void
  MaterialPoints<dim>::locate_cells(const std::vector<Index<dim>> &lattice_cells)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    cells.assign(lattice_cells.size(), Cell());
    for (std::size_t c = 0; c < cells.size(); ++c)
      {
        const Index<dim> block = block_of<dim>(lattice_cells[c]);
        const int slot         = blocks.slot(block);
        if (slot == invalid_slot || slot >= blocks.n_owned())
          continue;
        cells[c].slot     = slot;
        cells[c].position = the_lattice.node_position(lattice_cells[c]);
        for (int d = 0; d < dim; ++d)
          cells[c].corner[d] = lattice_cells[c][d] - block_edge * block[d];
      }
  }

  template <int dim>
  void
  MaterialPoints<dim>::find_fractions(const NodeField<dim> &content,
                                      const ExternalField<dim> &sources)
  {
    the_indicator.reinit(partition, the_lattice, shielded, content);
    NodeField<dim> tested_fraction;
    tested_fraction.reinit(partition.blocks().size());
    for (Cell &cell : cells)
      if (cell.slot != invalid_slot)
        find_fractions_of_cell(cell, sources, tested_fraction);
    the_indicator.set_correction(partition, the_lattice, shielded, content, tested_fraction);
  }

  template <int dim>
  void
  MaterialPoints<dim>::find_fractions_of_cell(Cell &cell,
                                              const ExternalField<dim> &sources,
                                              NodeField<dim> &tested_fraction)
  {
    using Indicator             = SharpIndicator<dim>;
    const BlockSet<dim> &blocks = partition.blocks();
    const double per_volume     = 1. / std::pow(the_lattice.spacing, dim);
    StencilValues<dim> nodes;
    PointValues<dim> values;
    the_stencil.gather(the_indicator.field(), blocks, cell.slot, cell.corner, nodes);
    bool has_volume = false;
    for (int i = 0; i < n_stencil_nodes<dim> && !has_volume; ++i)
      has_volume = nodes[i * n_lanes + Indicator::volume] > 0.;
    if (!has_volume)
      return;

    the_stencil.interpolate(nodes, values);
    std::array<double, n_points<dim>> fractions;
    bool has_material = false;
    for (int q = 0; q < n_points<dim>; ++q)
      {
        double *lanes = &values[q * n_lanes];
        fractions[q]  = Indicator::fraction(lanes[Indicator::volume], lanes[Indicator::full]);
        if (fractions[q] > 0. && sources.is_solid(cell.position + positions[q]))
          fractions[q] = 0.;
        has_material = has_material || fractions[q] > 0.;
        std::fill_n(lanes, n_lanes, 0.);
        lanes[0] = fractions[q] * weights[q] * per_volume;
      }
    if (!has_material)
      return;

    cell.first_point = size();
    points.resize(points.size() + n_points<dim>);
    for (int q = 0; q < n_points<dim>; ++q)
      {
        points[cell.first_point + q].fraction        = fractions[q];
        points[cell.first_point + q].volume_fraction = fractions[q];
      }
    nodes.fill(0.);
    the_stencil.add_tested(values, nodes);
    the_stencil.scatter_add(nodes, blocks, cell.slot, cell.corner, tested_fraction);
  }

  template <int dim>
  void
  MaterialPoints<dim>::find_smeared_cells(const NodeField<dim> &content)
  {
    StencilValues<dim> nodes;
    for (Cell &cell : cells)
      if (cell.slot != invalid_slot)
        {
          the_stencil.gather(content, partition.blocks(), cell.slot, cell.corner, nodes);
          for (int i = 0; i < n_stencil_nodes<dim> && cell.first_point == none; ++i)
            if (nodes[i * n_lanes + susceptibility] > 0.)
              cell.first_point = size();
          if (cell.first_point != none)
            points.resize(points.size() + n_points<dim>);
        }
  }

  template <int dim>
  bool
  MaterialPoints<dim>::has_surface(const Cell &cell) const
  {
    const auto first = points.begin() + cell.first_point;
    return std::any_of(first, first + n_points<dim>, [](const Point &point) {
      return point.fraction > 0. && point.fraction < nearly_full;
    });
  }

  template <int dim>
  void
  MaterialPoints<dim>::set_normals(const Cell &cell)
  {
    StencilValues<dim> nodes;
    std::array<PointValues<dim>, dim> derivatives;
    the_stencil.gather(the_indicator.field(), partition.blocks(), cell.slot, cell.corner, nodes);
    for (int d = 0; d < dim; ++d)
      the_stencil.interpolate_derivative(nodes, d, derivatives[d]);
    for (int q = 0; q < n_points<dim>; ++q)
      {
        Vector<dim> gradient;
        for (int d = 0; d < dim; ++d)
          gradient[d] = derivatives[d][q * n_lanes + SharpIndicator<dim>::volume];
        points[cell.first_point + q].normal =
          (1. / std::sqrt(norm_square(gradient) + smallest_gradient * smallest_gradient)) *
          gradient;
      }
  }

  template <int dim>
  void
  MaterialPoints<dim>::set_medium(const Cell &cell,
                                  const NodeField<dim> &content,
                                  const ExternalField<dim> &sources)
  {
    StencilValues<dim> nodes;
    PointValues<dim> contents, corrections;
    the_stencil.gather(content, partition.blocks(), cell.slot, cell.corner, nodes);
    the_stencil.interpolate(nodes, contents);
    if (is_sharp)
      {
        the_stencil.gather(
          the_indicator.field(), partition.blocks(), cell.slot, cell.corner, nodes);
        the_stencil.interpolate(nodes, corrections);
        if (has_surface(cell))
          set_normals(cell);
      }

    for (int q = 0; q < n_points<dim>; ++q)
      {
        Point &point        = points[cell.first_point + q];
        const double *lanes = &contents[q * n_lanes];
        double density      = 1.; // of the medium over that of the content
        if (is_sharp)
          density = corrections[q * n_lanes + SharpIndicator<dim>::correction] / lanes[volume];
        else
          {
            point.fraction        = (lanes[susceptibility] > 0. ? 1. : 0.);
            point.volume_fraction = lanes[volume];
          }
        if (!(point.fraction > 0.))
          continue;

        const Vector<dim> position             = cell.position + positions[q];
        point.content.saturation_magnetization = density * lanes[saturation];
        point.content.initial_susceptibility   = density * lanes[susceptibility];
        point.number_density                   = density * lanes[grains];
        sources.check_material_at(position);
        point.field    = sources.field(position);
        point.gradient = sources.field_gradient(position);
      }
    add_magnetized_weight(cell);
  }

  template <int dim>
  void
  MaterialPoints<dim>::add_magnetized_weight(const Cell &cell)
  {
    const auto no_self_field = [](const int) { return Vector<dim>(); };
    for_batches(
      cell.first_point, no_self_field, [&](const int first, const int n, const Batch &batch) {
        const Lanes magnetization = norm(batch.response.mean.magnetization);
        for (int lane = 0; lane < n; ++lane)
          {
            const double weight = weights[first + lane] * magnetization[lane];
            total_weight += weight;
            first_moment += weight * (cell.position + positions[first + lane]);
          }
      });
  }

  template <int dim>
  double
  MaterialPoints<dim>::respond(const unsigned int lattice_cell,
                               PointVectors<dim> &flux,
                               PointMatrices<dim> &tangent) const
  {
    double coenergy = 0.;
    for_batches(
      cells[lattice_cell].first_point,
      [&flux](const int q) { return -1. * flux[q]; },
      [&](const int first, const int n, const Batch &batch) {
        const auto &mean = batch.response.mean;
        for (int lane = 0; lane < n; ++lane)
          {
            const int q = first + lane;
            coenergy += mean.coenergy[lane] * weights[q];
            for (int i = 0; i < dim; ++i)
              {
                flux[q][i] -= mean.magnetization[i][lane];
                for (int j = 0; j < dim; ++j)
                  tangent[q](i, j) = (i == j ? 1. : 0.) + mean.tangent(i, j)[lane];
              }
          }
      });
    return coenergy;
  }

  template class MaterialPoints<2>;
  template class MaterialPoints<3>;
} // namespace magmpm
