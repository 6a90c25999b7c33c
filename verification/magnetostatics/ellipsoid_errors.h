#pragma once

#include <verification/magnetostatics/accuracy_case.h>

namespace magmpm::verification
{
  /**
   * A prolate spheroid (2D: an ellipse) of axes 2:1 and the volume of a sphere of radius R, a
   * field at 45 degrees to its long axis: "torque", sum (x - c) x f_i of the nodes against
   * mu_0 V M x H_0, and "dipole moment". Where M and H are parallel, M x H_0 is all in the
   * antisymmetric part of the stress h (x) (h + M), so that this tests which of its indices meets
   * grad N_i. "torque, particles": of the force that particles carry.
   */
  template <int dim>
  Errors
  torque_errors(const AccuracyCase &accuracy_case);

  /**
   * A thin sheet, an ellipsoid of 24 x 24 dx (2D: 24 dx) and a thickness of the case's resolution
   * in dx, oblique to the lattice: "moment, field in the plane" and "moment, field across", along
   * the field.
   */
  template <int dim>
  Errors
  sheet_errors(const AccuracyCase &accuracy_case);

  /**
   * A drop with a radius of the case's resolution: "moment along H_0", "dipole moment" (all
   * components), "number of grains".
   */
  template <int dim>
  Errors
  drop_errors(const AccuracyCase &accuracy_case);

  /** One particle, against a sphere of its volume: errors as of a drop. */
  template <int dim>
  Errors
  particle_errors(const AccuracyCase &accuracy_case);
} // namespace magmpm::verification
