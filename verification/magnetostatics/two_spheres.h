#pragma once

#include <magmpm/base/tensor.h>

#include <array>

namespace magmpm::verification
{
  /** Two spheres of linear media in vacuum, apart from each other; two parallel cylinders in 2D. */
  template <int dim>
  struct TwoSpheres
  {
    std::array<double, 2> radius;         ///< [m]
    std::array<double, 2> susceptibility; ///< [-]
    Vector<dim> separation;               ///< centre of the second from that of the first [m]
  };

  template <int dim>
  struct TwoSpheresSolution
  {
    std::array<Vector<dim>, 2> moment; ///< [A m^2], or [A m]
    Vector<dim> force_on_second;       ///< [N], or [N/m]; the first feels the opposite
  };

  /**
   * Exact moments and forces in a uniform field, by the method of reflections: each sphere answers
   * the multipoles of the other, re-expanded about its own centre, until nothing changes. The force
   * is the derivative of the energy -mu_0/2 (m_1 + m_2).H_0 by the separation, radially by a
   * central difference of fourth order with a step of a thousandth of the distance: meant for gaps
   * that are much larger than that.
   *
   * @param outer_field  H_0 [A/m].
   * @throw RunError     if the spheres overlap, or are too close for the reflections to converge.
   */
  template <int dim>
  TwoSpheresSolution<dim>
  two_spheres_in_uniform_field(const TwoSpheres<dim> &spheres, const Vector<dim> &outer_field);
} // namespace magmpm::verification
