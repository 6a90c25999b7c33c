#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/lattice/lattice.h>

#include <array>
#include <vector>

namespace magmpm
{
  /** Lattice cells in a box, from the first of them. */
  template <int dim>
  struct CellRange
  {
    Index<dim> first;
    Index<dim> count; ///< along each axis

    /** Those that a shape may fill. */
    CellRange(const BoundingBox<dim> &box, const Lattice<dim> &lattice);

    /** In all; a number that may be larger than any integer's. */
    double
    size() const;

    /** Place of a cell among all, x fastest. */
    std::size_t
    number(const Index<dim> &cell) const;

    bool
    contains(const Index<dim> &cell) const;

    /** Goes on to the next cell, x fastest. @return whether there was one. */
    bool
    advance(Index<dim> &cell) const;
  };

  /** What a body fills of a lattice cell, and what it fills of neighbours and is too small there. */
  template <int dim>
  struct CellPart
  {
    Index<dim> cell;
    RegionMoments<dim> moments; ///< about the middle of the cell

    /** Whether there is no part in the cell beyond a face, -x, +x, -y, ... */
    std::array<bool, 2 *dim> is_exposed = {};
  };

  /**
   * The parts of a shape in lattice cells. Those smaller than a quarter of a cell join the neighbour that
   * is not and has most volume, of those across a face if there is one. Where a body is thinner, with no such
   * neighbour, parts smaller than a sixteenth of a cell join one that is not, in the same way, and then
   * those smaller than a 64th; all others stay, so that a body never vanishes. A part depends on the shape
   * within five cells of it, and on nothing else.
   *
   * @param along      ranks share the cells by layers across this axis.
   * @param layers     the first layer of this rank and the one after its last, counted from the first cell
   *                   of @p range.
   */
  template <int dim>
  std::vector<CellPart<dim>>
  cell_parts(const Shape<dim> &shape,
             const Lattice<dim> &lattice,
             const CellRange<dim> &range,
             const int along,
             const std::array<int, 2> &layers);
} // namespace magmpm
