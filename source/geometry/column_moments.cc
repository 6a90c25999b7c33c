#include <magmpm/geometry/column_moments.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  template <int dim>
  ColumnMoments<dim>::ColumnMoments(const BoundingBox<dim> &box)
    : middle(middle_of(box))
    , half(0.5 * (box.upper - box.lower))
  {
  }

  template <int dim>
  typename ColumnMoments<dim>::Polygon
  ColumnMoments<dim>::cut(const Polygon &polygon,
                          const int axis,
                          const double value,
                          const bool keeps_above)
  {
    Polygon result;
    const auto is_kept = [&](const Vector<dim> &point) {
      return keeps_above ? point[axis] >= value : point[axis] <= value;
    };
    for (int i = 0; i < polygon.n; ++i)
      {
        const Vector<dim> &here = polygon.corners[i];
        if (is_kept(here))
          result.corners[result.n++] = here;
        if (dim == 2 && i + 1 == polygon.n) // a line does not close
          break;
        const Vector<dim> &next = polygon.corners[(i + 1) % polygon.n];
        if (is_kept(here) == is_kept(next))
          continue;
        Vector<dim> crossing = here +
                               ((value - here[axis]) / (next[axis] - here[axis])) * (next - here);
        crossing[axis]             = value;
        result.corners[result.n++] = crossing;
      }
    return result;
  }

  template <int dim>
  void
  ColumnMoments<dim>::add(const std::array<Vector<dim>, dim> &facet)
  {
    Polygon polygon;
    for (int d = 0; d < dim; ++d)
      {
        const auto range = std::minmax_element(
          facet.begin(), facet.end(), [d](const Vector<dim> &a, const Vector<dim> &b) {
            return a[d] < b[d];
          });
        if ((*range.second)[d] - middle[d] <= -half[d] ||
            (d > 0 && (*range.first)[d] - middle[d] >= half[d]))
          return;
      }
    for (const Vector<dim> &corner : facet)
      polygon.corners[polygon.n++] = corner - middle;
    for (int d = 1; d < dim; ++d)
      polygon = cut(cut(polygon, d, -half[d], true), d, half[d], false);
    polygon        = cut(polygon, 0, -half[0], true);
    Polygon beyond = cut(polygon, 0, half[0], true);
    for (Vector<dim> &corner : beyond.corners)
      corner[0] = half[0];
    integrate(cut(polygon, 0, half[0], false));
    integrate(beyond);
  }

  template <int dim>
  void
  ColumnMoments<dim>::integrate(const Polygon &polygon)
  {
    // Rules that are exact for cubic polynomials.
    if constexpr (dim == 2)
      {
        if (polygon.n < 2)
          return;
        const Vector<2> &a = polygon.corners[0], &b = polygon.corners[1];
        const double place = 0.5 - 0.5 / std::sqrt(3.);
        for (const double s : {place, 1. - place})
          add_at((1. - s) * a + s * b, 0.5 * (b[1] - a[1]));
      }
    else
      for (int i = 1; i + 1 < polygon.n; ++i)
        {
          const Vector<3> &a = polygon.corners[0], &b = polygon.corners[i];
          const Vector<3> &c   = polygon.corners[i + 1];
          const Vector<3> sum  = a + b + c;
          const double area_yz = 0.5 * cross(b - a, c - a)[0];
          if (area_yz == 0.)
            continue;
          add_at((1. / 3.) * sum, -27. / 48. * area_yz);
          for (const Vector<3> &corner : {a, b, c})
            add_at(0.2 * sum + 0.4 * corner, 25. / 48. * area_yz);
        }
  }

  template <int dim>
  void
  ColumnMoments<dim>::add_at(const Vector<dim> &point, const double weight)
  {
    // Integrals of 1, x and x^2 from the lower x-face to the point.
    const double x = point[0], h = half[0];
    const double length = weight * (x + h);
    const double first  = 0.5 * length * (x - h);
    sum.volume += length;
    sum.first[0] += first;
    sum.second(0, 0) += length * (x * x - x * h + h * h) / 3.;
    for (int d = 1; d < dim; ++d)
      {
        sum.first[d] += length * point[d];
        sum.second(0, d) += first * point[d];
        sum.second(d, 0) += first * point[d];
        for (int e = 1; e < dim; ++e)
          sum.second(d, e) += length * point[d] * point[e];
      }
  }

  namespace
  {
    /** With axis 0 and another one exchanged. */
    template <int dim>
    Vector<dim>
    exchanged(Vector<dim> a, const int axis)
    {
      std::swap(a.values[0], a.values[axis]);
      return a;
    }

    template <int dim>
    Matrix<dim>
    exchanged(Matrix<dim> a, const int axis)
    {
      for (int i = 0; i < dim; ++i)
        std::swap(a.values[i][0], a.values[i][axis]);
      std::swap(a.values[0], a.values[axis]);
      return a;
    }

    /** The facets of the plane over a column, where the plane is x = x_0 + slope . (0, y, z). */
    template <int dim>
    void
    add_plane(const Vector<dim> &half,
              const double x_0,
              const Vector<dim> &slope,
              ColumnMoments<dim> &column)
    {
      const auto corner = [&](const double y, const double z) {
        Vector<dim> point;
        point[1] = y * half[1];
        if constexpr (dim == 3)
          point[2] = z * half[2];
        point[0] = x_0 + dot(slope, point);
        return point;
      };
      if constexpr (dim == 2)
        column.add({{corner(-1., 0.), corner(1., 0.)}});
      else
        {
          column.add({{corner(-1., -1.), corner(1., -1.), corner(1., 1.)}});
          column.add({{corner(-1., -1.), corner(1., 1.), corner(-1., 1.)}});
        }
    }
  } // namespace

  template <int dim>
  RegionMoments<dim>
  moments_below_plane(const BoundingBox<dim> &box, const double f, const Vector<dim> &g)
  {
    // Along the axis nearest to g, across which the plane is a function of the other coordinates.
    int axis = 0;
    for (int d = 1; d < dim; ++d)
      if (std::abs(g[d]) > std::abs(g[axis]))
        axis = d;
    const Vector<dim> half = exchanged(0.5 * (box.upper - box.lower), axis);
    Vector<dim> slope      = (-1. / g[axis]) * exchanged(g, axis);
    slope[0]               = 0.;
    ColumnMoments<dim> column(BoundingBox<dim>{-1. * half, half});
    add_plane(half, -f / g[axis], slope, column);
    const RegionMoments<dim> &found  = column.moments();
    const RegionMoments<dim> moments = {
      found.volume, exchanged(found.first, axis), exchanged(found.second, axis)};
    return g[axis] > 0. ? moments : moments_of(box) - moments;
  }

  template class ColumnMoments<2>;
  template class ColumnMoments<3>;
  template RegionMoments<2>
  moments_below_plane(const BoundingBox<2> &, double, const Vector<2> &);
  template RegionMoments<3>
  moments_below_plane(const BoundingBox<3> &, double, const Vector<3> &);
} // namespace magmpm
