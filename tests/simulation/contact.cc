// Solids that touch walls, rigid bodies and a fluid, on any number of ranks.

#include <magmpm/simulation/scene.h>

#include <magmpm/parameters/parameter_file.h>

#include "../catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  /** A soft block that flies onto a free ball, which lies before a wall; both slide along the floor. */
  std::string
  three_things(const std::string &contact, const std::string &walls, const std::string &mass)
  {
    return R"(
set Dimension = 2
set End time  = 1
set Gravity   = 0, 0
subsection Box
  set Upper corner = 2, 1
  set Cell size    = 0.0625
end
subsection Walls
  set Lower x          = )" +
           walls + R"(
  set Upper x          = )" +
           walls + R"(
  set Lower y          = )" +
           walls + R"(
  set Upper y          = )" +
           walls + R"(
end
subsection Bodies
  set List of bodies = block
  subsection block
    set Material     = rubber
    set Lower corner = 0.42, 0.3
    set Upper corner = 0.94, 0.75
    set Density      = 1000
    set Velocity     = 3, 0.4
    set Angular velocity = 2
  end
end
subsection Materials
  set List of materials = rubber
  subsection rubber
    set Young's modulus = 1e5
    set Poisson ratio   = 0.3
  end
end
subsection Rigid bodies
  set List of rigid bodies = ball
  subsection ball
    set Shape    = sphere
    set Centre   = 1.25, 0.6
    set Radius   = 0.2
    set Mass     = )" +
           mass + R"(
    set Contact  = )" +
           contact + R"(
    set Friction = )" +
           (contact == "stick" ? "0" : "0.3") + R"(
  end
end
)";
  }

  Parameters<2>
  parameters_of(const std::string &contact, const std::string &walls, const std::string &mass)
  {
    return read_parameters<2>(
      parse_parameter_text(three_things(contact, walls, mass), "contact.prm"));
  }

  struct State
  {
    ParticleSums<2> sums;
    Vector<2> position, momentum; ///< of the ball
    double angular_momentum;      ///< of both about the origin
    double energy;                ///< kinetic and elastic, of both
  };

  State
  state_of(const Scene<2> &scene)
  {
    const RigidBody<2> &ball = scene.rigid_bodies().all()[0];
    State state              = {
                   scene.total(), ball.pose().position, ball.mass() * ball.motion().velocity, 0., 0.};
    state.angular_momentum = state.sums.angular_momentum[0] + ball.angular_momentum()[0] +
                             cross(state.position, state.momentum)[0];
    state.energy = state.sums.kinetic_energy + state.sums.elastic_energy + ball.kinetic_energy();
    return state;
  }

  State
  after_steps(Scene<2> &scene, const int n_steps)
  {
    for (int n = 0; n < n_steps; ++n)
      scene.step({1., n + 1 == n_steps, {}});
    return state_of(scene);
  }
} // namespace

TEST_CASE("What solids touch gets what they lose", "[simulation]")
{
  // In free flight until they meet: momentum of both together to rounding, angular momentum to what the transfer
  // changes of it, whatever the condition and the ratio of their masses; and no energy is gained.
  for (const std::string contact : {"separate", "slip", "stick"})
    for (const std::string mass : {"1000", "60", "3"})
      {
        CAPTURE(contact, mass);
        Scene<2> scene(parameters_of(contact, "open", mass), MPI_COMM_SELF);
        scene.begin();
        const State before = after_steps(scene, 1);
        const State after  = after_steps(scene, 160);
        const double size  = norm(before.sums.momentum);
        CHECK(norm(after.momentum) > (mass == "3" ? 0.01 : 0.1) * size);
        CHECK(norm(after.sums.momentum + after.momentum - before.sums.momentum - before.momentum) <
              1e-12 * size);
        CHECK(std::abs(after.angular_momentum - before.angular_momentum) < 1e-4 * size);
        CHECK(after.energy < 1.01 * before.energy);
      }
}

TEST_CASE("Contact is the same on any number of ranks", "[simulation][mpi]")
{
  for (const std::string contact : {"separate", "stick"})
    for (const std::string walls : {"separate", "slip"})
      {
        CAPTURE(contact, walls);
        const Parameters<2> parameters = parameters_of(contact, walls, "60");
        Scene<2> alone(parameters, MPI_COMM_SELF), together(parameters, MPI_COMM_WORLD);
        alone.begin();
        together.begin();
        const State a = after_steps(alone, 300), b = after_steps(together, 300);
        CHECK(b.sums.elastic_energy == Approx(a.sums.elastic_energy).epsilon(1e-7));
        CHECK(norm(b.sums.momentum - a.sums.momentum) < 1e-8 * norm(a.sums.momentum));
        CHECK(norm(b.position - a.position) < 1e-9);
      }
}
