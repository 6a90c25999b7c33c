#include <magmpm/lattice/cell_stencil.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** Calls f(place in the stencil, slot or invalid_slot, node in its block). */
    template <int dim, typename Function>
    void
    for_each_node(const BlockSet<dim> &blocks,
                  const int slot,
                  const Index<dim> &corner,
                  const Function &f)
    {
      // Nodes -1 .. 3 from the corner, which is one of 0 .. 3.
      using Window                = NodeWindow<dim, 1, 3>;
      static constexpr auto boxes = Window::template box_offsets<stencil_edge>();
      const auto &neighbours      = blocks.neighbours(slot);
      int first                   = 0;
      for (int d = 0; d < dim; ++d)
        first += Window::stride(d) * corner[d];
      for (int i = 0; i < n_stencil_nodes<dim>; ++i)
        {
          const NodePlace &place = Window::place(first + boxes[i]);
          f(i, neighbours[place.neighbour], place.node);
        }
    }
  } // namespace

  template <int dim>
  void
  gather_stencil(const NodeNumbers<dim> &field,
                 const BlockSet<dim> &blocks,
                 const int slot,
                 const Index<dim> &corner,
                 StencilValues<dim> &values)
  {
    const int width = std::min(field.layout().n_lanes, n_lanes);
    values.fill(0.);
    for_each_node<dim>(blocks, slot, corner, [&](const int i, const int other, const int node) {
      if (other != invalid_slot)
        std::copy_n(field.node(other, node), width, &values[i * n_lanes]);
    });
  }

  template <int dim>
  void
  scatter_stencil(const StencilValues<dim> &values,
                  const BlockSet<dim> &blocks,
                  const int slot,
                  const Index<dim> &corner,
                  NodeNumbers<dim> &field)
  {
    const int width = std::min(field.layout().n_lanes, n_lanes);
    for_each_node<dim>(blocks, slot, corner, [&](const int i, const int other, const int node) {
      if (other == invalid_slot)
        return;
      double *lanes = field.node(other, node);
      for (int lane = 0; lane < width; ++lane)
        lanes[lane] += values[i * n_lanes + lane];
    });
  }

#define INSTANTIATE(dim)                                         \
  template void gather_stencil<dim>(const NodeNumbers<dim> &,    \
                                    const BlockSet<dim> &,       \
                                    const int,                   \
                                    const Index<dim> &,          \
                                    StencilValues<dim> &);       \
  template void scatter_stencil<dim>(const StencilValues<dim> &, \
                                     const BlockSet<dim> &,      \
                                     const int,                  \
                                     const Index<dim> &,         \
                                     NodeNumbers<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
