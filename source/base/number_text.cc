#include <magmpm/base/number_text.h>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <sstream>
#include <utility>

namespace magmpm
{
  namespace
  {
    template <typename... Values>
    std::string
    formatted(const char *format, const Values... values)
    {
      char text[64];
      std::snprintf(text, sizeof(text), format, values...);
      return text;
    }
  } // namespace

  std::string
  with_separators(const unsigned long value)
  {
    std::string text = std::to_string(value);
    for (int position = static_cast<int>(text.size()) - 3; position > 0; position -= 3)
      text.insert(position, ",");
    return text;
  }

  std::string
  with_digits(const unsigned long value, const int n_digits)
  {
    const std::string digits = std::to_string(value);
    return std::string(std::max<int>(n_digits - static_cast<int>(digits.size()), 0), '0') + digits;
  }

  std::string
  three_digits(const double value)
  {
    return formatted("%.3g", value);
  }

  std::string
  with_prefix(const double value, const std::string &unit)
  {
    static constexpr const char *prefixes[] = {"n", "u", "m", "", "k", "M", "G"};
    const int none = 3, last = std::size(prefixes) - 1;
    if (value == 0. || !std::isfinite(value))
      return three_digits(value) + ' ' + unit;

    // Rounded first, so that 999.9 becomes 1 k and not 1e+03.
    const double rounded = std::stod(formatted("%.2e", value));
    int prefix           = none + static_cast<int>(std::floor(std::log10(std::abs(rounded)) / 3.));
    prefix               = std::min(std::max(prefix, 0), last);
    return three_digits(rounded / std::pow(1000., prefix - none)) + ' ' + prefixes[prefix] + unit;
  }

  std::string
  scientific(const double value)
  {
    const std::string text     = formatted("%.1e", value);
    const std::size_t exponent = text.find('e');
    if (exponent == std::string::npos) // inf, nan
      return text;
    return text.substr(0, exponent + 1) + std::to_string(std::stoi(text.substr(exponent + 1)));
  }

  std::string
  duration(const double seconds)
  {
    if (seconds < 9.95)
      return formatted("%.1f s", seconds);
    const long whole = std::lround(seconds);
    if (whole < 60)
      return formatted("%ld s", whole);
    if (whole < 3600)
      return formatted("%ld min %ld s", whole / 60, whole % 60);
    return formatted("%ld h %ld min", whole / 3600, whole % 3600 / 60);
  }

  std::optional<double>
  seconds_from(const std::string &text)
  {
    std::istringstream stream(text);
    double number = 0.;
    std::string unit, rest;
    stream >> number >> unit;
    if (stream.fail() || (stream >> rest) || !(number > 0.))
      return {};
    for (const auto &[name, seconds] : {std::pair{"s", 1.}, {"min", 60.}, {"h", 3600.}})
      if (unit == name)
        return number * seconds;
    return {};
  }

  std::string
  to_text(const double number)
  {
    std::ostringstream text;
    text << number;
    return text.str();
  }
} // namespace magmpm
