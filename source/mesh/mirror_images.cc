#include <magmpm/lattice/node_window.h>
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

    /**
     * Treats the nodes at the wall through node 0 along @p axis of the block in @p slot; material is
     * in this block if @p is_in_front, in the one below if not.
     */
    template <int dim>
    void
    reflect_in_block(const BlockSet<dim> &blocks,
                     const int slot,
                     const int axis,
                     const bool is_in_front,
                     const bool adds,
                     const LaneSigns &signs,
                     NodeNumbers<dim> &field)
    {
      using Window       = NodeWindow<dim, block_edge - 1, 0>;
      const int n_lanes  = field.layout().n_lanes;
      const auto &around = blocks.neighbours(slot);
      for (int node = 0; node < nodes_per_block<dim>; ++node)
        {
          const int distance = node / power(block_edge, axis) % block_edge;
          const NodePlace &image =
            Window::place(Window::of_block(node) - 2 * distance * Window::stride(axis));
          const int image_slot = around[image.neighbour];
          if (image_slot == invalid_slot)
            continue;
          // Both are the same on the wall.
          double *here     = field.node(slot, node);
          double *opposite = field.node(image_slot, image.node);
          double *front    = (is_in_front ? here : opposite);
          double *behind   = (is_in_front ? opposite : here);
          for (int lane = 0; lane < n_lanes; ++lane)
            {
              if (adds && distance <= 1)
                front[lane] += signs[lane] * behind[lane];
              if (distance > 0)
                behind[lane] = signs[lane] * front[lane];
              else if (signs[lane] < 0.)
                front[lane] = 0.;
            }
        }
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
            const int axis             = face / 2;
            const bool is_lower        = (face % 2 == 0);
            const int wall             = (is_lower ? 0 : walls.n_cells[axis]);
            const LaneSigns lane_signs = signs(field.layout(), parity, axis);
            for (int slot = 0; slot < n_slots; ++slot)
              if (block_edge * blocks.block(slot)[axis] == wall)
                reflect_in_block(blocks, slot, axis, is_lower, adds, lane_signs, field);
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
