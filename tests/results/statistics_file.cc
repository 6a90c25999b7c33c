// The statistics file: a table by name, exact to the last bit, that refuses to be filled wrongly.

#include <magmpm/base/exceptions.h>
#include <magmpm/results/statistics_file.h>

#include "../test_folder.h"
#include "catch.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

using namespace magmpm;

namespace
{
  std::vector<std::string>
  lines_of(const std::string &path)
  {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
      lines.push_back(line);
    return lines;
  }
} // namespace

TEST_CASE("statistics are set by name and written in the order of the columns", "[results][mpi]")
{
  // Values go in in any order and by all ranks; rank 0 writes them under their headings. The lines
  // are those that RFC 4180 asks for, with the body's comma in quotes.
  const std::string path = testing::fresh_folder("statistics_file") + "/statistics.csv";
  {
    StatisticsFile statistics(
      MPI_COMM_WORLD,
      path,
      {{"step", ""}, {"time", "s"}, {"limit of dt", ""}, {"a, b x", "N"}, {"a, b y", "N"}});
    statistics.set("limit of dt", "elastic");
    statistics.set("a, b", Vector<2>{{-1., 2.5}});
    statistics.set("time", 0.25);
    statistics.set("step", 7);
    statistics.write_row();
    statistics.flush();
  }
  if (testing::this_rank() == 0)
    CHECK(lines_of(path) ==
          std::vector<std::string>{"step,time [s],limit of dt,\"a, b x [N]\",\"a, b y [N]\"",
                                   "7,0.25,elastic,-1,2.5"});
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_CASE("a number in the statistics is read back to the last bit", "[results]")
{
  // 17 digits tell all doubles apart, so what std::stod reads is the number that was set, for the
  // smallest and largest ones and for 0.1 + 0.2, which 16 digits would not tell from 0.3.
  const std::string path = testing::fresh_folder("statistics_file-digits") + "/statistics.csv";
  for (const double value : {0.1 + 0.2,
                             1. / 3.,
                             -7.55e23,
                             std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::max(),
                             std::nextafter(1., 2.)})
    {
      StatisticsFile statistics(MPI_COMM_SELF, path, {{"x", "-"}});
      statistics.set("x", value);
      statistics.write_row();
      statistics.flush();
      CHECK(std::stod(lines_of(path).at(1)) == value);
    }
}

TEST_CASE("wrong names and forgotten values in the statistics are errors", "[results]")
{
  // These are mistakes in the program, in any build: a column that does not exist, two columns of
  // one name, a value that is missing in a row although an earlier row had it.
  const std::string path = testing::fresh_folder("statistics_file-errors") + "/statistics.csv";
  StatisticsFile statistics(MPI_COMM_SELF, path, {{"x", "-"}, {"text", ""}});

  CHECK_THROWS_WITH(statistics.set("y", 1.), "The statistics have no column 'y'.");
  CHECK_THROWS_AS(StatisticsFile(MPI_COMM_SELF, path, {{"x", "-"}, {"x", "m"}}), std::logic_error);

  statistics.set("x", 1.);
  statistics.set("text", "");
  CHECK_NOTHROW(statistics.write_row());
  statistics.set("text", "");
  CHECK_THROWS_WITH(statistics.write_row(), "A row of statistics lacks the value of 'x'.");
}

TEST_CASE("a statistics file that cannot be opened says which and why", "[results]")
{
  // The folder does not exist: the message must name the file and what to look at.
  CHECK_THROWS_WITH(StatisticsFile(MPI_COMM_SELF, "no-such-folder/statistics.csv", {{"x", "-"}}),
                    "The statistics file 'no-such-folder/statistics.csv' cannot be opened for "
                    "writing. Is there such a folder, and are you allowed to write there?");
  CHECK_THROWS_AS(StatisticsFile(MPI_COMM_SELF, "no-such-folder/statistics.csv", {{"x", "-"}}),
                  RunError);
}
