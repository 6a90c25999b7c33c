#pragma once

#include <limits>
#include <string>

namespace magmpm
{
  /** Which numbers a parameter allows. */
  struct NumberRange
  {
    double minimum        = -std::numeric_limits<double>::infinity();
    double maximum        = std::numeric_limits<double>::infinity();
    bool minimum_excluded = false;
    bool maximum_excluded = false;

    bool
    contains(const double number) const;

    /** "> 0", "from 0 to 1", or nothing if every number is allowed. */
    std::string
    description() const;

    /** "a number > 0" or "an integer from 1 to 8"; for @p n numbers "3 numbers, separated by commas". */
    std::string
    in_words(const int n, const bool integer) const;
  };

  inline const NumberRange any_number   = {};
  inline const NumberRange positive     = {0., any_number.maximum, true, false};
  inline const NumberRange not_negative = {0., any_number.maximum, false, false};
  inline const NumberRange at_least_one = {1., any_number.maximum, false, false};

  /** The shortest text of up to 15 digits; read again, it is the same number where these are enough. */
  std::string
  exact_text(const double number);

  /**
   * Reads @p n numbers, separated by commas, into @p numbers.
   *
   * @return whether these are there, in the range, and nothing else; if not, @p numbers stay as they are.
   */
  bool
  read_numbers(const std::string &text, const NumberRange &range, const int n, double *numbers);
} // namespace magmpm
