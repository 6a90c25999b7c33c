#include <magmpm/base/constants.h>
#include <magmpm/geometry/axis_frame.h>
#include <magmpm/geometry/ring_shape.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  RingShape::RingShape(const Vector<3> &centre,
                       const Vector<3> &axis,
                       const double outer_radius,
                       const double inner_radius)
    : centre(centre)
    , direction(unit(axis))
    , across(any_across(direction))
    , other(cross(direction, across))
    , middle_radius(0.5 * (outer_radius + inner_radius))
    , disc_radius(0.5 * (outer_radius - inner_radius))
  {
  }

  bool
  RingShape::contains(const Vector<3> &point) const
  {
    return surface_distance(point).distance <= 0.;
  }

  SurfaceDistance<3>
  RingShape::surface_distance(const Vector<3> &point) const
  {
    const Vector<3> r         = point - centre;
    const double along        = dot(r, direction);
    const Vector<3> from_axis = r - along * direction;
    const double distance     = norm(from_axis);
    const Vector<3> radial    = distance > 0. ? (1. / distance) * from_axis : across;
    const double outward      = distance - middle_radius;
    const double from_middle  = std::hypot(outward, along);
    if (!(from_middle > 0.))
      return {-disc_radius, direction};
    return {from_middle - disc_radius,
            (outward / from_middle) * radial + (along / from_middle) * direction};
  }

  BoundingBox<3>
  RingShape::bounding_box() const
  {
    Vector<3> reach;
    for (int d = 0; d < 3; ++d)
      reach[d] = middle_radius * std::sqrt(std::max(0., 1. - direction[d] * direction[d])) +
                 disc_radius;
    return {centre - reach, centre + reach};
  }

  VolumeMoments<3>
  RingShape::volume_moments() const
  {
    // Pappus; the mean squares of the distance from the axis and along it are R^2 + 3/4 r^2 and r^2/4.
    const double disc_square   = disc_radius * disc_radius;
    const double middle_square = middle_radius * middle_radius;
    const double volume        = 2. * constants::pi * constants::pi * middle_radius * disc_square;
    const Matrix<3> axial      = outer(direction, direction);
    return {volume,
            centre,
            (volume * disc_square / 4.) * axial +
              (volume * (middle_square / 2. + 3. / 8. * disc_square)) *
                (identity<3>() + (-1.) * axial)};
  }

  Vector<3>
  RingShape::surface_point(const double around, const double in_disc) const
  {
    const Vector<3> radial = std::cos(around) * across + std::sin(around) * other;
    return centre + (middle_radius + disc_radius * std::cos(in_disc)) * radial +
           (disc_radius * std::sin(in_disc)) * direction;
  }

  namespace
  {
    /** The parts of a circle that are no longer than @p spacing, at least @p least of them. */
    int
    parts_of_circle(const double radius, const double spacing, const int least)
    {
      return std::max(least, static_cast<int>(std::ceil(2. * constants::pi * radius / spacing)));
    }
  } // namespace

  std::vector<Vector<3>>
  RingShape::surface_points(const double spacing) const
  {
    return surface_mesh(spacing).points;
  }

  SurfaceMesh<3>
  RingShape::surface_mesh(const double spacing) const
  {
    const int n_around  = parts_of_circle(middle_radius + disc_radius, spacing, 12);
    const int n_in_disc = parts_of_circle(disc_radius, spacing, 12);
    SurfaceMesh<3> mesh;
    for (int i = 0; i < n_around; ++i)
      for (int j = 0; j < n_in_disc; ++j)
        {
          mesh.points.push_back(
            surface_point(2. * constants::pi * i / n_around, 2. * constants::pi * j / n_in_disc));
          const int next_i = (i + 1) % n_around, next_j = (j + 1) % n_in_disc;
          const int here = i * n_in_disc + j, above = i * n_in_disc + next_j;
          const int beside = next_i * n_in_disc + j, diagonal = next_i * n_in_disc + next_j;
          mesh.facets.push_back({here, beside, diagonal});
          mesh.facets.push_back({here, diagonal, above});
        }
    return mesh;
  }
} // namespace magmpm
