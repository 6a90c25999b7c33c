// What becomes of the magnetic force between solves of the potential: in flight, at rest, in vibration.

#include <magmpm/simulation/scene.h>

#include <magmpm/parameters/parameter_file.h>

#include "../catch.h"

#include <verification/mechanics/carried_force_errors.h>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** A soft block of 8 x 4 cells in free space or on a floor, with the lines @p block, near a @p magnet. */
  Parameters<2>
  block_scene(const std::string &block, const std::string &magnet, const std::string &rest)
  {
    return read_parameters<2>(parse_parameter_text(R"(
set Dimension = 2
set End time  = 10
set Gravity   = 0, 0
subsection Box
  set Upper corner = 0.48, 0.32
  set Cell size    = 0.01
end
subsection Bodies
  set List of bodies = block
  subsection block
    set Material = elastomer
    set Density  = 1000
)" + block + R"(
  end
end
subsection Materials
  set List of materials = elastomer
  subsection elastomer
    set Young's modulus          = 3e5
    set Poisson ratio            = 0.3
    set Saturation magnetization = 8e4
    set Initial susceptibility   = 0.9
  end
end
subsection Magnets
  set List of magnets = magnet
  subsection magnet
)" + magnet + R"(
  end
end
)" + rest,
                                                   "block.prm"));
  }

  const std::string free_block =
    "set Lower corner = 0.123, 0.147\nset Upper corner = 0.203, 0.187\n";
  const std::string rod = "set Type = magnetized sphere\nset Radius = 0.03\n"
                          "set Magnetization = 0; 1e6\n";

  double
  body_force(const Scene<2> &scene)
  {
    return scene.progress().sums[0].magnetic_force[1];
  }
} // namespace

TEST_CASE("The carried force keeps up with a body in flight", "[simulation][mpi]")
{
  // Every fifth step is taken by a second scene too, from the same state and with a solve of its own: it gives
  // what the carried force should be. The bar turns and flies over 10 dx past a magnet; 1 %.
  const CarriedForceErrors errors = carried_force_errors(
    block_scene(free_block + "set Velocity = 4, 0\nset Angular velocity = 12\n",
                rod + "set Position = 0.2; 0.06\n",
                ""),
    0.03,
    5);
  CHECK(errors.n_compared > 30);
  CHECK(errors.n_solves < errors.n_steps / 2);
  CHECK(errors.force.worst < 0.01);
  CHECK(errors.torque.worst < 0.01);
  CHECK(errors.virial.worst < 0.01);
}

TEST_CASE("Once all stands still the magnetic force is that of a solve", "[simulation][mpi]")
{
  // A magnet comes down above a block on the floor and stops; damping brings the block to rest. The place of both
  // is then that of a run with a solve in every step, and so must the force be. What the block does to
  // the magnet is its opposite: 0.1 %, by the different quadratures of both.
  const std::string frames = "set Key frames = 0, 0.24,0.2; 0.04, 0.24,0.085\n"
                             "set Interpolation = smooth\n";
  const Parameters<2> parameters =
    block_scene("set Lower corner = 0.2, 0\nset Upper corner = 0.28, 0.04\n",
                rod + frames,
                "subsection Rest\nset Damping rate = 200\nend\n");
  Parameters<2> solving         = parameters;
  solving.solve_trigger.trigger = SolveTriggerParameters::Trigger::every_step;
  Scene<2> scene(parameters, MPI_COMM_WORLD), other(solving, MPI_COMM_WORLD);
  unsigned int n_solves = 0;
  for (Scene<2> *one : {&scene, &other})
    {
      one->begin();
      while (one->time() < 0.1)
        {
          if (one->time() < 0.041)
            n_solves = one->magnetics().state().n_solves;
          one->step({0.1, true, {}});
          one->prepare_row();
        }
      if (one == &scene)
        CHECK(scene.magnetics().state().n_solves < n_solves + 8);
    }
  const double exact = body_force(other);
  CHECK(exact > 1.);
  CHECK(body_force(scene) == Approx(exact).epsilon(1e-3));
  CHECK(scene.force_on_magnet("magnet").force[1] == Approx(-exact).epsilon(1e-3));
}

TEST_CASE("A vibration is not solved for again and again", "[simulation]")
{
  // A free block is stretched by a field that is switched on, and vibrates without damping by a hundredth
  // of dx. The intervals between solves at least double: there are no more than 2 + log2(steps).
  const Parameters<2> parameters =
    block_scene(free_block, "set Type = uniform field\nset Field = 0; 2e5\n", "");
  Scene<2> scene(parameters, MPI_COMM_WORLD);
  scene.begin();
  for (int step = 0; step < 2000; ++step)
    scene.step({10., true, {}});
  CHECK(scene.total().max_speed > 1e-3);
  CHECK(scene.magnetics().state().n_solves >= 2);
  CHECK(scene.magnetics().state().n_solves <= 13);
}
