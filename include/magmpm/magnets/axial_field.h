#pragma once

#include <magmpm/base/tensor.h>

#include <cmath>

namespace magmpm
{
  /** Distance from the axis z, and the direction away from it (x on the axis). */
  struct AxialPlace
  {
    double rho;
    Vector<3> outward;

    explicit AxialPlace(const Vector<3> &point)
      : rho(std::hypot(point[0], point[1]))
      , outward(rho > 0. ? Vector<3>{{point[0] / rho, point[1] / rho, 0.}}
                         : Vector<3>{{1., 0., 0.}})
    {
    }
  };
} // namespace magmpm
