#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/ranks.h>
#include <magmpm/parallel/together.h>
#include <magmpm/results/statistics_file.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <stdexcept>

namespace magmpm
{
  namespace
  {
    /** The text as one cell of a table: in quotes where a comma or a quote would break it. */
    std::string
    quoted(const std::string &text)
    {
      if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
      std::string result = "\"";
      for (const char c : text)
        result += (c == '"') ? std::string("\"\"") : std::string(1, c);
      return result + '"';
    }

    /** The cells, separated by commas, as a line. */
    std::string
    joined(const std::vector<std::string> &cells)
    {
      std::string line;
      for (const std::string &cell : cells)
        line += (line.empty() ? "" : ",") + cell;
      return line + '\n';
    }
  } // namespace

  StatisticsFile::StatisticsFile(const MPI_Comm communicator,
                                 const std::string &path,
                                 const std::vector<StatisticsColumn> &table,
                                 const std::uintmax_t size_to_keep)
    : path(path)
    , row(table.size())
  {
    std::vector<std::string> headings;
    for (const StatisticsColumn &column : table)
      {
        if (!columns.emplace(column.name, names.size()).second)
          throw std::logic_error("Two columns of statistics are called '" + column.name + "'.");
        names.push_back(column.name);
        headings.push_back(quoted(column.heading()));
      }

    is_writer = (parallel::rank(communicator) == 0);
    parallel::on_first_rank(communicator, [&]() {
      if (size_to_keep > 0)
        reopen(size_to_keep, joined(headings));
      else
        create(joined(headings));
    });
  }

  void
  StatisticsFile::create(const std::string &headings)
  {
    file.open(path);
    if (!file)
      throw RunError("The statistics file '" + path +
                     "' cannot be opened for writing. Is there such a folder, and are you allowed "
                     "to write there?");
    file << headings;
  }

  void
  StatisticsFile::reopen(const std::uintmax_t size_to_keep, const std::string &headings)
  {
    std::string first_line;
    std::getline(std::ifstream(path), first_line);
    if (first_line + '\n' != headings)
      throw RunError(
        "The statistics file '" + path +
        "' is missing or has other columns than this run: it cannot be continued. Was it "
        "changed, or made by another version?");
    if (std::filesystem::file_size(path) < size_to_keep)
      throw RunError("The statistics file '" + path +
                     "' is shorter than when the checkpoint was written: rows are missing. Was it "
                     "changed?");
    std::filesystem::resize_file(path, size_to_keep);
    file.open(path, std::ios::app);
    if (!file)
      throw RunError("The statistics file '" + path + "' cannot be opened to go on with it.");
  }

  std::string &
  StatisticsFile::cell(const std::string &name)
  {
    const auto column = columns.find(name);
    if (column == columns.end())
      throw std::logic_error("The statistics have no column '" + name + "'.");
    return row[column->second];
  }

  void
  StatisticsFile::set(const std::string &name, const double value)
  {
    // The shortest text that is read back as the same double.
    char text[32];
    const auto end = std::to_chars(std::begin(text), std::end(text), value);
    cell(name).assign(text, end.ptr);
  }

  void
  StatisticsFile::set(const std::string &name, const std::string &text)
  {
    // Quotes also around an empty text, so that it is told from a value that was forgotten.
    cell(name) = text.empty() ? "\"\"" : quoted(text);
  }

  void
  StatisticsFile::write_row()
  {
    const auto missing = std::find(row.begin(), row.end(), "");
    if (missing != row.end())
      throw std::logic_error("A row of statistics lacks the value of '" +
                             names[missing - row.begin()] + "'.");

    // At once, so that no row is missing if another rank ends the program.
    if (is_writer)
      file << joined(row) << std::flush;
    std::fill(row.begin(), row.end(), "");
  }

  void
  StatisticsFile::flush()
  {
    if (is_writer && !file.flush())
      throw RunError("The statistics file '" + path + "' cannot be written. Is the disk full?");
  }

  std::uintmax_t
  StatisticsFile::size()
  {
    flush();
    return is_writer ? std::filesystem::file_size(path) : 0;
  }
} // namespace magmpm
