#include <magmpm/base/constants.h>
#include <magmpm/geometry/sphere_shape.h>

#include <cmath>

namespace magmpm
{
  template <int dim>
  SphereShape<dim>::SphereShape(const Vector<dim> &centre, const double radius)
    : centre(centre)
    , radius(radius)
  {
  }

  template <int dim>
  bool
  SphereShape<dim>::contains(const Vector<dim> &point) const
  {
    return norm_square(point - centre) <= radius * radius;
  }

  template <int dim>
  SurfaceDistance<dim>
  SphereShape<dim>::surface_distance(const Vector<dim> &point) const
  {
    const Vector<dim> r = point - centre;
    const double length = norm(r);
    if (length > 0.)
      return {length - radius, (1. / length) * r};
    Vector<dim> any;
    any[0] = 1.;
    return {-radius, any};
  }

  template <int dim>
  BoundingBox<dim>
  SphereShape<dim>::bounding_box() const
  {
    Vector<dim> reach;
    for (int d = 0; d < dim; ++d)
      reach[d] = radius;
    return {centre - reach, centre + reach};
  }

  template <int dim>
  VolumeMoments<dim>
  SphereShape<dim>::volume_moments() const
  {
    const double volume = dim == 3 ? 4. / 3. * constants::pi * radius * radius * radius
                                   : constants::pi * radius * radius;
    return {volume, centre, (volume * radius * radius / (dim + 2.)) * identity<dim>()};
  }

  template <int dim>
  std::vector<Vector<dim>>
  SphereShape<dim>::surface_points(const double spacing) const
  {
    std::vector<Vector<dim>> points;
    const auto add_ring = [&](const double ring_radius, const double height) {
      const int n =
        std::max(1, static_cast<int>(std::ceil(2. * constants::pi * ring_radius / spacing - 1e-9)));
      for (int i = 0; i < n; ++i)
        {
          const double angle = 2. * constants::pi * i / n;
          Vector<dim> point  = centre;
          point[0] += ring_radius * std::cos(angle);
          point[1] += ring_radius * std::sin(angle);
          if constexpr (dim == 3)
            point[2] += height;
          points.push_back(point);
        }
    };
    if constexpr (dim == 2)
      add_ring(radius, 0.);
    else
      {
        const int n = std::max(2, static_cast<int>(std::ceil(constants::pi * radius / spacing)));
        for (int i = 0; i <= n; ++i)
          {
            const double latitude = constants::pi * i / n;
            add_ring(i == 0 || i == n ? 0. : radius * std::sin(latitude),
                     radius * std::cos(latitude));
          }
      }
    return points;
  }

  template <int dim>
  SurfaceMesh<dim>
  SphereShape<dim>::surface_mesh(const double spacing) const
  {
    const int n = std::max(12, static_cast<int>(std::ceil(2. * constants::pi * radius / spacing)));
    SurfaceMesh<dim> mesh;
    // Rings from pole to pole; in 2D the one ring that there is.
    const int n_rings = dim == 2 ? 1 : n / 2 + 1;
    for (int ring = 0; ring < n_rings; ++ring)
      for (int i = 0; i < n; ++i)
        {
          const double longitude = 2. * constants::pi * i / n;
          const double latitude  = dim == 2 ? 0.5 * constants::pi
                                            : constants::pi * ring / (n_rings - 1);
          Vector<dim> point      = centre;
          point[0] += radius * std::sin(latitude) * std::cos(longitude);
          point[1] += radius * std::sin(latitude) * std::sin(longitude);
          if constexpr (dim == 3)
            point[2] -= radius * std::cos(latitude);
          mesh.points.push_back(point);
          const int here = ring * n + i, next = ring * n + (i + 1) % n;
          if constexpr (dim == 2)
            mesh.facets.push_back({here, next});
          else if (ring + 1 < n_rings)
            {
              mesh.facets.push_back({here, next, next + n});
              mesh.facets.push_back({here, next + n, here + n});
            }
        }
    return mesh;
  }

  template class SphereShape<2>;
  template class SphereShape<3>;
} // namespace magmpm
