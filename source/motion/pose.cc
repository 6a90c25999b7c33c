#include <magmpm/motion/pose.h>

#include <array>

namespace magmpm
{
  namespace
  {
    /** Of a rotation, the real part first; its length is not 1. */
    std::array<double, 4>
    quaternion_of(const Matrix<3> &r)
    {
      // Each row is a multiple of the quaternion; the one of the largest diagonal loses no digits.
      const double x = r(2, 1) - r(1, 2), y = r(0, 2) - r(2, 0), z = r(1, 0) - r(0, 1);
      const double xy = r(0, 1) + r(1, 0), xz = r(0, 2) + r(2, 0), yz = r(1, 2) + r(2, 1);
      const std::array<double, 4> rows[] = {{1. + r(0, 0) + r(1, 1) + r(2, 2), x, y, z},
                                            {x, 1. + r(0, 0) - r(1, 1) - r(2, 2), xy, xz},
                                            {y, xy, 1. - r(0, 0) + r(1, 1) - r(2, 2), yz},
                                            {z, xz, yz, 1. - r(0, 0) - r(1, 1) + r(2, 2)}};
      int largest                        = 0;
      for (int i = 1; i < 4; ++i)
        if (rows[i][i] > rows[largest][largest])
          largest = i;
      return rows[largest];
    }
  } // namespace

  template <int dim>
  Vector<n_axial_components<dim>>
  rotation_vector(const Matrix<dim> &rotation)
  {
    if constexpr (dim == 2)
      return {{std::atan2(rotation(1, 0), rotation(0, 0))}};
    else
      {
        const auto q         = quaternion_of(rotation);
        const Vector<3> axis = (q[0] < 0. ? -1. : 1.) * Vector<3>{{q[1], q[2], q[3]}};
        const double sine    = norm(axis);
        return (sine > 0. ? 2. * std::atan2(sine, std::abs(q[0])) / sine : 0.) * axis;
      }
  }

  template Vector<1>
  rotation_vector(const Matrix<2> &);
  template Vector<3>
  rotation_vector(const Matrix<3> &);
} // namespace magmpm
