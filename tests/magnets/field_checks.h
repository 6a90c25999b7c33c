#pragma once

#include "../catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/magnets/source_field.h>

#include <cmath>
#include <random>

/** What the tests of the sources' fields have in common. */
namespace magmpm::testing
{
  /** Of size 1 with components of no relation, none of them small. */
  template <int dim>
  Vector<dim>
  oblique()
  {
    if constexpr (dim == 3)
      return {{0.48, -0.6, 0.64}};
    else
      return {{0.6, -0.8}};
  }

  /** The gradient of a field by central differences of fourth order; G(i,j) = dH_i/dx_j. */
  template <int dim>
  Matrix<dim>
  difference_gradient(const SourceField<dim> &source,
                      const Vector<dim> &amplitude,
                      const Vector<dim> &point,
                      const double step)
  {
    Matrix<dim> gradient;
    for (int j = 0; j < dim; ++j)
      {
        const auto at = [&](const double way) {
          Vector<dim> moved = point;
          moved[j] += way * step;
          return source.field(amplitude, moved);
        };
        const Vector<dim> slope = (1. / (12. * step)) *
                                  (8. * (at(1.) - at(-1.)) - (at(2.) - at(-2.)));
        for (int i = 0; i < dim; ++i)
          gradient(i, j) = slope[i];
      }
    return gradient;
  }

  /** Points all over the box from -reach to reach; the same on every machine. */
  template <int dim>
  std::vector<Vector<dim>>
  scattered_points(const double reach, const int n)
  {
    std::mt19937 engine(7);
    std::vector<Vector<dim>> points(n);
    for (Vector<dim> &point : points)
      for (int d = 0; d < dim; ++d)
        point[d] = reach * (engine() / 2147483648. - 1.);
    return points;
  }

  /** The field of a dipole, in 2D of a line dipole (Jackson). */
  template <int dim>
  Vector<dim>
  dipole_field(const Vector<dim> &moment, const Vector<dim> &point)
  {
    const double r      = norm(point);
    const Vector<dim> n = (1. / r) * point;
    const double sphere = 2. * (dim - 1.) * constants::pi * std::pow(r, dim); // 4 pi r^3, 2 pi r^2
    return (1. / sphere) * ((dim * dot(moment, n)) * n - moment);
  }
} // namespace magmpm::testing
