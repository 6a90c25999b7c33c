#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/materials/magnetization.h>

/**
 * Exact solutions for bodies in vacuum. In 2D a sphere is a cylinder and an ellipsoid an elliptic
 * cylinder across the field, a dipole is a line dipole, and forces are per metre of depth.
 */
namespace magmpm::verification
{
  /** [m^3], or [m^2]. */
  template <int dim>
  double
  ellipsoid_volume(const Vector<dim> &half_axes);

  /**
   * N_k with h = -N M along axis k inside a uniformly magnetized ellipsoid; they sum to 1. In 3D by
   * Carlson's integral, N_k = (a b c/3) R_D (Osborn 1945); in 2D N_a = b/(a + b).
   *
   * @param half_axes  positive [m].
   */
  template <int dim>
  Vector<dim>
  demagnetizing_factors(const Vector<dim> &half_axes);

  /** H and M inside, both uniform. */
  template <int dim>
  struct UniformState
  {
    Vector<dim> field;         ///< H [A/m]
    Vector<dim> magnetization; ///< M [A/m]
  };

  /**
   * An ellipsoid in a uniform field: H + N M(H) = H_0, any magnetization law.
   *
   * @param factors      its demagnetizing factors.
   * @param outer_field  H_0 along the principal axes [A/m].
   * @throw RunError     if Newton's method fails, which it never should.
   */
  template <int dim>
  UniformState<dim>
  ellipsoid_in_uniform_field(const MagnetizationLaw law,
                             const MagneticContent &content,
                             const Vector<dim> &factors,
                             const Vector<dim> &outer_field);

  /**
   * The same of a sphere, N = 1/dim.
   */
  template <int dim>
  UniformState<dim>
  sphere_in_uniform_field(const MagnetizationLaw law,
                          const MagneticContent &content,
                          const Vector<dim> &outer_field);

  /**
   * S(i,j) = int t_i x_j over the surface of a uniformly magnetized sphere about its centre, with
   * the traction t = mu_0/2 (M.n)^2 n of the jump of the Maxwell stress:
   *   S = mu_0/2 V (M^2 I + 2 M (x) M)/(dim + 2).
   *
   * @return [J], or [J/m].
   */
  template <int dim>
  Matrix<dim>
  surface_virial_of_sphere(const double volume, const Vector<dim> &magnetization);

  /**
   * The force of a dipole on a sphere of a linear medium [N], or [N/m]. The sphere answers the
   * harmonic of degree k of the dipole's potential with its mirror multipole, of relative strength
   *   a_k = k chi/(k chi + 2 k + 1)   (2D: chi/(chi + 2) for every k),
   * so that the energy of the dipole in the mirror field is, with p_r and p_t its parts along and
   * across the line of centres,
   *   U = -mu_0/(8 pi) sum_k a_k R^(2k+1)/D^(2k+4) [(k+1)^2 p_r^2 + k (k+1)/2 p_t^2],
   *   U = -mu_0/(4 pi) chi/(chi+2) R^2/(D^2 - R^2)^2 p^2   in 2D;
   * the force is its gradient.
   *
   * @param radius  R [m].
   * @param place   the dipole, from the centre of the sphere [m]; |place| > R.
   * @param dipole  p [A m^2], or [A m].
   */
  template <int dim>
  Vector<dim>
  force_of_dipole_on_sphere(const double susceptibility,
                            const double radius,
                            const Vector<dim> &place,
                            const Vector<dim> &dipole);
} // namespace magmpm::verification
