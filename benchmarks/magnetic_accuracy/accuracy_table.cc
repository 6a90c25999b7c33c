#include <magnetic_accuracy/accuracy_table.h>

#include <verification/magnetostatics/accuracy_limits.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace magmpm::benchmarks
{
  using namespace verification;

  namespace
  {
    template <typename... Values>
    std::string
    format(const char *pattern, const Values... values)
    {
      char text[256];
      std::snprintf(text, sizeof(text), pattern, values...);
      return text;
    }

    std::string
    title(const CaseName &name)
    {
      return name.group + (name.variant.empty() ? "" : " (" + name.variant + ")") +
             format(", %dD", name.dim);
    }

    /** Slope of ln(error) over ln(dx), by least squares. */
    double
    fitted_order(const std::vector<std::pair<double, double>> &resolution_and_error)
    {
      double sum_x = 0., sum_y = 0., sum_xx = 0., sum_xy = 0.;
      const double n = resolution_and_error.size();
      for (const auto &[resolution, error] : resolution_and_error)
        {
          const double x = -std::log(resolution), y = std::log(error);
          sum_x += x;
          sum_y += y;
          sum_xx += x * x;
          sum_xy += x * y;
        }
      return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
    }
  } // namespace

  AccuracyTable::AccuracyTable(std::ostream &stream, const bool csv)
    : stream(stream)
    , csv(csv)
  {
    if (csv)
      stream << "name,value,limit" << std::endl;
  }

  void
  AccuracyTable::print_row(const CaseName &name,
                           const std::size_t n_offsets,
                           const std::string &measure,
                           const double rms,
                           const double largest)
  {
    const std::optional<double> limit =
      accuracy_limit(name.dim, name.group, name.variant, name.resolution, measure);
    // A value that is not a number misses its limit.
    const bool is_missed = limit && !(rms <= *limit);
    missed += is_missed;
    if (csv)
      {
        std::string quoted = title(name) + format(": R/dx %.4g: ", name.resolution) + measure;
        std::replace(quoted.begin(), quoted.end(), ',', ';');
        stream << quoted << format(",%.6e,", rms) << (limit ? format("%g", *limit) : "")
               << std::endl;
      }
    else
      stream << format("%6.4g %8zu   %-28s %9.1e %9.1e ",
                       name.resolution,
                       n_offsets,
                       measure.c_str(),
                       rms,
                       largest)
             << (limit ? format("%9.1e", *limit) : "        -") << (is_missed ? "  MISSED" : "")
             << std::endl;
  }

  void
  AccuracyTable::add(const CaseName &name, const std::vector<Errors> &offsets)
  {
    if (!csv && points.empty())
      stream
        << std::endl
        << title(name) << std::endl
        << format(
             "%6s %8s   %-28s %9s %9s %9s", "R/dx", "offsets", "error", "rms", "largest", "limit")
        << std::endl;
    last_name = name;

    Point point = {name.resolution, {}};
    for (std::size_t m = 0; m < offsets.front().size(); ++m)
      {
        double sum = 0., largest = 0.;
        for (const Errors &errors : offsets)
          {
            sum += errors[m].value * errors[m].value;
            largest = std::max(largest, std::abs(errors[m].value));
          }
        const double rms = std::sqrt(sum / offsets.size());
        point.rms.push_back({offsets.front()[m].name, rms});
        print_row(name, offsets.size(), point.rms.back().name, rms, largest);
      }
    points.push_back(point);
  }

  void
  AccuracyTable::add_orders()
  {
    if (points.size() > 1)
      for (std::size_t m = 0; m < points.front().rms.size(); ++m)
        {
          std::vector<std::pair<double, double>> errors;
          for (const Point &point : points)
            errors.push_back({point.resolution, point.rms[m].value});
          const std::string &measure = points.front().rms[m].name;
          if (csv)
            {
              std::string quoted = title(last_name) + ": order: " + measure;
              std::replace(quoted.begin(), quoted.end(), ',', ';');
              stream << quoted << format(",%.3f,", fitted_order(errors)) << std::endl;
            }
          else
            stream << format(" order            %-28s %9.2f", measure.c_str(), fitted_order(errors))
                   << std::endl;
        }
  }

  void
  AccuracyTable::end_series()
  {
    points.clear();
  }
} // namespace magmpm::benchmarks
