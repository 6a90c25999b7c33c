#pragma once

#include <magmpm/geometry/region_moments.h>

#include <array>

namespace magmpm
{
  /**
   * Moments of what a closed surface encloses within a box, by the divergence theorem along x: the sum
   * over the facets in the column through the box along x of the integrals of G n_x, where G is the
   * integral of 1, r and r r^T from the lower x-face of the box to the facet or to the upper x-face,
   * whichever comes first. Facets are cut at the faces of the column and of the box; what remains are
   * cubic polynomials on polygons, so the result is exact, and facets along x or before the box
   * contribute nothing.
   */
  template <int dim>
  class ColumnMoments
  {
  public:
    explicit ColumnMoments(const BoundingBox<dim> &box);

    /** Takes a facet, its corners counterclockwise seen from outside (in 2D: outside to the right). */
    void
    add(const std::array<Vector<dim>, dim> &facet);

    /** About the middle of the box; right once all facets that reach the column were taken. */
    const RegionMoments<dim> &
    moments() const
    {
      return sum;
    }

  private:
    static constexpr int max_corners = 12;

    /** A convex polygon; in 2D a line. */
    struct Polygon
    {
      std::array<Vector<dim>, max_corners> corners;
      int n = 0;
    };

    const Vector<dim> middle;
    const Vector<dim> half; ///< edges [m]
    RegionMoments<dim> sum;

    /** The part where x_axis is above @p value, or below it. */
    static Polygon
    cut(const Polygon &polygon, const int axis, const double value, const bool keeps_above);

    /** Adds the integral of G n_x over a polygon between the x-faces of the box. */
    void
    integrate(const Polygon &polygon);

    /** Adds G at a point, times @p weight. */
    void
    add_at(const Vector<dim> &point, const double weight);
  };

  /**
   * Moments, about the middle of a box, of its part where f + g . r < 0, r seen from the middle. Exact.
   *
   * @param f  distance of the middle from the plane, times |g|.
   * @param g  outward across the plane, of any length but 0.
   */
  template <int dim>
  RegionMoments<dim>
  moments_below_plane(const BoundingBox<dim> &box, const double f, const Vector<dim> &g);
} // namespace magmpm
