#include <magmpm/base/exceptions.h>
#include <magmpm/motion/key_frames.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

namespace magmpm
{
  bool
  is_key_frame_table(const std::string &text)
  {
    std::istringstream stream(text);
    double number;
    return static_cast<bool>(stream >> number);
  }

  namespace
  {
    [[noreturn]] void
    refuse(const std::string &subject, const std::string &complaint)
    {
      throw InputError(subject + ": " + complaint);
    }

    /** Lines of the file, or what semicolons separate; without comments and what is empty. */
    std::vector<std::string>
    lines_of(const std::string &table, const std::string &subject)
    {
      std::vector<std::string> lines;
      const auto keep_lines = [&](std::istream &stream, const char separator) {
        std::string line;
        while (std::getline(stream, line, separator))
          if (const auto first = line.find_first_not_of(" \t\r");
              first != std::string::npos && line[first] != '#')
            lines.push_back(line.substr(first, line.find_last_not_of(" \t\r") - first + 1));
      };
      if (is_key_frame_table(table))
        {
          std::istringstream stream(table);
          keep_lines(stream, ';');
          return lines;
        }
      std::ifstream stream(table);
      if (!stream)
        refuse(subject,
               "there is no file '" + table +
                 "' that can be read. Give the name of a CSV file, or the rows themselves, "
                 "separated by semicolons.");
      keep_lines(stream, '\n');
      if (!lines.empty() && !is_key_frame_table(lines.front()))
        lines.erase(lines.begin());
      return lines;
    }

    template <int dim>
    std::string
    advice()
    {
      const std::string position = dim == 3 ? "x, y, z" : "x, y";
      const std::string rotation = dim == 3 ? "three numbers" : "one number";
      return "Give in each row: time, " + position +
             ", then either nothing more, or the rotation (" + rotation +
             "), or the rotation and the strength.";
    }

    template <int dim>
    std::vector<double>
    numbers_in(const std::string &line, const std::string &subject)
    {
      std::vector<double> numbers;
      std::istringstream fields(line);
      std::string field;
      while (std::getline(fields, field, ','))
        {
          std::istringstream stream(field);
          double number;
          if (!(stream >> number) || !(stream >> std::ws).eof() || !std::isfinite(number))
            refuse(subject, "'" + field + "' in the row '" + line + "' is not a number.");
          numbers.push_back(number);
        }
      const std::size_t shortest = 1 + dim, turned = shortest + n_axial_components<dim>;
      if (numbers.size() != shortest && numbers.size() != turned && numbers.size() != turned + 1)
        refuse(subject,
               "the row '" + line + "' has " + std::to_string(numbers.size()) + " number" +
                 (numbers.size() == 1 ? ". " : "s. ") + advice<dim>());
      return numbers;
    }

    template <int dim>
    struct KeyFrame
    {
      double time;
      Pose<dim> pose;
      double strength;
    };

    template <int dim>
    std::vector<KeyFrame<dim>>
    rows_of(const std::string &table, const std::string &subject)
    {
      std::vector<KeyFrame<dim>> rows;
      std::size_t n_numbers = 0;
      for (const std::string &line : lines_of(table, subject))
        {
          const std::vector<double> numbers = numbers_in<dim>(line, subject);
          if (!rows.empty() && numbers.size() != n_numbers)
            refuse(subject,
                   "the row '" + line + "' has " + std::to_string(numbers.size()) +
                     " numbers, the one before it " + std::to_string(n_numbers) +
                     ". All rows must have equally many.");
          n_numbers = numbers.size();

          KeyFrame<dim> row{numbers[0], {}, 1.};
          auto next = numbers.begin() + 1;
          std::copy_n(next, dim, row.pose.position.values);
          next += dim;
          if (next != numbers.end())
            {
              Vector<n_axial_components<dim>> angle;
              std::copy_n(next, n_axial_components<dim>, angle.values);
              next += n_axial_components<dim>;
              row.pose.rotation = rotation_by<dim>(angle);
            }
          if (next != numbers.end())
            row.strength = *next;
          if (!rows.empty() && !(row.time > rows.back().time))
            refuse(subject,
                   "the time of the row '" + line +
                     "' is not later than that of the row before it. Times must increase.");
          rows.push_back(row);
        }
      if (rows.empty())
        refuse(subject, "there is no row in '" + table + "'. " + advice<dim>());
      return rows;
    }

    /** The rows, and what is between them. */
    template <int dim>
    class Interpolation
    {
    public:
      Interpolation(std::vector<KeyFrame<dim>> rows, const KeyFrameInterpolation kind)
        : rows(std::move(rows))
        , kind(kind)
      {
      }

      Pose<dim>
      pose(const double time) const
      {
        const auto [before, done] = place(time);
        const Pose<dim> &start    = rows[before].pose;
        if (done == 0.)
          return start;
        const Pose<dim> &end = rows[before + 1].pose;
        const auto whole     = rotation_vector<dim>(end.rotation * transpose(start.rotation));
        return {start.position + done * (end.position - start.position),
                rotation_by<dim>(done * whole) * start.rotation};
      }

      double
      strength(const double time) const
      {
        const auto [before, done] = place(time);
        const double start        = rows[before].strength;
        return done == 0. ? start : start + done * (rows[before + 1].strength - start);
      }

    private:
      /** The row before @p time and how much of the way to the next one is done, 0 to 1. */
      std::pair<std::size_t, double>
      place(const double time) const
      {
        const auto next =
          std::upper_bound(rows.begin(), rows.end(), time, [](const double t, const auto &row) {
            return t < row.time;
          });
        if (next == rows.begin())
          return {0, 0.};
        const std::size_t before = next - rows.begin() - 1;
        if (next == rows.end())
          return {before, 0.};
        const double s = (time - rows[before].time) / (next->time - rows[before].time);
        return {before, kind == KeyFrameInterpolation::smooth ? s * s * (3. - 2. * s) : s};
      }

      const std::vector<KeyFrame<dim>> rows;
      const KeyFrameInterpolation kind;
    };
  } // namespace

  template <int dim>
  KeyFrames<dim>
  read_key_frames(const std::string &table,
                  const KeyFrameInterpolation interpolation,
                  const std::string &subject)
  {
    const std::vector<KeyFrame<dim>> rows = rows_of<dim>(table, subject);
    const auto is_everywhere              = [&](const auto &is_first) {
      return std::all_of(rows.begin(), rows.end(), is_first);
    };
    const bool same_pose = is_everywhere([&](const KeyFrame<dim> &row) {
      return norm(row.pose.position - rows[0].pose.position) == 0. &&
             frobenius_norm(row.pose.rotation + (-1.) * rows[0].pose.rotation) == 0.;
    });
    const bool same_strength =
      is_everywhere([&](const KeyFrame<dim> &row) { return row.strength == rows[0].strength; });

    const auto between = std::make_shared<const Interpolation<dim>>(rows, interpolation);
    KeyFrames<dim> result;
    result.pose = rows[0].pose;
    if (!same_pose)
      result.pose =
        TimeFunction<Pose<dim>>([between](const double time) { return between->pose(time); });
    result.strength = rows[0].strength;
    if (!same_strength)
      result.strength =
        TimeFunction<double>([between](const double time) { return between->strength(time); });
    return result;
  }

  template KeyFrames<2>
  read_key_frames(const std::string &, KeyFrameInterpolation, const std::string &);
  template KeyFrames<3>
  read_key_frames(const std::string &, KeyFrameInterpolation, const std::string &);
} // namespace magmpm
