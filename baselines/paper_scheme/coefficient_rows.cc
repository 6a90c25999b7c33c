#include <baselines/paper_scheme/coefficient_rows.h>

#include <cmath>

namespace magmpm::paper_scheme
{
  template <int dim>
  CoefficientRows<dim>::CoefficientRows(const NodeGrid<dim> &grid)
    : grid(grid)
    , margin(dim == 2 ? 1 : grid.n_nodes(1))
    , vacuum_value(0.25 * std::pow(grid.spacing, dim - 2))
    , zeros(grid.n_nodes(0) + 2, 0.)
    , constants(grid.n_nodes(0) + 2, vacuum_value)
    , constants_along(constants)
  {
    // One node before and one beyond the line, and the faces across x.
    for (const int end : {0, 1, grid.n_nodes(0), grid.n_nodes(0) + 1})
      constants_along[end] = 0.;
    for (int a = 0; a < dim; ++a)
      rows[a].assign(grid.n_lines() + 2 * margin, zeros.data() + 1);
    clear();
  }

  template <int dim>
  const double *
  CoefficientRows<dim>::vacuum_row(const int axis, const std::ptrdiff_t line) const
  {
    if (axis == 0)
      return constants_along.data() + 1;
    const int place = grid.node(line * grid.n_nodes(0))[axis];
    return (place == 0 || place == grid.n_cells[axis] ? zeros : constants).data() + 1;
  }

  template <int dim>
  void
  CoefficientRows<dim>::clear()
  {
    stored.clear();
    for (int a = 0; a < dim; ++a)
      {
        slots[a].assign(grid.n_lines(), none);
        for (int line = 0; line < grid.n_lines(); ++line)
          rows[a][line + margin] = vacuum_row(a, line);
      }
  }

  template <int dim>
  void
  CoefficientRows<dim>::scale(const int axis, const Index<dim> &node, const double factor)
  {
    const std::ptrdiff_t line = grid.number(node) / grid.n_nodes(0);
    const double *vacuum      = vacuum_row(axis, line);
    int &slot                 = slots[axis][line];
    if (slot == none)
      {
        slot = static_cast<int>(stored.size());
        stored.emplace_back(vacuum - 1, vacuum - 1 + zeros.size());
        rows[axis][line + margin] = stored[slot].data() + 1;
      }
    stored[slot][node[0] + 1] = factor * vacuum[node[0]];
  }

  template class CoefficientRows<2>;
  template class CoefficientRows<3>;
} // namespace magmpm::paper_scheme
