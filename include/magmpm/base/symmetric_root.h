#pragma once

#include <magmpm/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  /**
   * The symmetric root of a symmetric, positive semidefinite matrix: R = R^T, R R = A. By Jacobi's
   * rotations; what rounding makes negative counts as 0.
   */
  template <int dim>
  inline Matrix<dim>
  symmetric_root(Matrix<dim> a)
  {
    constexpr int max_sweeps = 30;
    Matrix<dim> axes         = identity<dim>(); // a = axes^T A axes, diagonal in the end
    for (int sweep = 0; sweep < max_sweeps; ++sweep)
      {
        bool is_diagonal = true;
        for (int p = 0; p < dim; ++p)
          for (int q = p + 1; q < dim; ++q)
            {
              if (std::abs(a(p, q)) <= 1e-17 * (std::abs(a(p, p)) + std::abs(a(q, q))))
                continue;
              is_diagonal          = false;
              const double ratio   = (a(q, q) - a(p, p)) / (2. * a(p, q));
              const double tangent = (ratio < 0. ? -1. : 1.) /
                                     (std::abs(ratio) + std::sqrt(1. + ratio * ratio));
              const double cosine  = 1. / std::sqrt(1. + tangent * tangent);
              Matrix<dim> rotation = identity<dim>();
              rotation(p, p) = rotation(q, q) = cosine;
              rotation(p, q)                  = tangent * cosine;
              rotation(q, p)                  = -tangent * cosine;
              a                               = transpose(rotation) * (a * rotation);
              axes                            = axes * rotation;
            }
        if (is_diagonal)
          break;
      }
    Matrix<dim> root;
    for (int i = 0; i < dim; ++i)
      root(i, i) = std::sqrt(std::max(0., a(i, i)));
    return axes * (root * transpose(axes));
  }
} // namespace magmpm
