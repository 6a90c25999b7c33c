// What walls do to the lattice, on any number of ranks.

#include <magmpm/simulation/scene.h>

#include <magmpm/parameters/parameter_file.h>

#include "../catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  /** A bar between a clamp and free air, in a box that is as high as three bars, of 24 x 12 cells. */
  Parameters<2>
  clamped_bar(const std::string &transfer)
  {
    return read_parameters<2>(parse_parameter_text(R"(
set Dimension = 2
set End time  = 1
set Gravity   = 0.5, -1
subsection Box
  set Upper corner = 1.5, 0.75
  set Cell size    = 0.0625
end
subsection Bodies
  set List of bodies = bar
  subsection bar
    set Material     = rubber
    set Lower corner = 0, 0
    set Upper corner = 1, 0.25
    set Density      = 1000
    set Velocity     = 0.2, 0.1
  end
end
subsection Materials
  set List of materials = rubber
  subsection rubber
    set Young's modulus = 1e5
    set Poisson ratio   = 0.3
    set Transfer        = )" + transfer + R"(
  end
end
)",
                                                   "bar.prm"));
  }

  /** Water and a block of rubber fall into the lower left corner, in a box of 24 x 12 cells. */
  Parameters<2>
  splash()
  {
    return read_parameters<2>(parse_parameter_text(R"(
set Dimension = 2
set End time  = 10
set Gravity   = 0, -9.81
subsection Box
  set Upper corner = 1.5, 0.75
  set Cell size    = 0.0625
end
subsection Bodies
  set List of bodies = water, block
  subsection water
    set Material     = water
    set Lower corner = 0, 0
    set Upper corner = 0.5, 0.5
    set Density      = 1000
    set Velocity     = -0.4, -0.2
  end
  subsection block
    set Material     = rubber
    set Lower corner = 0.5, 0
    set Upper corner = 0.75, 0.25
    set Density      = 1000
    set Velocity     = -0.4, -0.2
  end
end
subsection Materials
  set List of materials = water, rubber
  subsection water
    set Mechanical law = viscoelastic fluid
    set Bulk modulus   = 1e5
    set Viscosity      = 0.1
  end
  subsection rubber
    set Young's modulus = 1e5
    set Poisson ratio   = 0.3
  end
end
subsection Walls
  set Lower x = slip
  set Lower y = separate
end
)",
                                                   "splash.prm"));
  }

  ParticleSums<2>
  after_splash(const int n_steps, const MPI_Comm communicator)
  {
    Scene<2> scene(splash(), communicator);
    scene.begin();
    for (int n = 0; n < n_steps; ++n)
      scene.step({10., true, {}});
    return scene.total();
  }

  ParticleSums<2>
  after_steps(const std::string &transfer, const int n_steps, const MPI_Comm communicator)
  {
    Scene<2> scene(clamped_bar(transfer), communicator);
    scene.begin();
    for (int n = 0; n < n_steps; ++n)
      scene.step({1., true, {}});
    return scene.total();
  }
} // namespace

// Water that splashes in the corner of a box of which walls slip and separate, together with a soft block. As
// above: which columns have images is decided alike by all ranks that hold them.
TEST_CASE("Walls that slip and separate are the same on any number of ranks", "[simulation][mpi]")
{
  const ParticleSums<2> alone    = after_splash(150, MPI_COMM_SELF);
  const ParticleSums<2> together = after_splash(150, MPI_COMM_WORLD);
  CHECK(alone.elastic_energy > 1e-3);
  CHECK(together.elastic_energy == Approx(alone.elastic_energy).epsilon(1e-8));
  CHECK(together.kinetic_energy == Approx(alone.kinetic_energy).epsilon(1e-8));
  CHECK(norm(together.momentum - alone.momentum) < 1e-8 * norm(alone.momentum));
}

// A bar that sticks to two walls, in their corner, moves and is deformed. Each rank alone and all together
// do the same steps; only the order of sums differs. The images behind the walls come from blocks that may be
// another rank's.
TEST_CASE("Walls that stick are the same on any number of ranks", "[simulation][mpi]")
{
  for (const std::string transfer : {"FMPM", "APIC"})
    {
      CAPTURE(transfer);
      const ParticleSums<2> alone    = after_steps(transfer, 60, MPI_COMM_SELF);
      const ParticleSums<2> together = after_steps(transfer, 60, MPI_COMM_WORLD);
      CHECK(alone.elastic_energy > 1e-3);
      CHECK(together.elastic_energy == Approx(alone.elastic_energy).epsilon(1e-9));
      CHECK(together.kinetic_energy == Approx(alone.kinetic_energy).epsilon(1e-9));
      CHECK(norm(together.momentum - alone.momentum) < 1e-9 * norm(alone.momentum));
    }
}
