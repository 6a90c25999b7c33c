#include <magmpm/magnetics/mirror_images.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** Adds the images behind the wall through node 0 along @p axis of the block in @p slot. */
    template <int dim>
    void
    add_images_in_block(const BlockSet<dim> &blocks,
                        const int slot,
                        const int axis,
                        NodeField<dim> &content)
    {
      const int middle = n_neighbours<dim> / 2;
      const int below  = blocks.neighbours(slot)[middle - power(3, axis)];
      const int stride = power(block_edge, axis);
      for (int node = 0; node < nodes_per_block<dim>; ++node)
        {
          const int place = node / stride % block_edge;
          double *lanes   = content.node(slot, node);
          if (place == 0)
            for (int lane = 0; lane < n_lanes; ++lane)
              lanes[lane] *= 2.;
          else if (place == 1 && below != invalid_slot)
            {
              double *image = content.node(below, node + 2 * stride);
              for (int lane = 0; lane < n_lanes; ++lane)
                lanes[lane] = image[lane] = lanes[lane] + image[lane];
            }
        }
    }
  } // namespace

  template <int dim>
  void
  add_mirror_images(const BlockPartition<dim> &partition,
                    const Lattice<dim> &lattice,
                    const std::array<bool, 2 * dim> &shielded,
                    NodeField<dim> &content)
  {
    if (std::none_of(shielded.begin(), shielded.end(), [](const bool is) { return is; }))
      return;

    // Blocks behind a wall have the owner of the one in front of it: both sides are at hand.
    const BlockSet<dim> &blocks = partition.blocks();
    for (int face = 0; face < 2 * dim; ++face)
      if (shielded[face])
        {
          const int axis = face / 2;
          const int wall = (face % 2 == 0 ? 0 : lattice.n_cells[axis]);
          for (int slot = 0; slot < blocks.n_owned(); ++slot)
            if (block_edge * blocks.block(slot)[axis] == wall)
              add_images_in_block(blocks, slot, axis, content);
        }
    partition.update_ghosts(content);
  }

  template void
  add_mirror_images(const BlockPartition<2> &,
                    const Lattice<2> &,
                    const std::array<bool, 4> &,
                    NodeField<2> &);
  template void
  add_mirror_images(const BlockPartition<3> &,
                    const Lattice<3> &,
                    const std::array<bool, 6> &,
                    NodeField<3> &);
} // namespace magmpm
