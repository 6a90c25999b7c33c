#pragma once

#include <magmpm/base/tensor.h>

#include <functional>
#include <string>
#include <vector>

namespace magmpm
{
  /** A column of statistics.csv: its name and how to find its value in a row. */
  struct Column
  {
    std::string name;
    std::string unit;               ///< "m/s"; empty for counts and texts
    std::function<double()> number; ///< one of the two is there
    std::function<std::string()> text;
  };

  /** The letter of a component of a vector of @p n: x, y, z; z for an axial vector in 2D. */
  inline char
  component_letter(const int component, const int n)
  {
    return n == 1 ? 'z' : "xyz"[component];
  }

  /** Name of the column (or, for a vector, columns) @p quantity of one body. */
  inline std::string
  body_column(const std::string &body, const std::string &quantity)
  {
    return body + ": " + quantity;
  }

  /**
   * The columns of statistics.csv, to which the scene and each coupling add their own: the only list of
   * them. Whoever adds a column must outlive the table, since its value is asked for in every row.
   *
   * doc/statistics.md says what each one means; a test holds that it names them all. In 2D what adds up
   * over a body is per metre of depth: see ColumnUnits.
   */
  class ColumnTable
  {
  public:
    void
    add(const std::string &name, const std::string &unit, std::function<double()> value)
    {
      columns.push_back({name, unit, std::move(value), {}});
    }

    void
    add_text(const std::string &name, std::function<std::string()> value)
    {
      columns.push_back({name, "", {}, std::move(value)});
    }

    /** Columns "name x", "name y", "name z" (in 2D: x, y; axial in 2D: z alone). */
    template <int n>
    void
    add_vector(const std::string &name,
               const std::string &unit,
               const std::function<Vector<n>()> &value)
    {
      for (int i = 0; i < n; ++i)
        add(name + ' ' + component_letter(i, n), unit, [value, i]() { return value()[i]; });
    }

    const std::vector<Column> &
    all() const
    {
      return columns;
    }

  private:
    std::vector<Column> columns;
  };

  /** Units of what adds up over a body: in 2D they are per metre of depth. */
  template <int dim>
  struct ColumnUnits;

  template <>
  struct ColumnUnits<2>
  {
    static constexpr const char *energy           = "J/m";
    static constexpr const char *momentum         = "kg/s";
    static constexpr const char *angular_momentum = "kg m/s";
    static constexpr const char *force            = "N/m";
    static constexpr const char *torque           = "N";
    static constexpr const char *magnetic_moment  = "A m";
  };

  template <>
  struct ColumnUnits<3>
  {
    static constexpr const char *energy           = "J";
    static constexpr const char *momentum         = "kg m/s";
    static constexpr const char *angular_momentum = "kg m^2/s";
    static constexpr const char *force            = "N";
    static constexpr const char *torque           = "N m";
    static constexpr const char *magnetic_moment  = "A m^2";
  };
} // namespace magmpm
