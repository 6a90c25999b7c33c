#pragma once

#include <magmpm/base/tensor.h>

#include <optional>
#include <sstream>
#include <string>

/** Numbers as people like to read them. */
namespace magmpm
{
  /** 110592 as "110,592". */
  std::string
  with_separators(const unsigned long value);

  /** 7, 4 as "0007": at least this many digits, so that names come in the order of numbers. */
  std::string
  with_digits(const unsigned long value, const int n_digits);

  /** 0.91234 as "0.912": three digits. */
  std::string
  three_digits(const double value);

  /** 0.0078125, "m" as "7.81 mm": three digits and a prefix from n (nano) to G (giga). */
  std::string
  with_prefix(const double value, const std::string &unit);

  /** 1.94e-4 as "1.9e-4": two digits, no plus sign or zeros in the exponent. */
  std::string
  scientific(const double value);

  /** 0.25 as "0.25": six digits, as a message needs them. */
  std::string
  to_text(const double number);

  /** {0.25, 0.5} as "0.25, 0.5". */
  template <int dim>
  inline std::string
  components(const Vector<dim> &vector)
  {
    std::ostringstream text;
    for (int d = 0; d < dim; ++d)
      text << (d == 0 ? "" : ", ") << vector[d];
    return text.str();
  }

  /** 90.3 [s] as "1 min 30 s": the two largest of h, min, s; tenths below ten seconds. */
  std::string
  duration(const double seconds);

  /** "90 s", "10 min" or "1.5 h" in seconds; nothing if the text is no positive time of this kind. */
  std::optional<double>
  seconds_from(const std::string &text);
} // namespace magmpm
