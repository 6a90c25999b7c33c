#pragma once

#include <verification/magnetostatics/accuracy_case.h>

namespace magmpm::verification
{
  /**
   * Two spheres of radius R in a uniform field, a gap of R/2 between them, the field oblique to the
   * line of centres, so that the forces between them are all there is: "third law", |F_1 + F_2|
   * over |F|; "pair force" against the exact one, the mean of the two spheres; "dipole moment" of
   * both.
   */
  template <int dim>
  Errors
  pair_errors(const AccuracyCase &accuracy_case);

  /**
   * The same of spheres of radius R and R/2: "third law", "pair force" on the small one, and
   * "moment, large", "moment, small".
   *
   * @param small_susceptibility  of the small one; the large one is of the case's medium.
   */
  template <int dim>
  Errors
  unequal_pair_errors(const AccuracyCase &accuracy_case, const double small_susceptibility);
} // namespace magmpm::verification
