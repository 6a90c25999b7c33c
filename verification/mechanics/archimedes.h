#pragma once

namespace magmpm::verification
{
  /** A fluid at rest between walls, as deep as `depth` while nothing weighs on it; p = K (1 - J). */
  struct Pool
  {
    int dim             = 2;
    double width        = 0.; ///< [m]; in 3D the base is a square
    double depth        = 0.; ///< [m]
    double density      = 0.; ///< of the undeformed fluid [kg/m^3]
    double bulk_modulus = 0.; ///< [Pa]
    double gravity      = 9.81;

    /** Density of the fluid so far below its surface, compressed as it is by what is above [kg/m^3]. */
    double
    density_at(const double depth) const;

    /** Where the surface is above the floor [m], with nothing in the pool. */
    double
    level() const;
  };

  /** A body that floats: a disc or ball, or a square or cube that is turned about a horizontal edge. */
  struct Floater
  {
    bool is_round    = true;
    double half_size = 0.; ///< its radius, or half an edge [m]
    double density   = 0.; ///< [kg/m^3]
    double turn      = 0.; ///< from upright [rad]

    double
    volume(const int dim) const;

    /** From its lowest point to its centre [m]. */
    double
    half_height() const;

    /** Of the section so far above its centre: a length in 2D, an area in 3D. */
    double
    section(const int dim, const double height) const;
  };

  /**
   * Height of the centre of a floating body above the floor [m]: it displaces its own mass of the fluid, layer
   * by layer of the density that the fluid has there, and raises the surface as so much fluid would.
   *
   * @param floater  lighter than the fluid, of which it does not reach the floor.
   */
  double
  floating_height(const Pool &pool, const Floater &floater);
} // namespace magmpm::verification
