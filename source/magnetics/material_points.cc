#include <magmpm/lattice/node_window.h>
#include <magmpm/magnetics/material_points.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  MaterialPoints<dim>::MaterialPoints(const BackgroundMesh<dim> &mesh,
                                      const BlockPartition<dim> &partition,
                                      const MagneticsParameters<dim> &parameters)
    : partition(partition)
    , lattice(mesh.lattice())
    , law(parameters.model())
    , is_sharp(parameters.indicator == MaterialIndicator::sharp)
    , the_cells(lattice, mesh.parameters().cell_edge)
  {
  }

  template <int dim>
  void
  MaterialPoints<dim>::reinit(const std::vector<Index<dim>> &lattice_cells,
                              const NodeField<dim, NodeContent> &content,
                              const ExternalField<dim> &sources)
  {
    the_cells.reinit(lattice_cells, partition.blocks());
    if (is_sharp)
      {
        NodeField<dim, SingleScalar> volumes(partition.blocks().size());
        for_nodes_and_ghosts(partition.blocks(), [&](const int slot, const int node) {
          volumes.set(
            SingleScalar::value, slot, node, content.get(NodeContent::volume, slot, node));
        });
        the_indicator.reinit(partition, the_cells, volumes, [&sources](const Vector<dim> &x) {
          return sources.is_solid(x);
        });
        first_points = the_indicator.first_points();
      }
    else
      find_smeared_cells(content);

    points.clear();
    total_weight = 0.;
    first_moment = Vector<dim>();
    for (unsigned int cell = 0; cell < the_cells.size(); ++cell)
      if (first_points[cell] != none)
        set_medium(cell, content, sources);
  }

  template <int dim>
  void
  MaterialPoints<dim>::find_smeared_cells(const NodeField<dim, NodeContent> &content)
  {
    unsigned int n_found = 0;
    StencilValues<dim> nodes;
    first_points.assign(the_cells.size(), none);
    for (unsigned int cell = 0; cell < the_cells.size(); ++cell)
      if (the_cells.is_active(cell))
        {
          the_cells.gather(content, cell, nodes);
          for (int i = 0; i < n_stencil_nodes<dim> && first_points[cell] == none; ++i)
            if (nodes.get(NodeContent::susceptibility, i) > 0.)
              first_points[cell] = n_points<dim> * n_found++;
        }
  }

  template <int dim>
  void
  MaterialPoints<dim>::set_medium(const unsigned int cell,
                                  const NodeField<dim, NodeContent> &content,
                                  const ExternalField<dim> &sources)
  {
    StencilValues<dim> nodes;
    PointValues<dim> contents;
    the_cells.gather(content, cell, nodes);
    the_cells.stencil().interpolate(nodes, contents);

    for (int q = 0; q < n_points<dim>; ++q)
      {
        points.emplace_back();
        Point &point   = points.back();
        double density = 1.; // of the medium over that of the content
        if (is_sharp)
          {
            const auto &at = the_indicator.point(first_points[cell] + q);
            point.fraction = point.volume_fraction = at.fraction;
            point.normal                           = at.normal;
            density = at.correction / contents.get(NodeContent::volume, q);
          }
        else
          {
            point.fraction        = (contents.get(NodeContent::susceptibility, q) > 0. ? 1. : 0.);
            point.volume_fraction = contents.get(NodeContent::volume, q);
          }
        if (!(point.fraction > 0.))
          continue;

        const Vector<dim> position             = the_cells.point(cell, q);
        point.content.saturation_magnetization = density * contents.get(NodeContent::saturation, q);
        point.content.initial_susceptibility   = density *
                                               contents.get(NodeContent::susceptibility, q);
        point.number_density = density * contents.get(NodeContent::grains, q);
        sources.check_material_at(position);
        point.field    = sources.field(position);
        point.gradient = sources.field_gradient(position);
      }
    add_magnetized_weight(cell);
  }

  template <int dim>
  void
  MaterialPoints<dim>::add_magnetized_weight(const unsigned int cell)
  {
    const auto no_self_field = [](const int) { return Vector<dim>(); };
    for_batches(
      first_points[cell], no_self_field, [&](const int first, const int n, const Batch &batch) {
        const Lanes magnetization = norm(batch.response.mean.magnetization);
        for (int lane = 0; lane < n; ++lane)
          {
            const double weight = the_cells.weight(first + lane) * magnetization[lane];
            total_weight += weight;
            first_moment += weight * the_cells.point(cell, first + lane);
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
      first_points[lattice_cell],
      [&flux](const int q) { return -1. * flux[q]; },
      [&](const int first, const int n, const Batch &batch) {
        const auto &mean = batch.response.mean;
        for (int lane = 0; lane < n; ++lane)
          {
            const int q = first + lane;
            coenergy += mean.coenergy[lane] * the_cells.weight(q);
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
