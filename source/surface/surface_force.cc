#include <magmpm/surface/mirrored_window.h>
#include <magmpm/surface/sharp_profile.h>
#include <magmpm/surface/surface_force.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** The largest volume around that counts as full. */
    constexpr double full_volume = 0.8;

    /** out = combine(below, here, above) along all axes of a window, one after the other. */
    template <typename Window, typename Values, typename Combine>
    void
    along_axes(const int dim, const Combine &combine, Values &values)
    {
      Values before;
      for (int axis = 0; axis < dim; ++axis)
        {
          before           = values;
          const int stride = Window::stride(axis);
          for (int i = stride; i < Window::n_nodes - stride; ++i)
            values[i] = combine(before[i - stride], before[i], before[i + stride]);
        }
    }

    /** S (c - dx^2/4 Laplace_h c), right at nodes that are two or more from the ends of the window. */
    template <typename Window, typename Values>
    void
    sharpen(const int dim, Values &values)
    {
      const Values smeared = values;
      for (int axis = 0; axis < dim; ++axis)
        {
          const int stride = Window::stride(axis);
          for (int i = stride; i < Window::n_nodes - stride; ++i)
            values[i] -= 0.25 * (smeared[i - stride] + smeared[i + stride] - 2. * smeared[i]);
        }
      along_axes<Window>(
        dim,
        [](const double below, const double here, const double above) {
          return 0.25 * (below + above) + 0.5 * here;
        },
        values);
    }

    /** The inner part of a window, without @p rim nodes on each side. */
    template <int dim, typename Outer, typename Inner, typename OuterValues, typename InnerValues>
    void
    cut(const int rim, const OuterValues &outer, InnerValues &inner)
    {
      for (int i = 0; i < Inner::n_nodes; ++i)
        {
          int place = 0;
          for (int d = 0, rest = i; d < dim; ++d, rest /= Inner::edge)
            place += (rest % Inner::edge + rim) * Outer::stride(d);
          inner[i] = outer[place];
        }
    }
  } // namespace

  template <int dim>
  SurfaceForce<dim>::SurfaceForce(const Lattice<dim> &lattice, const WettedWalls<dim> &walls)
    : lattice(lattice)
    , walls(walls)
  {
  }

  template <int dim>
  bool
  SurfaceForce<dim>::is_in_box(const Index<dim> &block, const int layers_beyond) const
  {
    for (int d = 0; d < dim; ++d)
      if (block[d] < 0 || block_edge * (block[d] - layers_beyond) >= lattice.n_cells[d])
        return false;
    return true;
  }

  template <int dim>
  void
  SurfaceForce<dim>::find_volumes(const BlockPartition<dim> &partition,
                                  const SurfaceFields<dim> &fields)
  {
    constexpr int reach = 2; // of both filters
    using Around        = MirroredWindow<dim, reach, reach>;
    using Window        = typename Around::Window;
    const auto &blocks  = partition.blocks();
    typename Around::Values values;
    volumes.reinit(blocks.size());
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      {
        // The nodes on an upper wall are those of the blocks beyond.
        const Index<dim> &block = blocks.block(slot);
        if (!is_in_box(block, 1))
          continue;
        gather_window<dim, reach, reach>(
          fields.content, blocks, slot, SurfaceContent::volume.lane, values);
        if (std::all_of(values.begin(), values.end(), [](const double c) { return c == 0.; }))
          continue;
        Around(walls.mirrors, block).add_images(values);
        sharpen<Window>(dim, values);
        for (int node = 0; node < nodes_per_block<dim>; ++node)
          volumes.set(SingleScalar::value, slot, node, values[Window::of_block(node)]);
      }
    partition.update_ghosts(volumes);
    if (fields.rigid_share.n_blocks() == 0)
      return;
    fields.images.fill(volumes);
    partition.update_ghosts(volumes);
  }

  template <int dim>
  bool
  SurfaceForce<dim>::find_nodes(const BlockSet<dim> &blocks,
                                const SurfaceFields<dim> &fields,
                                const int slot,
                                typename Stress::Nodes &nodes) const
  {
    const MirroredWindow<dim, 1, 2> window(walls.mirrors, blocks.block(slot));
    gather_window<dim, 1, 2>(volumes, blocks, slot, SingleScalar::value.lane, nodes.volume);
    window.copy_images(nodes.volume);
    const auto [least, largest] = std::minmax_element(nodes.volume.begin(), nodes.volume.end());
    if (!(*largest > 0.) ||
        (!nodes.is_uniform && !find_tension(blocks, fields.content, slot, nodes)))
      return false;
    // Beyond this f is 1, since w is at most one.
    nodes.has_surface = *least < 0.5 * (1. + sharp_transition);
    if (nodes.has_surface)
      find_full(blocks, slot, nodes.full);
    else
      nodes.full.fill(1.);
    nodes.has_bodies = fields.rigid_share.n_blocks() > 0;
    if (nodes.has_bodies)
      {
        gather_window<dim, 1, 2>(
          fields.rigid_share, blocks, slot, SingleScalar::value.lane, nodes.rigid);
        window.copy_images(nodes.rigid);
      }
    return true;
  }

  template <int dim>
  double
  SurfaceForce<dim>::wet_bodies(const BlockSet<dim> &blocks,
                                const SurfaceFields<dim> &fields,
                                const int slot,
                                const typename Stress::Nodes &nodes,
                                std::array<NodeValues, dim> &force) const
  {
    if (fields.rigid_wetting.n_blocks() == 0)
      return 0.;
    NodeValues wetting;
    gather_window<dim, 1, 2>(fields.rigid_wetting, blocks, slot, SingleScalar::value.lane, wetting);
    if (std::all_of(wetting.begin(), wetting.end(), [](const double w) { return w == 0.; }))
      return 0.;
    MirroredWindow<dim, 1, 2>(walls.mirrors, blocks.block(slot)).copy_images(wetting);
    return bodies.add_force(nodes, wetting, force);
  }

  template <int dim>
  bool
  SurfaceForce<dim>::find_tension(const BlockSet<dim> &blocks,
                                  const NodeField<dim, SurfaceContent> &content,
                                  const int slot,
                                  typename Stress::Nodes &nodes) const
  {
    const MirroredWindow<dim, 1, 2> window(walls.mirrors, blocks.block(slot));
    gather_window<dim, 1, 2>(content, blocks, slot, SurfaceContent::tension.lane, nodes.tension);
    if (std::all_of(nodes.tension.begin(), nodes.tension.end(), [](const double t) {
          return t == 0.;
        }))
      return false;
    gather_window<dim, 1, 2>(content, blocks, slot, SurfaceContent::volume.lane, nodes.content);
    window.add_images(nodes.tension);
    window.add_images(nodes.content);
    return true;
  }

  template <int dim>
  void
  SurfaceForce<dim>::find_full(const BlockSet<dim> &blocks, const int slot, NodeValues &full) const
  {
    constexpr int reach = 2; // of the maximum
    using Around        = MirroredWindow<dim, 1 + reach, 2 + reach>;
    typename Around::Values around;
    gather_window<dim, 1 + reach, 2 + reach>(
      volumes, blocks, slot, SingleScalar::value.lane, around);
    Around(walls.mirrors, blocks.block(slot)).copy_images(around);
    for (int pass = 0; pass < reach; ++pass)
      along_axes<typename Around::Window>(
        dim,
        [](const double below, const double here, const double above) {
          return std::max(here, std::max(below, above));
        },
        around);
    cut<dim, typename Around::Window, typename BlockQuadrature<dim>::Window>(reach, around, full);
    for (double &w : full)
      w = std::clamp(w / full_volume, smallest_full_volume, 1.);
  }

  template <int dim>
  void
  SurfaceForce<dim>::add_to_field(const BlockSet<dim> &blocks,
                                  const int slot,
                                  std::array<NodeValues, dim> &forces,
                                  NodeField<dim, SingleVector> &field) const
  {
    const MirroredWindow<dim, 1, 2> window(walls.mirrors, blocks.block(slot));
    for (int d = 0; d < dim; ++d)
      window.fold([&](const int face) { return walls.sticks[face] || d == face / 2 ? -1. : 1.; },
                  forces[d]);
    for (std::size_t i = 0; i < forces[0].size(); ++i)
      {
        const NodePlace &place = BlockQuadrature<dim>::Window::place(i);
        const int other        = blocks.neighbours(slot)[place.neighbour];
        if (other == invalid_slot)
          continue;
        Vector<dim> force;
        for (int d = 0; d < dim; ++d)
          force[d] = forces[d][i];
        field.add(SingleVector::value, other, place.node, force);
      }
  }

  template <int dim>
  double
  SurfaceForce<dim>::find(const BlockPartition<dim> &partition,
                          const SurfaceFields<dim> &fields,
                          NodeField<dim, SingleVector> &force)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    find_volumes(partition, fields);
    force.reinit(blocks.size());
    double energy = 0.;
    typename Stress::Nodes nodes;
    nodes.is_uniform = fields.is_uniform;
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      {
        const Index<dim> &block = blocks.block(slot);
        if (!is_in_box(block) || !find_nodes(blocks, fields, slot, nodes))
          continue;
        std::array<NodeValues, dim> forces = {};
        if (nodes.has_surface)
          energy += stress.add_force(nodes, forces);
        const double wetted = add_wall_tension<dim>(walls, block, nodes, forces) +
                              wet_bodies(blocks, fields, slot, nodes, forces);
        energy += wetted;
        if (nodes.has_surface || wetted != 0.)
          add_to_field(blocks, slot, forces, force);
      }
    partition.add_ghosts_to_owners(force);
    return energy;
  }

  template class SurfaceForce<2>;
  template class SurfaceForce<3>;
} // namespace magmpm
