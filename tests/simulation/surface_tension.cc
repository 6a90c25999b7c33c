// Surface tension in whole scenes: drops at rest, on walls, beside solids; ranks and restart.

#include <magmpm/simulation/scene.h>

#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_file.h>
#include <magmpm/particles/particle_quantities.h>

#include "../catch.h"

#include <string>

using namespace magmpm;

namespace
{
  /** A drop of radius 8 cells of one metre, rho = gamma = 1, whose sound is 20 times sqrt(gamma/(rho R)). */
  std::string
  drop_text(const std::string &changes = "")
  {
    return R"(
set Dimension = 2
set End time  = 1000
set Gravity   = 0, 0
subsection Box
  set Upper corner = 32, 32
  set Cell size    = 1
end
subsection Bodies
  set List of bodies = drop
  subsection drop
    set Material = liquid
    set Shape    = sphere
    set Centre   = 16.13, 15.72
    set Radius   = 8
    set Density  = 1
  end
end
subsection Materials
  set List of materials = liquid
  subsection liquid
    set Mechanical law  = viscoelastic fluid
    set Bulk modulus    = 50
    set Viscosity       = 0.3651
    set Surface tension = 1
  end
end
)" + changes;
  }

  Parameters<2>
  scene_of(const std::string &text)
  {
    return read_parameters<2>(parse_parameter_text(text, "scene.prm"));
  }

  /** Runs to a time with sums at the end. */
  void
  run_to(Scene<2> &scene, const double time)
  {
    while (scene.time() < time)
      scene.step({time, true, {}});
  }

  double
  column(const Scene<2> &scene, const std::string &name)
  {
    const ColumnTable table = scene.columns();
    for (const Column &column : table.all())
      if (column.name == name)
        return column.number();
    throw RunError("there is no column " + name);
  }

  /** Two scenes after the same: momenta, energies, places. */
  void
  check_same(const Scene<2> &one, const Scene<2> &other)
  {
    const ParticleSums<2> a = one.total(), b = other.total();
    CHECK(a.kinetic_energy == Approx(b.kinetic_energy).epsilon(1e-9));
    CHECK(column(one, "surface energy") == Approx(column(other, "surface energy")).epsilon(1e-11));
    for (int d = 0; d < 2; ++d)
      CHECK(a.mass_times_position[d] == Approx(b.mass_times_position[d]).epsilon(1e-12));
  }

  const std::string walls =
    "subsection Walls\nset Lower y = slip\nset Lower y contact angle = 60\n"
    "set Lower x = stick\nset Upper x = open\nset Upper y = separate\nend\n";
} // namespace

// In a drop at rest the pressure is gamma/R, after Young and Laplace: K (1 - J) to 3 %. Its momentum stays
// nothing, since the forces of its surface have no sum, and it is as quiet as 0.5 % of sqrt(gamma/(rho R))
// at the Laplace number 120.
TEST_CASE("A drop at rest has the pressure of its surface", "[simulation]")
{
  Scene<2> scene(scene_of(drop_text()), MPI_COMM_WORLD);
  scene.begin();
  run_to(scene, 90.); // four times R/U
  const Body<2> &drop         = scene.bodies()[0];
  const ParticleSums<2> total = scene.total();
  const Vector<2> centre      = (1. / total.mass) * total.mass_times_position;
  double pressure = 0., n_inside = 0.;
  for (std::size_t p = 0; p < drop.particles.size(); ++p)
    if (norm(drop.particles.position(p) - centre) < 4.)
      {
        pressure += 50. * (1. - particle_volume_ratio(drop, p));
        ++n_inside;
      }
  CHECK(n_inside > 100.);
  CHECK(pressure / n_inside == Approx(1. / 8.).epsilon(0.03));
  const double unit_speed = std::sqrt(1. / 8.);
  CHECK(norm(total.momentum) < 1e-12 * total.mass * unit_speed);
  CHECK(std::sqrt(2. * total.kinetic_energy / total.mass) < 0.005 * unit_speed);
  CHECK(column(scene, "surface energy") == Approx(2. * 3.14159265 * 8.).epsilon(0.015));
  CHECK(column(scene, "dropped surface force") == 0.);
}

// Without tension nothing of it is done, and the limit of dt is another one: a drop stays as it is.
TEST_CASE("Capillary waves limit the time step", "[simulation]")
{
  Parameters<2> parameters            = scene_of(drop_text());
  parameters.time_step.elastic_factor = 10.;
  parameters.time_step.viscous_factor = 10.;
  Scene<2> scene(parameters, MPI_COMM_WORLD);
  scene.begin();
  scene.step();
  scene.step();
  // sqrt(rho dx^3/gamma) is one second here.
  CHECK(scene.progress().limit == "capillary");
  CHECK(scene.progress().clock.time_step == Approx(0.1));
}

// A drop on walls of all conditions beside an elastic block, in which the tension ends: the ranks
// together do what one does alone, and a scene that goes on from a checkpoint what one does in one go.
TEST_CASE("Surface tension is the same on any number of ranks and after a restart",
          "[simulation][mpi]")
{
  std::string text = drop_text(walls);
  text.replace(text.find("List of bodies = drop"), 21, "List of bodies = drop, block");
  text.replace(text.find("  subsection drop"), 0, R"(
  subsection block
    set Material     = rubber
    set Lower corner = 21.3, 0
    set Upper corner = 26.1, 6.2
    set Density      = 1.3
  end
)");
  text.replace(text.find("Centre   = 16.13, 15.72"), 23, "Centre   = 13.1, 8.2");
  text.replace(text.find("List of materials = liquid"), 26, "List of materials = liquid, rubber");
  text.replace(
    text.find("  subsection liquid"),
    0,
    "  subsection rubber\n    set Young's modulus = 60\n    set Poisson ratio = 0.2\n  end\n");

  Scene<2> one(scene_of(text), MPI_COMM_SELF), all(scene_of(text), MPI_COMM_WORLD);
  for (Scene<2> *scene : {&one, &all})
    {
      scene->begin();
      run_to(*scene, 4.);
    }
  CHECK(column(one, "surface energy") > 30.);
  check_same(one, all);

  const std::vector<Section> sections = all.save();
  Scene<2> resumed(scene_of(text), MPI_COMM_WORLD);
  resumed.load(sections, [&](std::vector<Body<2>> &bodies) { bodies = all.bodies(); });
  CHECK(column(resumed, "surface energy") == column(all, "surface energy"));
  run_to(all, 6.);
  run_to(resumed, 6.);
  check_same(all, resumed);
}

// What the common surface of two fluids does is not known, so that one of another tension is refused where
// it touches, by the numbers that a user gave; apart they go on.
TEST_CASE("Fluids of different surface tension may not touch", "[simulation][mpi]")
{
  std::string text = drop_text();
  text.replace(text.find("List of bodies = drop"), 21, "List of bodies = drop, other");
  text.replace(text.find("  subsection drop"), 0, R"(
  subsection other
    set Material     = oil
    set Lower corner = 2, 2
    set Upper corner = 6, 6
    set Density      = 0.9
    set Velocity     = 4, 4
  end
)");
  text.replace(text.find("List of materials = liquid"), 26, "List of materials = liquid, oil");
  text.replace(text.find("  subsection liquid"), 0, R"(
  subsection oil
    set Mechanical law  = viscoelastic fluid
    set Bulk modulus    = 50
    set Viscosity       = 0.1
    set Surface tension = 0.5
  end
)");
  Scene<2> scene(scene_of(text), MPI_COMM_WORLD);
  scene.begin();
  for (int step = 0; step < 5; ++step)
    scene.step();
  CHECK_THROWS_WITH(
    run_to(scene, 3.),
    Catch::Contains("Fluids of different surface tension touch ('drop' 1 N/m, 'other' 0.5 N/m)"));
}
