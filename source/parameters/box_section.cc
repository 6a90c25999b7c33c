#include <magmpm/parameters/box_section.h>
#include <magmpm/parameters/given_parameters.h>

#include <cmath>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /** Block coordinates are packed into 21 bits each. */
    constexpr double max_cells = 1e6;

    /** Cells along an edge of the box, or an error with good values near it. */
    template <int dim>
    int
    cells_along(const ParameterRegister &declarations, const BoxInput<dim> &box, const int d)
    {
      const double edge = box.upper_corner[d] - box.lower_corner[d];
      const std::string axis(1, axis_names[d]);
      if (!(edge > 0.))
        throw declarations.error("Box/Upper corner",
                                 "along " + axis + " it must lie above Box/Lower corner (" +
                                   to_text(box.lower_corner[d]) + " m).");

      const double cells = edge / box.cell_size;
      if (cells > max_cells)
        throw declarations.error("Box/Cell size",
                                 "that makes " + to_text(cells) + " cells along " + axis +
                                   "; at most 1e6 are possible. Choose larger cells.");

      const double blocks = std::round(cells / block_edge);
      if (blocks >= 1. && std::abs(cells - block_edge * blocks) < 1e-6 * cells)
        return block_edge * static_cast<int>(blocks);

      const double above = std::ceil(cells / block_edge), below = above - 1.;
      const double nearest    = std::max(1., blocks);
      const double block_size = block_edge * box.cell_size;
      std::ostringstream advice;
      advice.precision(9);
      advice << "the edge along " << axis << " is " << to_text(cells)
             << " cells, but must be a multiple of 4 cells. Good values near: upper corner at "
             << axis << " = ";
      if (below >= 1.)
        advice << box.lower_corner[d] + below * block_size << " or ";
      advice << box.lower_corner[d] + above * block_size
             << " m, or Cell size = " << edge / (block_edge * nearest) << " m ("
             << block_edge * nearest << " cells).";
      throw declarations.error("Box/Upper corner", advice.str());
    }
  } // namespace

  template <int dim>
  void
  declare_box(ParameterRegister &declarations, BoxInput<dim> &box)
  {
    const auto section = declarations.enter("Box");
    declarations.add(
      "Lower corner", box.lower_corner, "m", "Lower corner of the box whose faces are the walls.");
    declarations.add("Upper corner",
                     box.upper_corner,
                     "m",
                     "Upper corner of the box. Its edges are multiples of 4 cells.",
                     Presence::required);
    declarations.add("Cell size",
                     box.cell_size,
                     "m",
                     "Edge dx of the lattice cells.",
                     positive,
                     Presence::required);
  }

  template <int dim>
  Lattice<dim>
  lattice_of_box(const ParameterRegister &declarations, const BoxInput<dim> &box)
  {
    Lattice<dim> lattice;
    lattice.lower_corner = box.lower_corner;
    lattice.spacing      = box.cell_size;
    for (int d = 0; d < dim; ++d)
      lattice.n_cells[d] = cells_along(declarations, box, d);
    return lattice;
  }

#define INSTANTIATE(dim)                                           \
  template void declare_box(ParameterRegister &, BoxInput<dim> &); \
  template Lattice<dim> lattice_of_box(const ParameterRegister &, const BoxInput<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
