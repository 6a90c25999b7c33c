#include <magmpm/lattice/wall_columns.h>
#include <magmpm/mesh/mirror_images.h>

namespace magmpm
{
  namespace
  {
    using LaneSigns = std::array<double, NodeLayout::max_lanes>;

    /** Of the images of all lanes behind a wall across @p axis. */
    LaneSigns
    signs(const NodeLayout &layout, const Parity &parity, const int axis)
    {
      LaneSigns result;
      for (int lane = 0; lane < layout.n_lanes; ++lane)
        {
          const int component     = layout.components[lane];
          const Parity::Sign sign = (component < 0 ? parity.scalars : parity.vectors);
          const bool is_odd       = (sign == Parity::odd ||
                               (sign == Parity::odd_normal && component == axis));
          result[lane]            = (is_odd ? -1. : 1.);
        }
      return result;
    }

    /** Makes the lanes of one node behind a wall the image of those in front; adds them first if @p adds. */
    template <int dim>
    void
    reflect_node(const LatticeNode &in_front,
                 const LatticeNode &behind,
                 const bool adds,
                 const LaneSigns &signs,
                 NodeNumbers<dim> &field)
    {
      double *front = field.node(in_front.slot, in_front.number);
      double *image = field.node(behind.slot, behind.number);
      for (int lane = 0; lane < field.layout().n_lanes; ++lane)
        {
          if (adds)
            front[lane] += signs[lane] * image[lane];
          image[lane] = signs[lane] * front[lane];
        }
    }

    /** On the wall both are the same: what is odd is zero, and what is even twice what is in front. */
    template <int dim>
    void
    reflect_on_wall(const LatticeNode &on_wall,
                    const bool adds,
                    const LaneSigns &signs,
                    NodeNumbers<dim> &field)
    {
      double *node = field.node(on_wall.slot, on_wall.number);
      for (int lane = 0; lane < field.layout().n_lanes; ++lane)
        if (signs[lane] < 0.)
          node[lane] = 0.;
        else if (adds)
          node[lane] *= 2.;
    }

    template <int dim>
    void
    reflect(const BlockSet<dim> &blocks,
            const int n_slots,
            const MirrorWalls<dim> &walls,
            const Parity &parity,
            const bool adds,
            NodeNumbers<dim> &field)
    {
      for (int face = 0; face < 2 * dim; ++face)
        if (walls.is_mirror[face])
          {
            const LaneSigns lane_signs = signs(field.layout(), parity, face / 2);
            for_wall_columns<dim>(
              blocks, n_slots, walls.n_cells, face, [&](const WallColumn &column) {
                reflect_on_wall(column.on_wall(), adds, lane_signs, field);
                for (int i = 1; i < block_edge; ++i)
                  reflect_node(
                    column.in_front(i), column.behind(i), adds && i == 1, lane_signs, field);
              });
          }
    }
  } // namespace

  template <int dim>
  void
  add_images(const BlockSet<dim> &blocks,
             const int n_slots,
             const MirrorWalls<dim> &walls,
             const Parity &parity,
             NodeNumbers<dim> &field)
  {
    reflect(blocks, n_slots, walls, parity, true, field);
  }

  template <int dim>
  void
  copy_images(const BlockSet<dim> &blocks,
              const int n_slots,
              const MirrorWalls<dim> &walls,
              const Parity &parity,
              NodeNumbers<dim> &field)
  {
    reflect(blocks, n_slots, walls, parity, false, field);
  }

#define MAGMPM_INSTANTIATE(dim)                                                                \
  template void add_images(                                                                    \
    const BlockSet<dim> &, int, const MirrorWalls<dim> &, const Parity &, NodeNumbers<dim> &); \
  template void copy_images(                                                                   \
    const BlockSet<dim> &, int, const MirrorWalls<dim> &, const Parity &, NodeNumbers<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
