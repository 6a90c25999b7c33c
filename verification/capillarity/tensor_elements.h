#pragma once

#include <vector>

namespace magmpm::verification
{
  /** A quadrature point of TensorElements. */
  struct ElementPoint
  {
    double x, y;   ///< in the reference rectangle
    double weight; ///< of the quadrature there
  };

  /** What is at a point of the energy int [1/2 (a u_x^2 + 2 b u_x u_y + c u_y^2) - f u_x - h u_y] dx dy. */
  struct QuadraticForm
  {
    double a = 0., b = 0., c = 0.; ///< a c > b^2
    double f = 0., h = 0.;
  };

  struct PlaneGradient
  {
    double x, y;
  };

  /** Sides of the rectangle on which u = 0. */
  struct FixedSides
  {
    bool lower_x = false, upper_x = false, lower_y = false, upper_y = false;
  };

  /**
   * Finite elements of high degree on a rectangle cut into rectangles, for functions that are smooth in each; a
   * domain of another form comes in by the quadratic form, as its map says. Lagrange's polynomials in the points of Gauss
   * and Lobatto, quadrature of Gauss with two points more than the degree, Cholesky's factorization of the band.
   * Nothing here is shared with magmpm or deal.II.
   */
  class TensorElements
  {
  public:
    /**
     * @param x, y    where the elements begin and end, ascending.
     * @param degree  of the polynomials, at least 1.
     */
    TensorElements(const std::vector<double> &x,
                   const std::vector<double> &y,
                   const int degree,
                   const FixedSides &fixed);

    /** All of them, element by element along y, then x; those of a line x = const. are in order of y. */
    const std::vector<ElementPoint> &
    points() const
    {
      return all_points;
    }

    /** The gradient at all points of the u that makes the energy least. @param forms  at all points. */
    std::vector<PlaneGradient>
    solve(const std::vector<QuadraticForm> &forms) const;

  private:
    const int degree;
    const int n_points; ///< along an edge of an element
    const std::vector<double> x_edges, y_edges;
    const FixedSides fixed;
    std::vector<double> values,
      slopes; ///< of a polynomial at a point of [0, 1]: point * (degree + 1) + polynomial
    std::vector<ElementPoint> all_points;

    int
    n_nodes(const std::vector<double> &edges) const
    {
      return degree * (static_cast<int>(edges.size()) - 1) + 1;
    }

    bool
    is_fixed(const int i, const int j) const;

    /** Calls action(point, nodes, u_x of the polynomials, u_y) at each point. */
    template <typename Action>
    void
    at_points(const Action &action) const;
  };
} // namespace magmpm::verification
