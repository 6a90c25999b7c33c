#pragma once

#include <verification/magnetostatics/accuracy_case.h>

namespace magmpm::verification
{
  /**
   * A sphere (2D: a cylinder) in a uniform field:
   * - "dipole moment";
   * - "rms H inside 0.7 R", and "mean H inside 0.7 R";
   * - "virial deviator", along the field, of sum f_i (x - c) over the nodes: the test of the
   *   surface traction; "virial deviator, particles" of the force that particles carry;
   * - "virial trace";
   * - "net force", sum f_i over mu_0 M^2 V/R.
   */
  template <int dim>
  Errors
  uniform_field_errors(const AccuracyCase &accuracy_case);

  /** A sphere of a linear medium in the field of a dipole 3 R from its centre: "dipole force". */
  template <int dim>
  Errors
  dipole_field_errors(const AccuracyCase &accuracy_case);

  /** Both. */
  template <int dim>
  Errors
  sphere_errors(const AccuracyCase &accuracy_case);

  /**
   * A solid magnet of radius 0.6 R, its surface 0.2 R from that of the sphere, "force", and touching it,
   * "force in contact".
   */
  template <int dim>
  Errors
  magnet_errors(const AccuracyCase &accuracy_case);

  /**
   * Moment in a uniform field and force near a dipole, in the potential box of the case against one
   * 16 times as wide: "dipole moment, box", "dipole force, box". The mechanical box is 32 dx wide.
   */
  template <int dim>
  Errors
  box_errors(const AccuracyCase &accuracy_case);

  /**
   * A sphere moved by 4 dx towards a dipole, 3 R away at first: "force noise", rms of the force
   * over the exact one after subtraction of a cubic polynomial of the way; "work", of the force,
   * against the change of the energy.
   */
  template <int dim>
  Errors
  translation_errors(const AccuracyCase &accuracy_case);
} // namespace magmpm::verification
