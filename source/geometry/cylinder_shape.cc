#include <magmpm/base/constants.h>
#include <magmpm/geometry/axis_frame.h>
#include <magmpm/geometry/cylinder_shape.h>

#include <cmath>

namespace magmpm
{
  CylinderShape::CylinderShape(const Vector<3> &centre,
                               const Vector<3> &axis,
                               const double radius,
                               const double length)
    : centre(centre)
    , direction(unit(axis))
    , across(any_across(direction))
    , radius(radius)
    , length(length)
  {
  }

  bool
  CylinderShape::contains(const Vector<3> &point) const
  {
    const Vector<3> r  = point - centre;
    const double along = dot(r, direction);
    return std::abs(along) <= 0.5 * length && norm_square(r) - along * along <= radius * radius;
  }

  SurfaceDistance<3>
  CylinderShape::surface_distance(const Vector<3> &point) const
  {
    const Vector<3> r          = point - centre;
    const double along         = dot(r, direction);
    const Vector<3> from_axis  = r - along * direction;
    const double distance      = norm(from_axis);
    const Vector<3> radial     = distance > 0. ? (1. / distance) * from_axis : across;
    const Vector<3> axial      = (along < 0. ? -1. : 1.) * direction;
    const double beyond_end    = std::abs(along) - 0.5 * length;
    const double beyond_mantle = distance - radius;
    if (beyond_end > 0. && beyond_mantle > 0.)
      {
        const double from_edge = std::hypot(beyond_end, beyond_mantle);
        return {from_edge, (beyond_end / from_edge) * axial + (beyond_mantle / from_edge) * radial};
      }
    return beyond_end > beyond_mantle ? SurfaceDistance<3>{beyond_end, axial}
                                      : SurfaceDistance<3>{beyond_mantle, radial};
  }

  std::vector<WayOut<3>>
  CylinderShape::ways_out(const Vector<3> &point) const
  {
    const double beyond       = 1e-9 * std::hypot(radius, length);
    const Vector<3> r         = point - centre;
    const double along        = dot(r, direction);
    const Vector<3> from_axis = r - along * direction;
    const double distance     = norm(from_axis);
    const Vector<3> radial    = distance > 0. ? (1. / distance) * from_axis : across;
    return ways_by_faces<3>({point + (radius - distance + beyond) * radial,
                             point + (0.5 * length - along + beyond) * direction,
                             point - (0.5 * length + along + beyond) * direction},
                            {radius - distance, 0.5 * length - along, 0.5 * length + along},
                            beyond);
  }

  BoundingBox<3>
  CylinderShape::bounding_box() const
  {
    // The caps are discs: along d they reach R times the sine of their axis' angle to it.
    Vector<3> reach;
    for (int d = 0; d < 3; ++d)
      reach[d] = 0.5 * length * std::abs(direction[d]) +
                 radius * std::sqrt(std::max(0., 1. - direction[d] * direction[d]));
    return {centre - reach, centre + reach};
  }

  VolumeMoments<3>
  CylinderShape::volume_moments() const
  {
    const double volume   = constants::pi * radius * radius * length;
    const Matrix<3> axial = outer(direction, direction);
    return {volume,
            centre,
            (volume * length * length / 12.) * axial +
              (volume * radius * radius / 4.) * (identity<3>() + (-1.) * axial)};
  }

  std::vector<Vector<3>>
  CylinderShape::surface_points(const double spacing) const
  {
    const Vector<3> other = cross(direction, across);
    std::vector<Vector<3>> points;
    const auto add_ring = [&](const double ring_radius, const double along) {
      const int n =
        std::max(1, static_cast<int>(std::ceil(2. * constants::pi * ring_radius / spacing)));
      for (int i = 0; i < n; ++i)
        {
          const double angle = 2. * constants::pi * i / n;
          points.push_back(centre + along * direction + ring_radius * std::cos(angle) * across +
                           ring_radius * std::sin(angle) * other);
        }
    };
    const int n_along = static_cast<int>(std::ceil(length / spacing));
    for (int i = 0; i <= n_along; ++i)
      add_ring(radius, length * (static_cast<double>(i) / n_along - 0.5));
    const int n_across = static_cast<int>(std::ceil(radius / spacing));
    for (int i = 0; i < n_across; ++i)
      for (const double end : {-0.5, 0.5})
        add_ring(radius * i / n_across, end * length);
    return points;
  }
  SurfaceMesh<3>
  CylinderShape::surface_mesh(const double spacing) const
  {
    const int n = std::max(12, static_cast<int>(std::ceil(2. * constants::pi * radius / spacing)));
    const Vector<3> other = cross(direction, across);
    SurfaceMesh<3> mesh;
    for (const double end : {-0.5, 0.5})
      mesh.points.push_back(centre + (end * length) * direction);
    for (int i = 0; i < n; ++i)
      {
        const double angle = 2. * constants::pi * i / n;
        for (const Vector<3> &middle : {mesh.points[0], mesh.points[1]})
          mesh.points.push_back(middle + radius * std::cos(angle) * across +
                                radius * std::sin(angle) * other);
        const int here = 2 + 2 * i, next = 2 + 2 * ((i + 1) % n);
        mesh.facets.push_back({here, next, next + 1});
        mesh.facets.push_back({here, next + 1, here + 1});
        mesh.facets.push_back({0, next, here});
        mesh.facets.push_back({1, here + 1, next + 1});
      }
    return mesh;
  }
} // namespace magmpm
