#include <verification/magnetostatics/jittered_points.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  template <int dim>
  Region<dim>
  sphere_region(const Vector<dim> &centre, const double radius)
  {
    return {[=](const Vector<dim> &x) { return norm_square(x - centre) < radius * radius; },
            centre,
            radius};
  }

  template <int dim>
  Region<dim>
  ellipsoid_region(const Vector<dim> &centre, const Vector<dim> &half_axes, const Matrix<dim> &axes)
  {
    double longest = 0.;
    for (int d = 0; d < dim; ++d)
      longest = std::max(longest, half_axes[d]);
    const auto contains = [=](const Vector<dim> &x) {
      Vector<dim> place = axes * (x - centre);
      for (int d = 0; d < dim; ++d)
        place[d] /= half_axes[d];
      return norm_square(place) < 1.;
    };
    return {contains, centre, longest};
  }

  template <int dim>
  Region<dim>
  cube_region(const Vector<dim> &centre, const double edge)
  {
    const auto contains = [=](const Vector<dim> &x) {
      for (int d = 0; d < dim; ++d)
        if (std::abs(x[d] - centre[d]) > 0.5 * edge)
          return false;
      return true;
    };
    return {contains, centre, 0.5 * edge};
  }

  template <int dim>
  std::vector<Vector<dim>>
  jittered_points(const Region<dim> &region, const double distance, RandomNumbers &random)
  {
    const int half          = static_cast<int>(std::ceil(region.half_width / distance)) + 2;
    const int n             = 2 * half;
    const Vector<dim> shift = random.vector_between<dim>(0., distance);

    std::vector<Vector<dim>> points;
    const auto total = static_cast<long>(std::pow(n, dim) + 0.5);
    for (long i = 0; i < total; ++i)
      {
        Vector<dim> point = region.centre + shift +
                            random.vector_between<dim>(-0.5 * distance, 0.5 * distance);
        long rest = i;
        for (int d = 0; d < dim; ++d, rest /= n)
          point[d] += distance * (static_cast<double>(rest % n - half) + 0.5);
        if (region.contains(point))
          points.push_back(point);
      }
    return points;
  }

#define MAGMPM_INSTANTIATE(dim)                                          \
  template Region<dim> sphere_region(const Vector<dim> &, const double); \
  template Region<dim> ellipsoid_region(                                 \
    const Vector<dim> &, const Vector<dim> &, const Matrix<dim> &);      \
  template Region<dim> cube_region(const Vector<dim> &, const double);   \
  template std::vector<Vector<dim>> jittered_points(                     \
    const Region<dim> &, const double, RandomNumbers &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm::verification
