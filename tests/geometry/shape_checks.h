#pragma once

#include "../catch.h"

#include <magmpm/geometry/shape.h>

#include <algorithm>
#include <cmath>
#include <random>

/** What holds for every shape. */
namespace magmpm::testing
{
  template <int dim>
  Vector<dim>
  random_point(std::mt19937 &engine, const BoundingBox<dim> &box)
  {
    Vector<dim> point;
    for (int d = 0; d < dim; ++d)
      // Not std::uniform_real_distribution: the same on every machine.
      point[d] = box.lower[d] + (box.upper[d] - box.lower[d]) * (engine() / 4294967296.);
    return point;
  }

  /** Moments against sums over a grid of points of spacing @p h; @p tolerance relative. */
  template <int dim>
  void
  check_moments_by_points(const Shape<dim> &shape, const double h, const double tolerance)
  {
    const BoundingBox<dim> box = shape.bounding_box();
    const double volume        = std::pow(h, dim);
    VolumeMoments<dim> sums    = {};
    const VolumeMoments<dim> m = shape.volume_moments();
    Vector<dim> point          = box.lower;
    for (int d = 0; d < dim; ++d)
      point[d] += 0.5 * h;
    for (const Vector<dim> start = point; point[dim - 1] < box.upper[dim - 1];)
      {
        if (shape.contains(point))
          {
            sums.volume += volume;
            sums.centroid += volume * point;
            sums.second += volume * outer(point - m.centroid, point - m.centroid);
          }
        point[0] += h;
        for (int d = 0; d + 1 < dim && point[d] >= box.upper[d]; ++d)
          {
            point[d] = start[d];
            point[d + 1] += h;
          }
      }
    CHECK(m.volume == Approx(sums.volume).epsilon(tolerance));
    CHECK(norm(m.centroid - (1. / sums.volume) * sums.centroid) <
          tolerance * norm(box.upper - box.lower));
    CHECK(frobenius_norm(m.second + (-1.) * sums.second) <
          2. * tolerance * frobenius_norm(m.second));
  }

  /**
   * Surface points lie on the surface, and every point of it is within 3/4 of @p spacing of one of
   * them: half the diagonal of a square of such an edge, and what a curve adds.
   *
   * @param precision  of the distances of the shape near its surface.
   */
  template <int dim>
  void
  check_surface_points(const Shape<dim> &shape, const double spacing, const double precision = 1e-9)
  {
    const std::vector<Vector<dim>> points = shape.surface_points(spacing);
    double off_surface                    = 0.;
    for (const Vector<dim> &point : points)
      off_surface = std::max(off_surface, std::abs(shape.surface_distance(point).distance));
    CHECK(off_surface < precision);

    std::mt19937 engine(1);
    double farthest = 0.;
    for (int i = 0; i < 500; ++i)
      {
        const Vector<dim> x              = random_point(engine, shape.bounding_box());
        const SurfaceDistance<dim> there = shape.surface_distance(x);
        const Vector<dim> on_surface     = x - there.distance * there.normal;
        // Of shapes made of others some distances are too short, and lead to no point of the surface.
        if (std::abs(shape.surface_distance(on_surface).distance) > precision)
          continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vector<dim> &point : points)
          nearest = std::min(nearest, norm(point - on_surface));
        farthest = std::max(farthest, nearest);
      }
    CHECK(farthest < 0.75 * spacing + 2. * precision);
    CHECK(farthest > 0.25 * spacing);
  }
} // namespace magmpm::testing
