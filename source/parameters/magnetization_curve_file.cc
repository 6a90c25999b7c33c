#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/magnetization_curve_file.h>

#include <algorithm>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /** The numbers of a line, as far as they are; whether anything else stands there. */
    struct Line
    {
      std::vector<double> numbers;
      bool has_rest = false;

      explicit Line(std::string text)
      {
        text.erase(std::find(text.begin(), text.end(), '#'), text.end());
        for (char &letter : text)
          if (letter == ',' || letter == ';')
            letter = ' ';
        std::istringstream words(text);
        double number;
        while (words >> number)
          numbers.push_back(number);
        words.clear();
        std::string rest;
        has_rest = static_cast<bool>(words >> rest);
      }
    };

    /** The points without (0, 0), each checked against the one before it. */
    struct Points
    {
      std::vector<double> fields, magnetizations;

      /** @return what is wrong with the next point, or nothing. */
      std::string
      add(const double field, const double magnetization)
      {
        if (field == 0. && magnetization == 0. && fields.empty())
          return "";
        const double last_field = fields.empty() ? 0. : fields.back();
        const double last       = magnetizations.empty() ? 0. : magnetizations.back();
        if (!(field > last_field))
          return "H must be greater than that of the point before it (" + to_text(last_field) +
                 " A/m; the curve begins at 0, 0)";
        if (!(magnetization > 0. && magnetization >= last))
          return "M must be greater than 0 and not smaller than that of the point before it (" +
                 to_text(last) + " A/m)";
        fields.push_back(field);
        magnetizations.push_back(magnetization);
        return "";
      }
    };
  } // namespace

  MagnetizationCurve
  read_magnetization_curve(std::istream &file, const std::string &name)
  {
    Points points;
    bool may_be_heading = true;
    std::string text;
    for (int number = 1; std::getline(file, text); ++number)
      {
        const Line line(text);
        const bool is_heading = (may_be_heading && line.has_rest && line.numbers.empty());
        if (is_heading)
          may_be_heading = false;
        if (is_heading || (line.numbers.empty() && !line.has_rest))
          continue;
        may_be_heading      = false;
        std::string mistake = "there must be two numbers, H and M [A/m]";
        if (line.numbers.size() == 2 && !line.has_rest)
          mistake = points.add(line.numbers[0], line.numbers[1]);
        if (!mistake.empty())
          throw InputError(name + ", line " + std::to_string(number) + ": " + text + ": " +
                           mistake + ". Correct this line.");
      }
    if (points.fields.size() < MagnetizationCurve::min_points)
      throw InputError(name + ": a magnetization curve needs " +
                       std::to_string(MagnetizationCurve::min_points) +
                       " points or more beside 0, 0; there are " +
                       std::to_string(points.fields.size()) + ". Add lines 'H, M' [A/m].");
    return {points.fields, points.magnetizations};
  }
} // namespace magmpm
