#pragma once

#include <magmpm/base/tensor.h>

#include <cmath>

namespace magmpm
{
  /**
   * Von Mises equivalent stress sqrt(3/2 s:s), s the deviator of @p stress (Cauchy) [Pa]. It equals
   * |sigma| in uniaxial tension and sqrt(3) |tau| in simple shear.
   */
  template <typename Number = double>
  inline Number
  von_mises_stress(const Matrix<3, Number> &stress)
  {
    const Number xy           = stress(0, 0) - stress(1, 1);
    const Number yz           = stress(1, 1) - stress(2, 2);
    const Number zx           = stress(2, 2) - stress(0, 0);
    const Number shear_square = stress(0, 1) * stress(0, 1) + stress(1, 2) * stress(1, 2) +
                                stress(2, 0) * stress(2, 0);
    using std::sqrt;
    return sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3. * shear_square);
  }

  /**
   * The same in plane strain, where the stress @p out_of_plane (sigma_zz [Pa]) is not zero: each
   * material knows its own.
   */
  template <typename Number = double>
  inline Number
  von_mises_stress(const Matrix<2, Number> &stress, const Number out_of_plane)
  {
    Matrix<3, Number> full;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        full(i, j) = stress(i, j);
    full(2, 2) = out_of_plane;
    return von_mises_stress(full);
  }
} // namespace magmpm
