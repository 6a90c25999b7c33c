#pragma once

#include <magmpm/lattice/node_window.h>
#include <magmpm/mesh/mirror_images.h>

#include <array>

namespace magmpm
{
  /**
   * Numbers on a window of nodes around a block, with images behind the walls of the box: the window knows all
   * that is in front, so no other rank has to be asked.
   */
  template <int dim, int lower, int upper>
  class MirroredWindow
  {
  public:
    using Window = NodeWindow<dim, lower, upper>;
    using Values = std::array<double, Window::n_nodes>;

    /** @param block  in the middle of the window; in the box, or beyond its upper walls by one. */
    MirroredWindow(const MirrorWalls<dim> &walls, const Index<dim> &block)
      : walls(walls)
      , block(block)
    {
    }

    /** c_i <- c_i + c_(-i), of what particles in front left on both sides; behind walls stands the same then. */
    void
    add_images(Values &values) const
    {
      for_pairs([&](const int, const int front, const int behind) {
        if (front == behind)
          values[front] *= 2.;
        else
          values[front] += values[behind];
        values[behind] = values[front];
      });
    }

    /** What is behind walls becomes the image of what is in front. */
    void
    copy_images(Values &values) const
    {
      for_pairs(
        [&](const int, const int front, const int behind) { values[behind] = values[front]; });
    }

    /** What lies behind walls is given to its image in front, times sign(face), and is zero then. */
    template <typename Sign>
    void
    fold(const Sign &sign, Values &values) const
    {
      for_pairs([&](const int face, const int front, const int behind) {
        if (front == behind)
          return;
        values[front] += sign(face) * values[behind];
        values[behind] = 0.;
      });
    }

  private:
    const MirrorWalls<dim> &walls;
    const Index<dim> block;

    /** Calls f(face, place in front, its image) face by face; on the wall both are one. */
    template <typename Function>
    void
    for_pairs(const Function &f) const
    {
      for (int face = 0; face < 2 * dim; ++face)
        {
          const int axis  = face / 2;
          const int inner = (face % 2 == 0 ? 1 : -1);
          const int wall  = (face % 2 == 0 ? 0 : walls.n_cells[axis]) - block_edge * block[axis] +
                           lower;
          if (!walls.is_mirror[face] || wall < 0 || wall >= Window::edge)
            continue;
          for (int distance = 0;; ++distance)
            {
              const int front = wall + inner * distance, behind = wall - inner * distance;
              if (front < 0 || front >= Window::edge || behind < 0 || behind >= Window::edge)
                break;
              for_plane(axis, [&](const int place) {
                const int stride = Window::stride(axis);
                f(face, place + front * stride, place + behind * stride);
              });
            }
        }
    }

    /** Calls f(place) for all nodes of the first layer across an axis. */
    template <typename Function>
    static void
    for_plane(const int axis, const Function &f)
    {
      const int stride = Window::stride(axis);
      for (int outer = 0; outer < Window::n_nodes; outer += stride * Window::edge)
        for (int inner = 0; inner < stride; ++inner)
          f(outer + inner);
    }
  };

  /** Reads a lane of the nodes of a window; nodes of blocks that are not active count as zero. */
  template <int dim, int lower, int upper>
  void
  gather_window(const NodeNumbers<dim> &field,
                const BlockSet<dim> &blocks,
                const int slot,
                const int lane,
                std::array<double, NodeWindow<dim, lower, upper>::n_nodes> &values)
  {
    using Window           = NodeWindow<dim, lower, upper>;
    const auto &neighbours = blocks.neighbours(slot);
    for (int i = 0; i < Window::n_nodes; ++i)
      {
        const NodePlace &place = Window::place(i);
        const int other        = neighbours[place.neighbour];
        values[i]              = (other == invalid_slot ? 0. : field.node(other, place.node)[lane]);
      }
  }
} // namespace magmpm
