#pragma once

#include <verification/magnetostatics/accuracy_case.h>

#include <optional>

namespace magmpm::verification
{
  /**
   * A cube (2D: a square) along the lattice, its edge the case's resolution in dx, against the
   * same of a finer run, there being no exact solution: "dipole moment" in a uniform field,
   * "dipole force" in the field of a dipole 1.5 edges from its centre.
   */
  template <int dim>
  class CubeErrors
  {
  public:
    /** @param fine  the finer run; done once, when first needed. */
    explicit CubeErrors(const AccuracyCase &fine)
      : fine(fine)
    {
    }

    Errors
    operator()(const AccuracyCase &accuracy_case);

  private:
    struct Result
    {
      Vector<dim> moment; ///< over the volume [A/m]
      Vector<dim> force;  ///< over the area of a face [Pa]
    };

    static Result
    solve(const AccuracyCase &accuracy_case);

    AccuracyCase fine;
    std::optional<Result> reference;
  };
} // namespace magmpm::verification
