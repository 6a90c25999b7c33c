#include <magmpm/base/exceptions.h>
#include <magmpm/lattice/bspline.h>

#include <baselines/paper_scheme/material_nodes.h>

#include <algorithm>

namespace magmpm::paper_scheme
{
  namespace
  {
    /** The lower corner and the size of the box of nodes that particles reach. */
    template <int dim>
    std::pair<Index<dim>, Index<dim>>
    reached_box(const NodeGrid<dim> &grid, const std::vector<Particle<dim>> &particles)
    {
      // The stress is differenced on all reached nodes, and the potential on all nodes around them.
      constexpr int margin = 2;
      Index<dim> lowest, extent;
      for (int a = 0; a < dim; ++a)
        {
          double low = particles.front().position[a], high = low;
          for (const Particle<dim> &particle : particles)
            {
              low  = std::min(low, particle.position[a]);
              high = std::max(high, particle.position[a]);
            }
          Vector<dim> corner;
          corner[a]        = low;
          lowest[a]        = grid.base_node(corner)[a];
          corner[a]        = high;
          const int higher = grid.base_node(corner)[a] + stencil_width - 1;
          if (!(lowest[a] >= margin && higher <= grid.n_cells[a] - margin))
            throw InputError(
              "A particle lies closer than 2.5 dx to a face of the potential box (its "
              "coordinates along axis " +
              std::to_string(a) + " reach from " + std::to_string(low) + " to " +
              std::to_string(high) + " m); make the box larger.");
          extent[a] = higher + 1 - lowest[a];
        }
      return {lowest, extent};
    }

    template <int dim>
    void
    scatter(const NodeGrid<dim> &grid,
            const NodeGrid<dim> &box,
            const Particle<dim> &particle,
            std::vector<MaterialNode<dim>> &nodes)
    {
      const Index<dim> base     = box.base_node(particle.position);
      const Vector<dim> reduced = box.reduced(particle.position);
      double weights[dim][stencil_width];
      for (int a = 0; a < dim; ++a)
        quadratic_bspline(reduced[a] - base[a], weights[a]);
      for (int i = 0; i < power(stencil_width, dim); ++i)
        {
          double volume     = particle.volume;
          Index<dim> target = base;
          for (int a = 0, rest = i; a < dim; ++a, rest /= stencil_width)
            {
              target[a] += rest % stencil_width;
              volume *= weights[a][rest % stencil_width];
            }
          MaterialNode<dim> &node = nodes[box.number(target)];
          const double density    = volume / std::pow(grid.spacing, dim);
          node.volume += volume;
          node.content.saturation_magnetization += density *
                                                   particle.content.saturation_magnetization;
          node.content.initial_susceptibility += density * particle.content.initial_susceptibility;
        }
      nodes[box.number(box.nearest_node(particle.position))].has_particle = true;
    }
  } // namespace

  template <int dim>
  std::vector<MaterialNode<dim>>
  material_nodes(const NodeGrid<dim> &grid,
                 const std::vector<Particle<dim>> &particles,
                 const ExternalField<dim> &sources)
  {
    if (particles.empty())
      return {};
    const auto [lowest, extent] = reached_box(grid, particles);
    const NodeGrid<dim> box(grid.node_position(lowest), extent, grid.spacing);
    std::vector<MaterialNode<dim>> nodes(box.size());
    for (const Particle<dim> &particle : particles)
      scatter(grid, box, particle, nodes);

    for (std::ptrdiff_t i = 0; i < box.size(); ++i)
      for (int a = 0; a < dim; ++a)
        nodes[i].node[a] = lowest[a] + box.node(i)[a];
    nodes.erase(std::remove_if(nodes.begin(),
                               nodes.end(),
                               [](const MaterialNode<dim> &node) { return !(node.volume > 0.); }),
                nodes.end());
    for (MaterialNode<dim> &node : nodes)
      {
        node.position     = grid.node_position(node.node);
        node.source_field = sources.field(node.position);
      }
    return nodes;
  }

  template std::vector<MaterialNode<2>>
  material_nodes(const NodeGrid<2> &, const std::vector<Particle<2>> &, const ExternalField<2> &);
  template std::vector<MaterialNode<3>>
  material_nodes(const NodeGrid<3> &, const std::vector<Particle<3>> &, const ExternalField<3> &);
} // namespace magmpm::paper_scheme
