// Bodies whose shape or particles come from a file, and the surfaces that a run writes of them.

#include "catch.h"
#include "program/equal_runs.h"

#include <vtkMassProperties.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <verification/program/particle_frame.h>
#include <verification/program/paths.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  /** One elastic body in a box; @p shape in the lines of its section. */
  std::string
  scene_of(const std::string &name,
           const std::string &head,
           const std::string &box,
           const std::string &shape,
           const std::string &output = "")
  {
    return write_scene(
      name,
      head + "\nset End time = 0.004\nsubsection Box\n" + box +
        "\nend\nsubsection Bodies\nset List of bodies = body\nsubsection body\n"
        "set Material = clay\nset Density = 1000\n" +
        shape +
        "\nend\nend\nsubsection Materials\nset List of materials = clay\nsubsection "
        "clay\nset Young's modulus = 1e5\nset Poisson ratio = 0.3\nend\nend\n"
        "subsection Output\nset Frame interval = 0.002\n" +
        output + "\nend\n");
  }

  std::string
  dragon_scene(const std::string &name, const std::string &file, const std::string &output = "")
  {
    return scene_of(name,
                    "set Gravity = 0, 0, -9.81",
                    "set Upper corner = 0.5, 0.5, 0.25\nset Cell size = 0.0078125",
                    "set Shape = mesh\nset File = " + file +
                      "\nset Scale = 1.5\nset Rotation = 0, 0, 1.5707963\n"
                      "set Translation = 0.25, 0.25, 0.02",
                    output);
  }

  std::size_t
  n_particles(const std::string &name)
  {
    return static_cast<std::size_t>(Statistics("output-" + name)["particles"].front());
  }

  vtkSmartPointer<vtkPolyData>
  surface(const std::string &folder, const std::string &frame)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder + "/surface/surface_" + frame + ".vtp").c_str());
    reader->Update();
    return reader->GetOutput();
  }
} // namespace

// The dragon of meshes/, named relative to the folder of the parameter file, half as large again
// and turned by 90 degrees about z: particles with its volume, 364.8 cm^3 times 1.5^3, as the log says of
// them and of the shape alike; along y, where it now looks, from end to end; the same particles on 2
// ranks, and the same surface of them. That encloses less than they fill, since limbs and wings are
// 1 to 3 dx thick (doc/algorithm.md), but not less than 4/5.
TEST_CASE("A body from a mesh, on 1 and 2 ranks", "[program]")
{
  std::filesystem::create_directories("scene-folder");
  std::filesystem::copy_file(source_folder() + "/meshes/dragon.obj",
                             "scene-folder/dragon.obj",
                             std::filesystem::copy_options::overwrite_existing);
  const std::string surfaces = "set Surface = true";
  const Outcome one = run_magmpm(dragon_scene("scene-folder/dragon", "dragon.obj", surfaces) +
                                 " --set \"Output directory=output-dragon-1\"");
  REQUIRE(one.errors == "");
  REQUIRE(one.exit_code == 0);
  const Outcome two =
    run_magmpm("scene-folder/dragon.prm --set \"Output directory=output-dragon-2\"", 2);
  REQUIRE(two.exit_code == 0);

  const double volume = 3.375 * 364.8e-6;
  const auto told     = [&](const std::string &start) {
    const std::size_t at = one.output.find(start);
    REQUIRE(at != std::string::npos);
    return std::stod(one.output.substr(at + start.size()));
  };
  CHECK(told("body, seeded") == Approx(volume).epsilon(3e-4));
  CHECK(told("body, seeded") == told("body, its shape"));
  CHECK(one.output.find("body: " + std::to_string(n_particles("dragon-1") / 1000) + ",") !=
        std::string::npos);

  auto first  = particle_positions("output-dragon-1"),
       second = particle_positions("output-dragon-2");
  REQUIRE(first.size() == 3);
  REQUIRE(second.size() == 3);
  std::sort(first[0].begin(), first[0].end());
  std::sort(second[0].begin(), second[0].end());
  CHECK(first[0] == second[0]);
  double lower = 1., upper = 0.;
  for (const auto &x : first[0])
    {
      lower = std::min(lower, x[1]);
      upper = std::max(upper, x[1]);
    }
  CHECK(lower == Approx(0.25 - 1.5 * 0.141).margin(0.006));
  CHECK(upper == Approx(0.25 + 1.5 * 0.113).margin(0.006));

  double enclosed[2], area[2];
  for (const int n : {1, 2})
    {
      vtkNew<vtkMassProperties> mass;
      mass->SetInputData(surface("output-dragon-" + std::to_string(n), "0002"));
      enclosed[n - 1] = mass->GetVolume();
      area[n - 1]     = mass->GetSurfaceArea();
    }
  CHECK(enclosed[0] < volume);
  CHECK(enclosed[0] > 0.8 * volume);
  CHECK(enclosed[1] == Approx(enclosed[0]).epsilon(1e-6));
  CHECK(area[1] == Approx(area[0]).epsilon(1e-5));
  CHECK(one.output.find("surface.pvd") != std::string::npos);
}

// What a user sees who mistypes the file of a mesh, or gives one that is open: a cube of which a
// triangle is missing. Both places are named where the file was looked for.
TEST_CASE("Messages on the files of bodies", "[program]")
{
  std::filesystem::create_directories("scene-folder");
  dragon_scene("scene-folder/wrong", "wurm.obj");
  const Outcome none = run_magmpm("--validate scene-folder/wrong.prm");
  CHECK(none.exit_code == 2);
  CHECK(
    none.errors.find("scene-folder/wrong.prm, line 13: Bodies/body/File = wurm.obj: there is no "
                     "such file, neither scene-folder/wurm.obj (beside the parameter file) nor " +
                     std::filesystem::current_path().string() +
                     "/wurm.obj (in the working directory). Correct the name, or put the file in "
                     "one of these places.") != std::string::npos);

  std::ofstream("scene-folder/open.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                            "f 1 3 2\nf 1 2 4\nf 1 4 3\n";
  dragon_scene("scene-folder/wrong", "open.obj");
  const Outcome open = run_magmpm("--validate scene-folder/wrong.prm");
  CHECK(open.exit_code == 2);
  CHECK(
    open.errors.find("line 13: Bodies/body/File: scene-folder/open.obj: the mesh is not closed. Of "
                     "its 3 triangles, 3 edges belong to one triangle only") != std::string::npos);
}

// A ring of points in 2D with a heading and areas: as many particles, with their areas, where the
// file has them, in its place after Translation; kinetic energy of mass rho A at 1 m/s. Without
// areas each has the one of a particle, (dx/2)^2. A point outside is named by its line.
TEST_CASE("A body from a list of points, on 1 and 2 ranks", "[program]")
{
  const int n = 500;
  std::ofstream file("ring.csv"), bare("bare.csv");
  file << "x [m], y [m], area [m^2]\n";
  for (int i = 0; i < n; ++i)
    {
      const double angle = 2. * pi * i / n;
      file << 0.1 * std::cos(angle) << ", " << 0.1 * std::sin(angle) << ", 1e-5\n";
      bare << 0.1 * std::cos(angle) << ',' << 0.1 * std::sin(angle) << '\n';
    }
  file.close();
  bare.close();
  const auto ring = [](const std::string &name, const std::string &list) {
    return scene_of(name,
                    "set Dimension = 2\nset Gravity = 0, 0",
                    "set Upper corner = 0.32, 0.32\nset Cell size = 0.01",
                    "set Shape = points\nset File = " + list +
                      "\nset Translation = 0.15, 0.16\nset Velocity = 1, 0");
  };
  REQUIRE(run_magmpm(ring("ring", "ring.csv")).exit_code == 0);
  REQUIRE(run_magmpm("ring.prm --set \"Output directory=output-ring-2\"", 2).exit_code == 0);
  const Statistics one("output-ring"), two("output-ring-2");
  CHECK(one["particles"].front() == n);
  CHECK(one["kinetic energy [J/m]"].front() == Approx(0.5 * 1000. * n * 1e-5));
  CHECK(one["centre of mass y [m]"].front() == Approx(0.16));
  check_equal_runs(one, two, 1e-9, depends_on_ranks);
  auto first = particle_positions("output-ring")[0];
  REQUIRE(first.size() == std::size_t(n));
  for (const auto &x : first)
    CHECK(std::hypot(x[0] - 0.15, x[1] - 0.16) == Approx(0.1).epsilon(1e-4));

  REQUIRE(run_magmpm(ring("bare", "bare.csv")).exit_code == 0);
  CHECK(Statistics("output-bare")["kinetic energy [J/m]"].front() ==
        Approx(0.5 * 1000. * n * 0.005 * 0.005));

  std::ofstream("ring.csv", std::ios::app) << "5, 5, 1e-5\n";
  const Outcome outside = run_magmpm("--validate ring.prm");
  CHECK(outside.exit_code == 2);
  CHECK(
    outside.errors.find("Bodies/body/File = ring.csv: the point of line 502, at 5.15, 5.16 m in "
                        "the scene, is not inside the box. Move the points with Scale, Rotation or "
                        "Translation, or enlarge the box.") != std::string::npos);
}
