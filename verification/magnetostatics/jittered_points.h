#pragma once

#include <magmpm/base/tensor.h>

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace magmpm::verification
{
  /** Random numbers that are the same on every platform and rank. */
  class RandomNumbers
  {
  public:
    explicit RandomNumbers(const std::uint64_t seed)
      : engine(seed)
    {
    }

    double
    between(const double lower, const double upper)
    {
      return lower + (upper - lower) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }

    template <int dim>
    Vector<dim>
    vector_between(const double lower, const double upper)
    {
      Vector<dim> v;
      for (int d = 0; d < dim; ++d)
        v[d] = between(lower, upper);
      return v;
    }

  private:
    std::mt19937_64 engine;
  };

  /** A body by its points, and half of a cube around it. */
  template <int dim>
  struct Region
  {
    std::function<bool(const Vector<dim> &)> contains;
    Vector<dim> centre;
    double half_width; ///< of a cube around the centre that holds it [m]
  };

  template <int dim>
  Region<dim>
  sphere_region(const Vector<dim> &centre, const double radius);

  /** @param axes  unit vectors along the half axes, as rows. */
  template <int dim>
  Region<dim>
  ellipsoid_region(const Vector<dim> &centre,
                   const Vector<dim> &half_axes,
                   const Matrix<dim> &axes);

  template <int dim>
  Region<dim>
  cube_region(const Vector<dim> &centre, const double edge);

  /**
   * Points inside a region: those of a grid of @p distance with a random corner, each moved by up
   * to half the distance along every axis.
   */
  template <int dim>
  std::vector<Vector<dim>>
  jittered_points(const Region<dim> &region, const double distance, RandomNumbers &random);
} // namespace magmpm::verification
