#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/motion/time_function.h>

#include <string>

namespace magmpm
{
  /**
   * A vector that changes in time by a formula of the user: one expression of t [s] per component,
   * separated by semicolons or commas, as in "0.5; 0.5; 0.2 + 0.1*t". The expressions are those of
   * muParser (+ - * / ^, sin, exp, sqrt, if(t < 1, a, b), ...), and pi is known. The function is constant
   * if t does not occur. It throws an InputError at a time at which a component is infinite or not a
   * number.
   *
   * @param text        n expressions of t.
   * @param subject     what is given by them, for messages: "Position of magnet 'ball'".
   * @throw InputError  names subject and expression, if it does not have n components, cannot be parsed,
   *                    draws random numbers, or is not a number at t = 0.
   */
  template <int n>
  TimeFunction<Vector<n>>
  read_expression(const std::string &text, const std::string &subject);

  /** The same of one number. */
  TimeFunction<double>
  read_scalar_expression(const std::string &text, const std::string &subject);
} // namespace magmpm
