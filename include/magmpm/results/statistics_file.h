#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/coupling/column_table.h>
#include <magmpm/results/run_output.h>

#include <mpi.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <unordered_map>
#include <vector>

namespace magmpm
{
  inline const RunOutput statistics_output = {
    "statistics.csv",
    "a row a step; doc/statistics.md says what the columns mean"};

  /** A column of statistics.csv. */
  struct StatisticsColumn
  {
    std::string name; ///< by which a value is set
    std::string unit; ///< "m/s"; empty for counts and texts

    /** What stands at the head of the column: "name [unit]". */
    std::string
    heading() const
    {
      return unit.empty() ? name : name + " [" + unit + "]";
    }
  };

  /** Name of the column with the seconds of one phase of the algorithm. */
  inline std::string
  phase_column(const std::string &phase)
  {
    return "wall time: " + phase;
  }

  /**
   * A table of comma-separated values with one heading line. Values are set by name, in any order,
   * and written a row at a time with as many digits (up to 17) as it takes to read the same double
   * back: two files can be compared to the last bit. Rank 0 writes; the other ranks may set values
   * too (every rank can run the same code), which go nowhere.
   *
   * A name that the table does not have, and a row with a value missing, is a mistake in the
   * program: both throw std::logic_error, on every rank.
   */
  class StatisticsFile
  {
  public:
    /**
     * Opens the file (an old one is lost) and writes the headings; or goes on with the file of an earlier
     * run. Collective.
     *
     * @param size_to_keep  bytes of the earlier file that count, from size(); what follows is cut off.
     *                      Zero: a new file.
     * @throw RunError on all ranks if the file cannot be opened, or the earlier one is shorter than that
     *                 or has other columns: then it stays as it is.
     */
    StatisticsFile(const MPI_Comm communicator,
                   const std::string &path,
                   const std::vector<StatisticsColumn> &table,
                   const std::uintmax_t size_to_keep = 0);

    void
    set(const std::string &name, const double value);

    void
    set(const std::string &name, const std::string &text);

    /** Sets the columns "name x", "name y", "name z" (2D: x, y; axial in 2D: z alone). */
    template <int n>
    void
    set(const std::string &name, const Vector<n> &vector)
    {
      for (int i = 0; i < n; ++i)
        set(name + ' ' + component_letter(i, n), vector[i]);
    }

    /** Writes the values set since the last row. */
    void
    write_row();

    /**
     * Hands the rows to the operating system, so that they survive whatever happens to the program.
     *
     * @throw RunError on rank 0 if the disk does not take them.
     */
    void
    flush();

    /** Length of the file with all rows so far [bytes]; zero on ranks other than 0. */
    std::uintmax_t
    size();

  private:
    void
    create(const std::string &headings);

    /** Cuts the file behind the rows that count, and opens it to go on. */
    void
    reopen(const std::uintmax_t size_to_keep, const std::string &headings);

    std::string &
    cell(const std::string &name);

    const std::string path;
    std::vector<std::string> names;               ///< of the columns, in their order
    std::unordered_map<std::string, int> columns; ///< by name
    std::vector<std::string> row;                 ///< texts of the present row; empty: not set
    bool is_writer = false;
    std::ofstream file;
  };
} // namespace magmpm
