// Checkpoints: what is written is read again on any number of ranks, the latest is always a whole one,
// and parameters that particles depend on are told from others.

#include <magmpm/base/exceptions.h>
#include <magmpm/simulation/checkpoint.h>
#include <magmpm/simulation/parameter_changes.h>

#include "../test_folder.h"
#include "catch.h"

#include <mpi.h>

#include <numeric>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  using Particles = std::vector<std::vector<double>>; // one column each of three bodies

  /** Of three bodies, the last without any; the particles of rank r are the numbers from 100 r on. */
  Particles
  particles_of_this_rank()
  {
    return {{100. * this_rank(), 100. * this_rank() + 1.}, {-100. * this_rank()}, {}};
  }

  void
  write(const CheckpointFolder &checkpoints, const std::string &name, const char label)
  {
    Checkpoint checkpoint;
    checkpoint.version        = "magmpm test";
    checkpoint.parameters     = "set Dimension = 2\n";
    checkpoint.sections       = {{{"run", 1}, std::string("run") + label}};
    const Particles particles = particles_of_this_rank();
    std::vector<ColumnsToWrite> columns;
    for (const std::vector<double> &body : particles)
      columns.push_back({{body.data(), body.size() * sizeof(double)}});
    checkpoints.write(name, checkpoint, columns);
  }

  Particles
  read_particles(const CheckpointFolder &checkpoints)
  {
    Particles particles(3);
    checkpoints.read_particles(
      checkpoints.read(), [&](const std::size_t body, const std::size_t n) {
        std::vector<double> &all = particles.at(body);
        all.resize(all.size() + n);
        return std::vector<Bytes>{{all.data() + all.size() - n, n * sizeof(double)}};
      });
    return particles;
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
  write(checkpoints, "step-1", '1');

  const Checkpoint read = checkpoints.read();
  CHECK(read.version == "magmpm test");
  CHECK(read.parameters == "set Dimension = 2\n");
  CHECK(section_named("run", read.sections) == "run1");
  const Particles particles = read_particles(checkpoints);
  CHECK(particles == particles_of_this_rank());

  const Particles all = read_particles(CheckpointFolder(MPI_COMM_SELF, folder, 2));
  REQUIRE(all.size() == 3);
  CHECK(all[0].size() == 2 * static_cast<std::size_t>(n_ranks()));
  CHECK(std::accumulate(all[1].begin(), all[1].end(), 0.) == sum_over_ranks(particles[1]));

  MPI_Comm half;
  MPI_Comm_split(MPI_COMM_WORLD, this_rank() / 2, this_rank(), &half);
  double sum = 0.;
  for (const auto &body : read_particles(CheckpointFolder(half, folder, 2)))
    sum += std::accumulate(body.begin(), body.end(), 0.);
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, half);
  CHECK(sum == sum_over_ranks(particles[0]) + sum_over_ranks(particles[1]));
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
  const auto latest_run = [&]() {
    return section_named("run", checkpoints.read().sections).back();
  };
  for (const char step : {'1', '2', '3'})
    write(checkpoints, std::string("step-") + step, step);
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
  write(checkpoints, "step-4", '4');
  CHECK(latest_run() == '4');
  write(checkpoints, "step-4", '5');
  CHECK(latest_run() == '4');
  checkpoints.clear();
  CHECK_THROWS_AS(checkpoints.read(), InputError);
}

TEST_CASE("A checkpoint that cannot be written leaves the one before", "[simulation][mpi]")
{
  // A folder stands where the file should be that names the next one: all ranks learn of it.
  const std::string folder = fresh_folder("checkpoint-full");
  const CheckpointFolder checkpoints(MPI_COMM_WORLD, folder, 2);
  write(checkpoints, "step-1", '1');
  if (this_rank() == 0)
    std::filesystem::create_directories(folder + "/checkpoint/latest.unfinished");
  MPI_Barrier(MPI_COMM_WORLD);
  CHECK_THROWS_WITH(write(checkpoints, "step-2", '2'),
                    Catch::Matchers::Contains("was not written") &&
                      Catch::Matchers::Contains("is the disk full?"));
  CHECK(section_named("run", checkpoints.read().sections).back() == '1');
}

TEST_CASE("A checkpoint of another version is refused by name", "[simulation]")
{
  // The number of the format stands in the head of every file, that of a section in its title: each is
  // compared before what follows it is read.
  const std::string folder = fresh_folder("checkpoint-version");
  const CheckpointFolder checkpoints(MPI_COMM_SELF, folder, 2);
  write(checkpoints, "step-1", '1');
  std::fstream file(folder + "/checkpoint/step-1/run.bin",
                    std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(std::string("magmpm checkpoint ").size());
  file << '1' << std::flush;
  CHECK_THROWS_WITH(checkpoints.read(),
                    Catch::Matchers::Contains("has version 1 of the format of checkpoints, this "
                                              "magmpm reads version 2"));

  const std::vector<SectionTitle> mine = {{"scene", 1}, {"magnetics", 2}};
  CHECK_NOTHROW(check_titles({{"magnetics", 2}, {"scene", 1}}, mine));
  CHECK_THROWS_WITH(check_titles({{"scene", 1}, {"magnetics", 1}}, mine),
                    Catch::Matchers::Contains(
                      "section 'magnetics' of the checkpoint has version 1, "
                      "this magmpm reads version 2"));
  CHECK_THROWS_WITH(check_titles({{"scene", 1}}, mine),
                    Catch::Matchers::Contains("has no section 'magnetics'"));
  CHECK_THROWS_WITH(check_titles({{"scene", 1}, {"magnetics", 2}, {"tension", 1}}, mine),
                    Catch::Matchers::Contains("'tension' that this magmpm does not know"));
}

TEST_CASE("A damaged checkpoint is noticed", "[simulation]")
{
  // One bit is flipped in each byte of a file of particles in turn, numbers of particles included, which
  // must not be believed: whatever it hits is refused.
  const std::string folder = fresh_folder("checkpoint-damaged");
  const CheckpointFolder checkpoints(MPI_COMM_SELF, folder, 2);
  write(checkpoints, "step-1", '1');
  const std::string path = folder + "/checkpoint/step-1/particles-00000.bin";
  const auto size        = static_cast<long>(std::filesystem::file_size(path));
  for (long place = 0; place < size; ++place)
    {
      std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
      const auto flip = [&]() {
        file.seekg(place);
        const char byte = static_cast<char>(file.get() ^ 0x40);
        file.seekp(place);
        file.put(byte).flush();
      };
      // What fills up the head means nothing.
      const bool is_padding = (place >= 20 && place < 32) || (place >= 44 && place < 48);
      flip();
      CAPTURE(place);
      if (!is_padding)
        CHECK_THROWS_AS(read_particles(checkpoints), RunError);
      flip();
    }
  CHECK(read_particles(checkpoints) == particles_of_this_rank());
}

// A density is in the masses of particles and a material in their law; when a run ends is in
// neither.
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
