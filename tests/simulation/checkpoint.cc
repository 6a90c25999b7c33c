// Checkpoints: what is written is read again on any number of ranks, the latest is always a whole one,
// and parameters that particles depend on are told from others.

#include <magmpm/base/exceptions.h>
#include <magmpm/simulation/checkpoint.h>
#include <magmpm/simulation/parameter_changes.h>

#include "catch.h"
#include "../test_folder.h"

#include <mpi.h>

#include <numeric>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  /** Two bodies; the particles of rank r are the numbers from 100 r on. */
  Checkpoint
  checkpoint_of_this_rank(const char label)
  {
    Checkpoint checkpoint;
    checkpoint.version    = "magmpm test";
    checkpoint.parameters = "set Dimension = 2\n";
    checkpoint.run        = {'r', 'u', 'n', label};
    checkpoint.particles  = {{100. * this_rank(), 100. * this_rank() + 1.}, {-100. * this_rank()}};
    return checkpoint;
  }

  double
  sum_over_ranks(const std::vector<double> &values)
  {
    double sum = std::accumulate(values.begin(), values.end(), 0.);
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum;
  }
} // namespace

TEST_CASE("A checkpoint is read as it was written", "[simulation][mpi]")
{
  // On the same ranks each gets back what it wrote, in its order; read by one process alone, or by a
  // group of another size, no number is lost: their sum stays.
  const std::string folder = fresh_folder("checkpoint");
  const CheckpointFolder checkpoints(MPI_COMM_WORLD, folder, 2);
  CHECK_THROWS_AS(checkpoints.read(), InputError);
  checkpoints.write("step-1", checkpoint_of_this_rank('1'));

  const Checkpoint read = checkpoints.read();
  CHECK(read.version == "magmpm test");
  CHECK(read.parameters == "set Dimension = 2\n");
  CHECK(read.run == std::vector<char>{'r', 'u', 'n', '1'});
  CHECK(read.particles == checkpoint_of_this_rank('1').particles);

  const Checkpoint all = CheckpointFolder(MPI_COMM_SELF, folder, 2).read();
  REQUIRE(all.particles.size() == 2);
  CHECK(all.particles[0].size() == 2 * static_cast<std::size_t>(n_ranks()));
  CHECK(std::accumulate(all.particles[1].begin(), all.particles[1].end(), 0.) ==
        sum_over_ranks(read.particles[1]));

  MPI_Comm half;
  MPI_Comm_split(MPI_COMM_WORLD, this_rank() / 2, this_rank(), &half);
  const Checkpoint shared = CheckpointFolder(half, folder, 2).read();
  double sum              = 0.;
  for (const auto &body : shared.particles)
    sum += std::accumulate(body.begin(), body.end(), 0.);
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, half);
  CHECK(sum == sum_over_ranks(read.particles[0]) + sum_over_ranks(read.particles[1]));
  MPI_Comm_free(&half);
}

TEST_CASE("The latest checkpoint is a whole one", "[simulation][mpi]")
{
  // Two are kept; what a killed run left of a third, which no one named, is not read and is replaced;
  // the one that is named is never written over.
  const std::string folder = fresh_folder("checkpoint-latest");
  const CheckpointFolder checkpoints(MPI_COMM_WORLD, folder, 2);
  const auto exists = [&](const std::string &name) {
    return std::filesystem::exists(folder + "/checkpoint/" + name + "/run.bin");
  };
  const auto latest_run = [&]() { return checkpoints.read().run.back(); };
  for (const char step : {'1', '2', '3'})
    checkpoints.write(std::string("step-") + step, checkpoint_of_this_rank(step));
  MPI_Barrier(MPI_COMM_WORLD);
  CHECK(!exists("step-1"));
  CHECK(exists("step-2"));
  CHECK(latest_run() == '3');

  if (this_rank() == 0)
    {
      std::filesystem::create_directories(folder + "/checkpoint/step-4");
      std::ofstream(folder + "/checkpoint/step-4/run.bin") << "half of";
    }
  MPI_Barrier(MPI_COMM_WORLD);
  CHECK(latest_run() == '3');
  checkpoints.write("step-4", checkpoint_of_this_rank('4'));
  CHECK(latest_run() == '4');
  checkpoints.write("step-4", checkpoint_of_this_rank('5'));
  CHECK(latest_run() == '4');
  checkpoints.clear();
  CHECK_THROWS_AS(checkpoints.read(), InputError);
}

TEST_CASE("A checkpoint that cannot be written leaves the one before", "[simulation][mpi]")
{
  // A folder stands where the file should be that names the next one: all ranks learn of it.
  const std::string folder = fresh_folder("checkpoint-full");
  const CheckpointFolder checkpoints(MPI_COMM_WORLD, folder, 2);
  checkpoints.write("step-1", checkpoint_of_this_rank('1'));
  if (this_rank() == 0)
    std::filesystem::create_directories(folder + "/checkpoint/latest.unfinished");
  MPI_Barrier(MPI_COMM_WORLD);
  CHECK_THROWS_WITH(checkpoints.write("step-2", checkpoint_of_this_rank('2')),
                    Catch::Matchers::Contains("was not written") &&
                      Catch::Matchers::Contains("is the disk full?"));
  CHECK(checkpoints.read().run.back() == '1');
}

TEST_CASE("Parameters that particles depend on are told from others", "[simulation]")
{
  const std::string then = R"(set Dimension = 2
set End time = 1
subsection Box
  set Cell size = 0.1
end
subsection Bodies
  subsection cube
    set Density = 1000
  end
end)";
  std::string now        = then;
  CHECK(parameter_changes(now, then).critical.empty());
  CHECK(parameter_changes(now, then).allowed.empty());

  now.replace(now.find("1000"), 4, "900");
  now.replace(now.find("time = 1"), 8, "time = 2");
  now += "\nsubsection Materials\n  set List of materials = clay\nend";
  const ParameterChanges changes = parameter_changes(now, then);
  CHECK(changes.critical ==
        std::vector<std::string>{"Bodies/cube/Density = 900, was 1000",
                                 "Materials/List of materials = clay, was (not there)"});
  CHECK(changes.allowed == std::vector<std::string>{"End time = 2, was 1"});
}
