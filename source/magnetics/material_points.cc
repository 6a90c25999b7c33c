#include <magmpm/magnetics/material_points.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    enum ContentLane
    {
      volume,
      saturation,
      susceptibility
    };

    bool
    is_magnetic(const double *content)
    {
      return content[susceptibility] > 0.;
    }
  } // namespace

  template <int dim>
  void
  MaterialPoints<dim>::reinit(const std::vector<Index<dim>> &lattice_cells,
                              const BlockSet<dim> &blocks,
                              const NodeField<dim> &content,
                              const ExternalField<dim> &sources,
                              const Lattice<dim> &lattice,
                              const MagnetizationLaw law)
  {
    this->law = law;
    cells.assign(lattice_cells.size(), Cell());
    points.clear();
    total_weight = 0.;
    first_moment = Vector<dim>();
    for (int q = 0; q < n_points<dim>; ++q)
      {
        weights[q] = 1.;
        for (int d = 0, rest = q; d < dim; ++d, rest /= n_points_1d)
          {
            weights[q] *= lattice.spacing * CellStencil<dim>::weights_1d[rest % n_points_1d];
            positions[q][d] = lattice.spacing * CellStencil<dim>::points_1d[rest % n_points_1d];
          }
      }

    StencilValues<dim> nodes;
    PointValues<dim> values;
    for (std::size_t c = 0; c < cells.size(); ++c)
      {
        const Index<dim> block = block_of<dim>(lattice_cells[c]);
        const int slot         = blocks.slot(block);
        if (slot == invalid_slot || slot >= blocks.n_owned())
          continue;
        cells[c].slot = slot;
        for (int d = 0; d < dim; ++d)
          cells[c].corner[d] = lattice_cells[c][d] - block_edge * block[d];

        stencil.gather(content, blocks, slot, cells[c].corner, nodes);
        bool has_material = false;
        for (int i = 0; i < n_stencil_nodes<dim> && !has_material; ++i)
          has_material = is_magnetic(&nodes[i * n_lanes]);
        if (!has_material)
          continue;
        stencil.interpolate(nodes, values);
        cells[c].first_point = size();
        cells[c].position    = lattice.node_position(lattice_cells[c]);
        add_cell(lattice_cells[c], values, sources, lattice);
      }
  }

  template <int dim>
  void
  MaterialPoints<dim>::add_cell(const Index<dim> &lower_node,
                                const PointValues<dim> &content,
                                const ExternalField<dim> &sources,
                                const Lattice<dim> &lattice)
  {
    const Vector<dim> corner = lattice.node_position(lower_node);
    for (int q = 0; q < n_points<dim>; ++q)
      {
        const double *lanes = &content[q * n_lanes];
        points.emplace_back();
        Point &point = points.back();
        if (!is_magnetic(lanes))
          continue;

        const Vector<dim> position             = corner + positions[q];
        point.content.saturation_magnetization = lanes[saturation];
        point.content.initial_susceptibility   = lanes[susceptibility];
        point.volume_fraction                  = lanes[ContentLane::volume];
        point.field                            = sources.field(position);
        point.gradient                         = sources.field_gradient(position);

        const double magnetization = norm(response(size() - 1, Vector<dim>()).magnetization);
        total_weight += weights[q] * magnetization;
        first_moment += (weights[q] * magnetization) * position;
      }
  }

  template <int dim>
  MagneticResponse<dim>
  MaterialPoints<dim>::response(const unsigned int number, const Vector<dim> &self_field) const
  {
    const Point &point = points[number];
    if (!(point.content.initial_susceptibility > 0.))
      return MagneticResponse<dim>();
    return magnetic_response<dim>(law, point.content, point.field + self_field);
  }

  template class MaterialPoints<2>;
  template class MaterialPoints<3>;
} // namespace magmpm
