#pragma once

namespace magmpm::verification
{
  /** What stands below: a wall of the box, a rigid body that does not move, or an elastic slab on a wall. */
  enum class Ground
  {
    wall,
    body,
    slab ///< of an incline, of the block's material, in a contact group of its own
  };

  /**
   * An elastic square or cube of 1 m (1 MPa, 1000 kg/m^3, nu = 0.3) that flies onto the ground, which separates,
   * without gravity; in 2D plane strain.
   */
  struct Impact
  {
    int dim       = 2;
    int cells     = 8; ///< of the lattice along an edge
    Ground ground = Ground::body;
    double offset =
      0.; ///< of the ground, if it is a body, from the lattice; otherwise of the block [dx]
    double speed          = 0.1; ///< over that of sound
    double elastic_factor = 0.4; ///< dt c/dx
  };

  struct ImpactResult
  {
    double rebound;   ///< momentum after over that before
    double first_gap; ///< deepest gap in the first step with a force [dx]
    double way;       ///< of the block in a step [dx]
    double deepest;   ///< contact, that is -gap [dx]
    double rise;      ///< of the sum of all energies above its start, over the kinetic energy then
  };

  ImpactResult
  impact(const Impact &impact);

  /** A block of 1 m x 0.5 m (3D: x 1 m) that slides, or does not, down an incline of 0.3 rad from rest. */
  struct Incline
  {
    int dim         = 2;
    Ground ground   = Ground::body;
    double offset   = 0.; ///< of the block, along the ground, and of a body from the lattice [dx]
    double friction = 0.;
    double damping_rate = 0.; ///< [1/s]; the block's length over its speed of sound is 27 ms
  };

  struct InclineResult
  {
    double way;   ///< over that of a rigid block, less 1; without meaning if that stays where it is
    double creep; ///< in the second half of the time [dx]
  };

  InclineResult
  slide(const Incline &incline);

  /** What a falling cube hits: a ball of 3.2 dx, or a box of 6.4 dx, 0.2 dx wider than the cube on each side. */
  enum class Obstruction
  {
    ball,
    box
  };

  /**
   * A soft cube of six cells (100 kPa, 2500 kg/m^3) that gravity draws onto a body which separates, at 0.29 of its
   * speed of sound.
   *
   * @return the largest rise of the sum of all energies above its lowest value before, over the largest kinetic
   *         energy.
   */
  double
  energy_rise_on(const Obstruction obstruction, const double elastic_factor);
} // namespace magmpm::verification
