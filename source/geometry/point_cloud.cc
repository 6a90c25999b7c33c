#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/point_cloud.h>
#include <magmpm/motion/pose.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

namespace magmpm
{
  namespace
  {
    std::string
    trimmed(const std::string &text)
    {
      const char *const space = " \t\r";
      const std::size_t first = text.find_first_not_of(space);
      return first == std::string::npos
               ? ""
               : text.substr(first, text.find_last_not_of(space) + 1 - first);
    }

    std::vector<std::string>
    cells_of(const std::string &line)
    {
      std::vector<std::string> cells;
      std::istringstream stream(line + ",");
      for (std::string cell; std::getline(stream, cell, ',');)
        cells.push_back(trimmed(cell));
      return cells;
    }

    std::optional<double>
    number_from(const std::string &text)
    {
      char *end           = nullptr;
      const double number = std::strtod(text.c_str(), &end);
      if (text.empty() || *end != '\0' || !std::isfinite(number))
        return {};
      return number;
    }

    /** The numbers of a line. @param where  "cloud.csv, line 3: ". */
    template <int dim>
    std::vector<double>
    numbers_of(const std::vector<std::string> &cells,
               const std::size_t n_expected,
               const std::string &where)
    {
      const std::string columns = dim == 3 ? "x, y, z or x, y, z, volume" : "x, y or x, y, area";
      if (cells.size() != dim && cells.size() != dim + 1)
        throw InputError(where + "there are " + std::to_string(cells.size()) +
                         " columns; a point is " + columns + ", separated by commas.");
      if (n_expected > 0 && cells.size() != n_expected)
        throw InputError(where + "there are " + std::to_string(cells.size()) + " columns, but " +
                         std::to_string(n_expected) +
                         " in the lines before. Give a volume in all lines or in none.");
      std::vector<double> numbers;
      for (const std::string &cell : cells)
        {
          const std::optional<double> number = number_from(cell);
          if (!number)
            throw InputError(where + "'" + cell + "' is not a number; a point is " + columns + ".");
          numbers.push_back(*number);
        }
      if (numbers.size() == dim + 1 && !(numbers[dim] > 0.))
        throw InputError(where + "the volume is " + cells[dim] + "; it must be greater than 0.");
      return numbers;
    }
  } // namespace

  template <int dim>
  PointCloud<dim>
  read_point_cloud(const ShapeParameters<dim> &parameters)
  {
    errno = 0;
    std::ifstream stream(parameters.file);
    if (!stream)
      throw InputError(parameters.file + ": cannot read the points: " +
                       std::strerror(errno == 0 ? EIO : errno) + ".");

    const Matrix<dim> rotation = rotation_by<dim>(parameters.rotation);
    const double volume_scale  = std::pow(parameters.scale, dim);
    PointCloud<dim> cloud;
    bool may_be_heading    = true;
    std::size_t n_expected = 0;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
      {
        line = trimmed(line);
        if (line.empty() || line[0] == '#')
          continue;
        const std::vector<std::string> cells = cells_of(line);
        const bool is_heading                = may_be_heading && !number_from(cells[0]);
        may_be_heading                       = false;
        if (is_heading)
          continue;

        const std::vector<double> numbers = numbers_of<dim>(
          cells, n_expected, parameters.file + ", line " + std::to_string(number) + ": ");
        n_expected = numbers.size();
        Vector<dim> point;
        std::copy(numbers.begin(), numbers.begin() + dim, point.values);
        cloud.points.push_back(parameters.translation + rotation * (parameters.scale * point));
        cloud.lines.push_back(number);
        if (n_expected > dim)
          cloud.volumes.push_back(volume_scale * numbers[dim]);
      }
    if (cloud.points.empty())
      throw InputError(parameters.file + ": there is no point in this file.");
    return cloud;
  }

  template PointCloud<2>
  read_point_cloud(const ShapeParameters<2> &);
  template PointCloud<3>
  read_point_cloud(const ShapeParameters<3> &);
} // namespace magmpm
