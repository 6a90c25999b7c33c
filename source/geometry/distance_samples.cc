#include <magmpm/geometry/distance_samples.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    constexpr int margin = 3; // samples around the box
  }

  DistanceSamples::DistanceSamples(
    const BoundingBox<3> &box,
    const double spacing,
    const std::function<SurfaceDistance<3>(const Vector<3> &)> &distance)
    : h(spacing)
  {
    for (int d = 0; d < 3; ++d)
      {
        const double extent = box.upper[d] - box.lower[d];
        n[d]                = static_cast<int>(std::ceil(extent / h)) + 1 + 2 * margin;
        lower[d]            = box.lower[d] - 0.5 * ((n[d] - 1) * h - extent);
      }
    samples.reserve(static_cast<std::size_t>(n[0]) * n[1] * n[2]);
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i)
          {
            const SurfaceDistance<3> here =
              distance(lower + h * Vector<3>{{double(i), double(j), double(k)}});
            samples.push_back({{static_cast<float>(here.distance),
                                static_cast<float>(here.normal[0]),
                                static_cast<float>(here.normal[1]),
                                static_cast<float>(here.normal[2])}});
          }
  }

  SurfaceDistance<3>
  DistanceSamples::inside(const Vector<3> &point) const
  {
    int cell[3];
    float part[3];
    for (int d = 0; d < 3; ++d)
      {
        const double place = (point[d] - lower[d]) / h;
        cell[d]            = std::clamp(static_cast<int>(place), 0, n[d] - 2);
        part[d]            = static_cast<float>(place - cell[d]);
      }
    const Sample *corner = samples.data() +
                           (static_cast<std::size_t>(cell[2]) * n[1] + cell[1]) * n[0] + cell[0];
    const auto along_x = [&](const Sample *at) { return at[0] + part[0] * (at[1] - at[0]); };
    const auto along_y = [&](const Sample *at) {
      const Sample low = along_x(at);
      return low + part[1] * (along_x(at + n[0]) - low);
    };
    const Sample low   = along_y(corner);
    const Sample value = low +
                         part[2] * (along_y(corner + static_cast<std::size_t>(n[0]) * n[1]) - low);

    Vector<3> normal    = {{value[1], value[2], value[3]}};
    const double length = norm(normal);
    // Opposite normals, amid two walls: one of them will do.
    if (length > 1e-3)
      return {value[0], (1. / length) * normal};
    normal = {{(*corner)[1], (*corner)[2], (*corner)[3]}};
    return {value[0], (1. / norm(normal)) * normal};
  }

  SurfaceDistance<3>
  DistanceSamples::at(const Vector<3> &point) const
  {
    Vector<3> nearest = point;
    for (int d = 0; d < 3; ++d)
      nearest[d] = std::clamp(point[d], lower[d], lower[d] + (n[d] - 1) * h);
    const SurfaceDistance<3> there = inside(nearest);
    const Vector<3> beyond         = point - nearest;
    if (norm_square(beyond) == 0.)
      return there;

    const Vector<3> from_surface = beyond + there.distance * there.normal;
    const double distance        = norm(from_surface);
    return {distance, (1. / distance) * from_surface};
  }
} // namespace magmpm
