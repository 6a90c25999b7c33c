#pragma once

namespace magmpm::verification
{
  /**
   * Two elastic discs or balls (1 MPa, 1000 kg/m^3, nu = 0.3, R = 1 m) of two contact groups that meet head on in free
   * flight, as fast as each other.
   */
  struct Collision
  {
    int dim               = 2;
    int cells             = 8;    ///< of the lattice along a radius
    double speed          = 0.05; ///< of each over that of sound
    double offset         = 0.;   ///< of both from the lattice [dx]
    double elastic_factor = 0.4;  ///< dt c/dx
  };

  struct CollisionResult
  {
    double restitution;  ///< speed of the centres after over that before
    double contact_time; ///< from 1 to 99 % of the impulse, over R/c
    double gap_at_end;   ///< between the outermost particles that face each other [dx]
    double momentum;     ///< of both together, over that of one: of rounding
    double rise; ///< of the sum of all energies above its start, over the kinetic energy then
  };

  CollisionResult
  collide(const Collision &collision);

  /** The contact time of balls by Hertz, from 1 to 99 % of the impulse, over R/c. */
  double
  hertz_contact_time(const double speed);
} // namespace magmpm::verification
