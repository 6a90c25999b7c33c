// The statistics file: a table by name, exact to the last bit, that refuses to be filled wrongly.

#include <magmpm/base/exceptions.h>
#include <magmpm/results/rigid_body_columns.h>
#include <magmpm/results/statistics_columns.h>
#include <magmpm/results/statistics_file.h>

#include "catch.h"
#include "../test_folder.h"

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

  std::vector<std::string>
  names_of(const std::vector<StatisticsColumn> &columns)
  {
    std::vector<std::string> names;
    for (const StatisticsColumn &column : columns)
      names.push_back(column.name);
    return names;
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

TEST_CASE("the columns of a scene have units of its dimension", "[results]")
{
  // Two bodies in 3D: 33 columns of the scene, 6 a body, one a phase. In 2D momenta and energies
  // are per metre of depth, and there is one angular momentum.
  const auto columns_3d = statistics_columns<3>({"cube", "drop"}, {"P2G", "G2P"});
  const auto columns_2d = statistics_columns<2>({"cube", "drop"}, {"P2G", "G2P"});
  CHECK(columns_3d.size() == 15 + 3 * 3 + 6 + 2 * 6 + 9 + 2);
  CHECK(columns_2d.size() == 15 + 2 + 1 + 2 + 6 + 2 * 4 + 9 + 2);

  std::string headings;
  for (const StatisticsColumn &column : columns_2d)
    headings += column.heading() + '\n';
  for (const std::string heading : {"\nkinetic energy [J/m]\n",
                                    "\nmomentum y [kg/s]\n",
                                    "\nangular momentum z [kg m/s]\n",
                                    "\ndrop: magnetic force y [N/m]\n",
                                    "\ncube: magnetic moment x [A m]\n",
                                    "\nwall time: G2P [s]\n"})
    CHECK(headings.find(heading) != std::string::npos);
  CHECK(headings.find("momentum z [kg/s]") == std::string::npos);

  // No name twice, which StatisticsFile would refuse.
  CHECK_NOTHROW(StatisticsFile(MPI_COMM_SELF,
                               testing::fresh_folder("statistics_file-columns") + "/statistics.csv",
                               columns_3d));
}

TEST_CASE("doc/statistics.md explains every column", "[results]")
{
  // The manual names each column of a scene in code quotes, with the vector's name for its
  // components: a column added without a word in the manual fails here. A bar within a table of
  // the manual has a backslash before it.
  std::ifstream file(MAGMPM_SOURCE_DIR "/doc/statistics.md");
  REQUIRE(file);
  std::string manual(std::istreambuf_iterator<char>(file), {});
  manual.erase(std::remove(manual.begin(), manual.end(), '\\'), manual.end());

  Parameters<3> parameters;
  parameters.sources.resize(1);
  parameters.sources[0].name = "MAGNET";
  parameters.sources[0].type = SourceType::magnetized_sphere;
  parameters.rigid_bodies.resize(1);
  parameters.rigid_bodies[0].name = "RIGID";
  for (std::string name :
       names_of(statistics_columns<3>({"BODY"}, {"PHASE"}, rigid_body_columns(parameters))))
    {
      const bool is_component = name.size() > 2 && name[name.size() - 2] == ' ' &&
                                std::string("xyz").find(name.back()) != std::string::npos;
      if (is_component)
        name.resize(name.size() - 2);
      CAPTURE(name);
      CHECK(manual.find("`" + name + "`") != std::string::npos);
    }
}
