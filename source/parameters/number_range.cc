#include <magmpm/parameters/number_range.h>
#include <magmpm/parameters/parameter_names.h>

#include <algorithm>
#include <locale>
#include <sstream>
#include <vector>

namespace magmpm
{
  namespace
  {
    /** All of @p text as a number; false if it is none. */
    bool
    read_number(const std::string &text, double &number)
    {
      std::istringstream stream(text);
      stream.imbue(std::locale::classic());
      return static_cast<bool>(stream >> number) && (stream >> std::ws).eof();
    }
  } // namespace

  bool
  NumberRange::contains(const double number) const
  {
    return (minimum_excluded ? number > minimum : number >= minimum) &&
           (maximum_excluded ? number < maximum : number <= maximum);
  }

  std::string
  NumberRange::description() const
  {
    if (minimum == any_number.minimum)
      return "";
    if (maximum == any_number.maximum)
      return (minimum_excluded ? "> " : ">= ") + exact_text(minimum);
    if (minimum_excluded || maximum_excluded)
      return "above " + exact_text(minimum) + " and below " + exact_text(maximum);
    return "from " + exact_text(minimum) + " to " + exact_text(maximum);
  }

  std::string
  NumberRange::in_words(const int n, const bool integer) const
  {
    if (n > 1)
      return std::to_string(n) + " numbers, separated by commas";
    const std::string limits = description();
    return (integer ? "an integer" : "a number") + (limits.empty() ? "" : " " + limits);
  }

  std::string
  exact_text(const double number)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(15);
    text << number;
    return text.str();
  }

  bool
  read_numbers(const std::string &text, const NumberRange &range, const int n, double *numbers)
  {
    std::vector<double> read;
    for (const std::string &part : split(text, ','))
      {
        double number = 0.;
        if (!read_number(part, number) || !range.contains(number))
          return false;
        read.push_back(number);
      }
    if (static_cast<int>(read.size()) != n)
      return false;
    std::copy(read.begin(), read.end(), numbers);
    return true;
  }
} // namespace magmpm
