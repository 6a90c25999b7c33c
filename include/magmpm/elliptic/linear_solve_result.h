#pragma once

#include <string>

namespace magmpm
{
  /** How conjugate gradients ended. */
  struct LinearSolveResult
  {
    int iterations = 0;
    std::string failure; ///< completes "it was not solved ..."; empty if it was

    bool
    is_solved() const
    {
      return failure.empty();
    }

    static LinearSolveResult
    unsolved_in(const int iterations)
    {
      return {iterations, "in " + std::to_string(iterations) + " iterations of CG"};
    }
  };
} // namespace magmpm
