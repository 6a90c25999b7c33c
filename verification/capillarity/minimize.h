#pragma once

#include <functional>
#include <vector>

namespace magmpm::verification
{
  struct ValueAndGradient
  {
    double value;
    std::vector<double> gradient;
  };

  /** A function of several numbers; infinite where it has no value. */
  using SmoothFunction = std::function<ValueAndGradient(const std::vector<double> &)>;

  struct Minimum
  {
    std::vector<double> place;
    double value;
    double slope; ///< the size of the gradient that is left
  };

  /**
   * The minimum down the hill from @p start, by Broyden, Fletcher, Goldfarb and Shanno with steps that are halved until
   * the value falls by a part of what the gradient promises.
   *
   * @param first_step  length of the first step: small against the way to other minima.
   * @param tolerance   of the gradient.
   */
  Minimum
  minimize(const SmoothFunction &function,
           const std::vector<double> &start,
           const double first_step,
           const double tolerance);
} // namespace magmpm::verification
