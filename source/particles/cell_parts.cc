#include <magmpm/particles/cell_parts.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace magmpm
{
  template <int dim>
  CellRange<dim>::CellRange(const BoundingBox<dim> &box, const Lattice<dim> &lattice)
  {
    const Vector<dim> lower = lattice.reduced(box.lower), upper = lattice.reduced(box.upper);
    for (int d = 0; d < dim; ++d)
      {
        // Faces on nodes, up to the rounding of their coordinates, reach into no further cell.
        const double rounding = 1e-14 * std::max({1., std::abs(lower[d]), std::abs(upper[d])});
        first[d]              = static_cast<int>(std::floor(lower[d] + rounding));
        count[d] = std::max(0, static_cast<int>(std::ceil(upper[d] - rounding)) - first[d]);
      }
  }

  template <int dim>
  double
  CellRange<dim>::size() const
  {
    double size = 1.;
    for (int d = 0; d < dim; ++d)
      size *= count[d];
    return size;
  }

  template <int dim>
  std::size_t
  CellRange<dim>::number(const Index<dim> &cell) const
  {
    std::size_t number = 0;
    for (int d = dim - 1; d >= 0; --d)
      number = number * count[d] + (cell[d] - first[d]);
    return number;
  }

  template <int dim>
  bool
  CellRange<dim>::contains(const Index<dim> &cell) const
  {
    for (int d = 0; d < dim; ++d)
      if (cell[d] < first[d] || cell[d] >= first[d] + count[d])
        return false;
    return true;
  }

  template <int dim>
  bool
  CellRange<dim>::advance(Index<dim> &cell) const
  {
    for (int d = 0; d < dim; ++d)
      {
        if (++cell[d] < first[d] + count[d])
          return true;
        cell[d] = first[d];
      }
    return false;
  }

  namespace
  {
    /** What is smaller than this part of a cell is rounding. */
    constexpr double nothing = 1e-13;

    /**
     * Parts that are smaller than these parts of a cell join one that is not; the second where a body is too
     * thin for the first, and so on.
     */
    constexpr double small[] = {1. / 4., 1. / 16., 1. / 64.};

    /**
     * Where a part goes, and whether there is one beyond its faces, may depend on cells as far away as this:
     * one for each, that which it joins, and the one beyond.
     */
    constexpr int reach = 2 + std::extent_v<decltype(small)>;

    /** Parts of a box of cells, and which of them join which. */
    template <int dim>
    class Parts
    {
    public:
      Parts(const Shape<dim> &shape, const Lattice<dim> &lattice, const CellRange<dim> &cells)
        : cells(cells)
        , number_of(static_cast<std::size_t>(cells.size()), -1)
      {
        const double full = std::pow(lattice.spacing, dim);
        Index<dim> cell   = cells.first;
        if (number_of.empty())
          return;
        do
          {
            Index<dim> next = cell;
            for (int &i : next)
              ++i;
            const RegionMoments<dim> moments =
              shape.moments_within({lattice.node_position(cell), lattice.node_position(next)});
            if (!(moments.volume > nothing * full))
              continue;
            number_of[cells.number(cell)] = static_cast<int>(all.size());
            all.push_back({cell, moments, {}});
            volumes.push_back(moments.volume / full);
          }
        while (cells.advance(cell));
      }

      /** Moves small parts to those that they join. */
      void
      join(const Lattice<dim> &lattice)
      {
        const int n                   = static_cast<int>(all.size());
        const std::vector<int> target = targets();
        for (int p = 0; p < n; ++p)
          if (target[p] != p)
            {
              CellPart<dim> &other = all[target[p]];
              Vector<dim> way;
              for (int d = 0; d < dim; ++d)
                way[d] = lattice.spacing * (other.cell[d] - all[p].cell[d]);
              other.moments += moved_to(all[p].moments, way);
            }
        for (int p = 0; p < n; ++p)
          is_left.push_back(target[p] == p);
      }

      /** Of @p layers, those that joined no other. */
      std::vector<CellPart<dim>>
      left(const int along, const int begin, const int end) const
      {
        std::vector<CellPart<dim>> result;
        for (std::size_t p = 0; p < all.size(); ++p)
          if (is_left[p] && all[p].cell[along] >= begin && all[p].cell[along] < end)
            {
              result.push_back(all[p]);
              for (int face = 0; face < 2 * dim; ++face)
                result.back().is_exposed[face] = !has_part_beyond(all[p].cell, face);
            }
        return result;
      }

    private:
      const CellRange<dim> cells;
      std::vector<int> number_of; ///< of the part in each cell; -1: none
      std::vector<CellPart<dim>> all;
      std::vector<double> volumes; ///< over that of a cell, before they are joined
      std::vector<bool> is_left;

      bool
      has_part_beyond(Index<dim> cell, const int face) const
      {
        cell[face / 2] += (face % 2 == 0 ? -1 : 1);
        if (!cells.contains(cell))
          return false;
        const int other = number_of[cells.number(cell)];
        return other >= 0 && is_left[other];
      }

      /** The largest neighbour of a part that counts, of those across a face first; -1: there is none. */
      template <typename Counts>
      int
      best_neighbour(const int p, const Counts &counts) const
      {
        int best = -1, fewest_axes = dim + 1;
        for (int n = 0; n < power(3, dim); ++n)
          {
            Index<dim> cell = all[p].cell;
            int n_axes      = 0;
            for (int d = 0, rest = n; d < dim; rest /= 3, ++d)
              {
                cell[d] += rest % 3 - 1;
                n_axes += (rest % 3 != 1);
              }
            if (n_axes == 0 || n_axes > fewest_axes || !cells.contains(cell))
              continue;
            const int other = number_of[cells.number(cell)];
            if (other >= 0 && counts(other) &&
                (n_axes < fewest_axes || volumes[other] > volumes[best]))
              {
                best        = other;
                fewest_axes = n_axes;
              }
          }
        return best;
      }

      /** The part that each one joins; of those that stay their own number. */
      std::vector<int>
      targets() const
      {
        constexpr int open = -1;
        const int n        = static_cast<int>(all.size());
        std::vector<int> target(n, open);
        for (const double least : small)
          {
            for (int p = 0; p < n; ++p)
              if (target[p] == open && volumes[p] >= least)
                target[p] = p;
            // Those that stayed before have no neighbours that are still open.
            for (int p = 0; p < n; ++p)
              if (target[p] == open)
                target[p] = best_neighbour(p,
                                           [&](const int other) { return target[other] == other; });
          }
        for (int p = 0; p < n; ++p)
          if (target[p] == open)
            target[p] = p;
        return target;
      }
    };
  } // namespace

  template <int dim>
  std::vector<CellPart<dim>>
  cell_parts(const Shape<dim> &shape,
             const Lattice<dim> &lattice,
             const CellRange<dim> &range,
             const int along,
             const std::array<int, 2> &layers)
  {
    CellRange<dim> cells = range;
    const int begin      = std::max(0, layers[0] - reach);
    const int end        = std::min(range.count[along], layers[1] + reach);
    cells.first[along] += begin;
    cells.count[along] = std::max(0, end - begin);
    if (layers[0] >= layers[1])
      return {};
    Parts<dim> parts(shape, lattice, cells);
    parts.join(lattice);
    return parts.left(along, range.first[along] + layers[0], range.first[along] + layers[1]);
  }

#define INSTANTIATE(dim)                                                      \
  template struct CellRange<dim>;                                             \
  template std::vector<CellPart<dim>> cell_parts<dim>(const Shape<dim> &,     \
                                                      const Lattice<dim> &,   \
                                                      const CellRange<dim> &, \
                                                      int,                    \
                                                      const std::array<int, 2> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
