#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace magmpm::verification
{
  /** A quadrature point in the box [0, width_x] x [0, width_y] x [bottom, top]. */
  struct BoxPoint
  {
    double x, y, s, weight;
  };

  using BoxGradient = std::array<double, 3>;

  /**
   * Functions on a box between mirrors: cos(i pi x/width_x) cos(j pi y/width_y) times finite elements of high degree along
   * the third axis. Points of quadrature are the middles of twice as many intervals as there are cosines, and those of
   * Gauss. Nothing here is shared with magmpm or deal.II.
   */
  class CosineElements
  {
  public:
    /** @param edges  where elements begin and end along the third axis. */
    CosineElements(const std::array<double, 2> &widths,
                   const std::array<int, 2> &n_cosines,
                   const std::vector<double> &edges,
                   const int degree);

    /** Columns of points of the same x and y: column by column, along s. */
    const std::vector<BoxPoint> &
    points() const
    {
      return all_points;
    }

    std::size_t
    points_per_column() const
    {
      return heights.size();
    }

    /** Unknowns of the same pair of cosines, i and j, follow each other: number i n_y + j. */
    std::size_t
    nodes_per_pair() const
    {
      return n_nodes;
    }

    std::vector<BoxGradient>
    gradients(const std::vector<double> &u) const;

    /** sum over points of flux . grad of each basis function: the transpose of gradients(). */
    std::vector<double>
    tested(const std::vector<BoxGradient> &flux) const;

    /** A point along the third axis. */
    struct Height
    {
      double s, weight;
      std::size_t first;                  ///< node of its element
      std::vector<double> values, slopes; ///< of its polynomials
    };

    /** One direction across: [point][cosine]. */
    struct Direction
    {
      double width;
      std::size_t n;
      std::vector<std::vector<double>> cosines, slopes;
    };

    const std::vector<Height> &
    column() const
    {
      return heights;
    }

    const Direction &
    direction(const int axis) const
    {
      return axis == 0 ? x : y;
    }

  private:
    const Direction x, y;
    std::size_t n_nodes;
    std::vector<Height> heights;
    std::vector<BoxPoint> all_points;
  };
} // namespace magmpm::verification
