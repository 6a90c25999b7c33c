#pragma once

#include <verification/capillarity/magnetic_spheroid.h>
#include <verification/capillarity/minimize.h>
#include <verification/capillarity/tensor_elements.h>

#include <vector>

namespace magmpm::verification
{
  /**
   * The energy of a drop of a linear medium in a uniform field H_0, of any shape r(x) that is symmetric about its axis and
   * its equator, x the cosine of the angle to the axis (2D: the angle to the equator):
   *   ln r = c + sum_n a_n P_2n(x)   (2D: cos 2n(pi/2 - x)),   c such that the volume is that of r = 1.
   * The field is H_0 - grad phi, where phi makes
   *   1/2 int mu/mu_0 |grad phi|^2 - chi int_drop H_0.grad phi
   * least, and the magnetic energy is -N/2 (chi V + int (mu/mu_0 |grad phi|^2 - 2 chi H_0.grad phi)). Space is mapped onto
   * two rectangles, t = distance/r inside and r/distance outside, where the potential of any number of poles is a
   * polynomial in t: there is no boundary at a finite distance. Units as for the spheroid.
   */
  class MagneticDropEnergy
  {
  public:
    MagneticDropEnergy(const MagneticDrop &drop, const double bond_number);

    /** The energy and its derivatives. @param modes  a_n, n = 1, 2, ... */
    ValueAndGradient
    operator()(const std::vector<double> &modes) const;

    /** ln(r), less c, at the axis less that at the equator: of the aspect ratio. */
    double
    log_aspect(const std::vector<double> &modes) const;

    /** Square root of the ratio of second moments of the volume along and across the axis. */
    double
    moment_aspect(const std::vector<double> &modes) const;

    /** A mode and its slope at x. */
    PlaneGradient
    mode(const int n, const double x) const;

  private:
    const MagneticDrop drop;
    const double bond_number;
    const double turn; ///< quadrature over x and t covers 1/turn of space
    const TensorElements elements;

    /** u = ln r at x, its slope, and the derivatives of the energy by both, over weights of quadrature. */
    struct Ray
    {
      double x, log_radius, slope;
      double by_log_radius = 0., by_slope = 0.;
    };

    /** The magnetic energy; adds its derivatives. */
    double
    magnetic_energy(std::vector<Ray> &rays) const;

    QuadraticForm
    form(const ElementPoint &point, const Ray &ray) const;
  };

  struct MagneticDropShape
  {
    std::vector<double> modes;
    double aspect; ///< r on the axis over that at the equator
    double
      moment_aspect; ///< square root of the ratio of second moments along and across; the aspect of a spheroid
    double energy;
  };

  /**
   * The shape of least energy down the hill from @p start, modes of another shape; {}: from a sphere.
   *
   * @param n_modes  more for longer drops: 8 do for an aspect ratio of 3, to 1e-3.
   */
  MagneticDropShape
  magnetic_drop_shape(const MagneticDrop &drop,
                      const double bond_number,
                      const std::vector<double> &start = {},
                      const int n_modes                = 8);
} // namespace magmpm::verification
