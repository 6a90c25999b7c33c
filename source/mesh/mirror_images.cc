#include <magmpm/mesh/mirror_images.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    enum class Image
    {
      add,
      copy,
      add_vector
    };

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
                     const Image image,
                     NodeField<dim> &field)
    {
      const int below  = blocks.neighbours(slot)[n_neighbours<dim> / 2 - power(3, axis)];
      const int stride = power(block_edge, axis);
      const bool adds  = (image != Image::copy);
      std::array<double, n_lanes> sign; // of the image of a lane
      sign.fill(1.);
      if (image == Image::add_vector)
        sign[axis] = -1.;
      for (int node = 0; node < nodes_per_block<dim>; ++node)
        {
          const int place = node / stride % block_edge;
          double *lanes   = field.node(slot, node);
          if (place == 0)
            for (int lane = 0; lane < n_lanes && adds; ++lane)
              lanes[lane] += sign[lane] * lanes[lane];
          else if (below != invalid_slot)
            {
              // Node -place is node 4 - place of the block below.
              double *opposite = field.node(below, node + (block_edge - 2 * place) * stride);
              for (int lane = 0; lane < n_lanes; ++lane)
                {
                  double &front  = (is_in_front ? lanes : opposite)[lane];
                  double &behind = (is_in_front ? opposite : lanes)[lane];
                  if (adds && place == 1)
                    front += sign[lane] * behind;
                  behind = sign[lane] * front;
                }
            }
        }
    }

    template <int dim>
    void
    reflect(const BlockPartition<dim> &partition,
            const Lattice<dim> &lattice,
            const std::array<bool, 2 * dim> &shielded,
            const Image image,
            NodeField<dim> &field)
    {
      if (std::none_of(shielded.begin(), shielded.end(), [](const bool is) { return is; }))
        return;

      // Blocks behind a wall have the owner of the one in front of it: both sides are at hand.
      const BlockSet<dim> &blocks = partition.blocks();
      for (int face = 0; face < 2 * dim; ++face)
        if (shielded[face])
          {
            const int axis      = face / 2;
            const bool is_lower = (face % 2 == 0);
            const int wall      = (is_lower ? 0 : lattice.n_cells[axis]);
            for (int slot = 0; slot < blocks.n_owned(); ++slot)
              if (block_edge * blocks.block(slot)[axis] == wall)
                reflect_in_block(blocks, slot, axis, is_lower, image, field);
          }
      // Those of forces are zero: what is handed over between nodes is summed there.
      if (image != Image::add_vector)
        partition.update_ghosts(field);
    }
  } // namespace

  template <int dim>
  void
  add_mirror_images(const BlockPartition<dim> &partition,
                    const Lattice<dim> &lattice,
                    const std::array<bool, 2 * dim> &shielded,
                    NodeField<dim> &content)
  {
    reflect(partition, lattice, shielded, Image::add, content);
  }

  template <int dim>
  void
  copy_mirror_images(const BlockPartition<dim> &partition,
                     const Lattice<dim> &lattice,
                     const std::array<bool, 2 * dim> &shielded,
                     NodeField<dim> &field)
  {
    reflect(partition, lattice, shielded, Image::copy, field);
  }

  template <int dim>
  void
  add_mirror_images_of_vector(const BlockPartition<dim> &partition,
                              const Lattice<dim> &lattice,
                              const std::array<bool, 2 * dim> &shielded,
                              NodeField<dim> &field)
  {
    reflect(partition, lattice, shielded, Image::add_vector, field);
  }

#define MAGMPM_INSTANTIATE(dim)                                                \
  template void add_mirror_images(const BlockPartition<dim> &,                 \
                                  const Lattice<dim> &,                        \
                                  const std::array<bool, 2 * dim> &,           \
                                  NodeField<dim> &);                           \
  template void copy_mirror_images(const BlockPartition<dim> &,                \
                                   const Lattice<dim> &,                       \
                                   const std::array<bool, 2 * dim> &,          \
                                   NodeField<dim> &);                          \
  template void add_mirror_images_of_vector(const BlockPartition<dim> &,       \
                                            const Lattice<dim> &,              \
                                            const std::array<bool, 2 * dim> &, \
                                            NodeField<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
