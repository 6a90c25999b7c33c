// A scene as a library: it steps and is asked without a file being written, its couplings name their
// columns, and what one scene saves another goes on from.

#include <magmpm/simulation/scene.h>

#include <magmpm/parallel/reduce.h>
#include <magmpm/parameters/parameter_file.h>

#include "../catch.h"
#include "../test_folder.h"

#include <verification/program/paths.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace magmpm;
using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  /** The cube above a magnet, 6 cells an edge, in a box of 32 cells. */
  Parameters<3>
  small_cube()
  {
    return read_parameters<3>(read_parameter_file(
      source_folder() + "/parameter_files/cube_nonlinear.prm", {"Box/Cell size=0.03125"}));
  }

  std::vector<std::string>
  names_of(const ColumnTable &table)
  {
    std::vector<std::string> names;
    for (const Column &column : table.all())
      names.push_back(column.name);
    return names;
  }

  double
  value_of(const std::string &name, const ColumnTable &table)
  {
    for (const Column &column : table.all())
      if (column.name == name)
        return column.number();
    FAIL("no column " << name);
    return 0.;
  }
} // namespace

TEST_CASE("A scene steps and tells a magnet's force without writing a file", "[simulation][mpi]")
{
  // The working directory is a fresh folder, which must stay empty. The material pulls the magnet up as
  // much as the magnet pulls the material down, to what is dropped and smoothed: 3 %.
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(fresh_folder("scene-without-files"));
  Scene<3> scene(small_cube(), MPI_COMM_WORLD);
  scene.begin();
  while (scene.time() < 2e-3)
    scene.step({2e-3, true, {}});
  CHECK(scene.time() == Approx(2e-3));
  CHECK(scene.progress().clock.step > 1);

  const double on_magnet   = scene.force_on_magnet("ball").force[2];
  const double on_material = scene.progress().sums[0].magnetic_force[2];
  CHECK(on_magnet > 1.);
  CHECK(on_magnet == Approx(-on_material).epsilon(0.03));
  CHECK_THROWS_WITH(scene.force_on_magnet("bal"), Catch::Matchers::Contains("no magnet 'bal'"));
  CHECK(std::filesystem::is_empty(std::filesystem::current_path()));
  std::filesystem::current_path(before);
}

TEST_CASE("A step ends where its caller wants, and reduces the caller's numbers",
          "[simulation][mpi]")
{
  // The one exchange of a step carries a number of each rank along; the step does not pass `until`.
  Scene<3> scene(small_cube(), MPI_COMM_WORLD);
  scene.begin();
  double rank = parallel::rank(MPI_COMM_WORLD);
  scene.step({1e-6, false, [&](parallel::Reduction &reduction) { reduction.max(rank); }});
  CHECK(rank == parallel::n_ranks(MPI_COMM_WORLD) - 1.);
  CHECK(scene.time() == Approx(1e-6));
}

TEST_CASE("A scene goes on from what another one saved", "[simulation][mpi]")
{
  // Both are in the same state after save(): so they do the same steps, to the last bit.
  Scene<3> scene(small_cube(), MPI_COMM_WORLD), other(small_cube(), MPI_COMM_WORLD);
  scene.begin();
  for (int i = 0; i < 5; ++i)
    scene.step();
  const std::vector<Section> sections = scene.save();
  REQUIRE(sections.size() == other.titles().size());
  other.load(sections, [&](std::vector<Body<3>> &bodies) { bodies = scene.bodies(); });
  for (int i = 0; i < 5; ++i)
    for (Scene<3> *one : {&scene, &other})
      {
        one->step({1., true, {}});
        one->prepare_row();
      }

  const ColumnTable columns = scene.columns(), others = other.columns();
  for (const std::string &name : names_of(columns))
    if (name != "limit of dt")
      {
        CAPTURE(name);
        CHECK(value_of(name, columns) == value_of(name, others));
      }
}

TEST_CASE("the columns of a scene have units of its dimension", "[simulation]")
{
  // One body in 3D and a magnet with a surface: 36 columns of the scene, 6 of the body, 6 of the magnet
  // and 3 of its surface. In 2D momenta and energies are per metre of depth, and there is one angular
  // momentum.
  const Scene<3> cube(small_cube(), MPI_COMM_WORLD);
  CHECK(cube.columns().all().size() == 16 + 3 * 3 + 6 + 6 + 9 + 6 + 3 + 4);
  const Scene<2> drop(
    read_parameters<2>(read_parameter_file(source_folder() + "/parameter_files/drop_2d.prm")),
    MPI_COMM_WORLD);
  const ColumnTable table = drop.columns();
  std::string headings;
  for (const Column &column : table.all())
    headings += column.name + " [" + column.unit + "]\n";
  for (const std::string heading : {"\nkinetic energy [J/m]\n",
                                    "\nmomentum y [kg/s]\n",
                                    "\nangular momentum z [kg m/s]\n",
                                    "\ndrop: magnetic force y [N/m]\n",
                                    "\ndrop: magnetic moment x [A m]\n"})
    CHECK(headings.find(heading) != std::string::npos);
  CHECK(headings.find("momentum z [kg/s]") == std::string::npos);

  // No name twice, by which values are found.
  std::vector<std::string> names = names_of(cube.columns());
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

TEST_CASE("doc/statistics.md explains every column", "[simulation]")
{
  // The manual names each column of a scene in code quotes, with the vector's name for its
  // components: a column added without a word in the manual fails here. A bar within a table of
  // the manual has a backslash before it.
  std::ifstream file(source_folder() + "/doc/statistics.md");
  REQUIRE(file);
  std::string manual(std::istreambuf_iterator<char>(file), {});
  manual.erase(std::remove(manual.begin(), manual.end(), '\\'), manual.end());

  Parameters<3> parameters   = small_cube();
  parameters.bodies[0].name  = "BODY";
  parameters.sources[0].name = "MAGNET";
  parameters.rigid_bodies.resize(1);
  parameters.rigid_bodies[0].name = "RIGID";
  const Scene<3> scene(parameters, MPI_COMM_WORLD);
  std::vector<std::string> names = names_of(scene.columns());
  names.push_back("wall time: PHASE");
  for (std::string name : names)
    {
      const bool is_component = name.size() > 2 && name[name.size() - 2] == ' ' &&
                                std::string("xyz").find(name.back()) != std::string::npos;
      if (is_component)
        name.resize(name.size() - 2);
      CAPTURE(name);
      CHECK(manual.find("`" + name + "`") != std::string::npos);
    }
}
