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

namespace
{
  /**
   * A hard plate between two soft blocks, of three contact groups, and a free ball that the second block lies against:
   * one block flies onto the plate, which then meets the other. The ball is in the way of both.
   */
  std::string
  three_groups(const std::string &condition, const std::string &walls)
  {
    std::string text = three_things("separate", walls, "60");
    text.replace(text.find("List of bodies = block"), 22, "List of bodies = block, plate, other");
    const std::string lines = R"(
    set Density = 1000
  end
)";
    text.insert(text.find("end\nsubsection Materials"),
                R"(
  subsection plate
    set Material      = hard
    set Contact group = 1
    set Lower corner  = 0.95, 0.32
    set Upper corner  = 1.03, 0.8
    set Density       = 1000
  end
  subsection other
    set Material      = rubber
    set Contact group = 7
    set Lower corner  = 1.05, 0.05
    set Upper corner  = 1.4, 0.395
    set Density       = 3000
  end
)");
    text.replace(text.find("List of materials = rubber"), 26, "List of materials = rubber, hard");
    text.insert(text.find("end\nsubsection Rigid bodies"),
                R"(
  subsection hard
    set Young's modulus = 4e5
    set Poisson ratio   = 0.3
    set Transfer        = APIC
  end
)");
    std::string contacts = "subsection Contacts\nset List of contacts = a, b, c\n";
    for (const auto &[name, groups] :
         {std::pair{"a", "0, 1"}, std::pair{"b", "7, 1"}, std::pair{"c", "0, 7"}})
      contacts += std::string("subsection ") + name + "\nset Groups = " + groups +
                  "\nset Condition = " + condition + "\nset Friction = 0.3\nend\n";
    return text + contacts + "end\n";
  }

  Parameters<2>
  parameters_of_groups(const std::string &condition, const std::string &walls)
  {
    return read_parameters<2>(parse_parameter_text(three_groups(condition, walls), "groups.prm"));
  }
} // namespace

TEST_CASE("What bodies of different groups lose others get", "[simulation]")
{
  // As above, with three groups that meet each other and a free ball: momentum of all to what nodes of negligible mass
  // drop (1e-15 without, update_lattice_momentum()), angular momentum to what the transfer changes of it, and no energy
  // is gained. All of them are hit.
  for (const std::string condition : {"separate", "slip", "stick"})
    {
      CAPTURE(condition);
      Scene<2> scene(parameters_of_groups(condition, "open"), MPI_COMM_SELF);
      scene.begin();
      const State before = after_steps(scene, 1);
      const State after  = after_steps(scene, 150);
      const double size  = norm(before.sums.momentum);
      CHECK(norm(after.momentum) > 0.01 * size);
      for (const int b : {1, 2})
        CHECK(norm(scene.progress().sums[b].momentum) > 0.005 * size);
      CHECK(norm(after.sums.momentum + after.momentum - before.sums.momentum - before.momentum) <
            1e-11 * size);
      CHECK(std::abs(after.angular_momentum - before.angular_momentum) < 1e-4 * size);
      CHECK(after.energy < 1.01 * before.energy);
    }
}

TEST_CASE("Contact between groups is the same on any number of ranks", "[simulation][mpi]")
{
  // The order of sums alone differs, and a few hundred steps of an impact enlarge that.
  for (const std::string condition : {"separate", "stick"})
    {
      CAPTURE(condition);
      const Parameters<2> parameters = parameters_of_groups(condition, "separate");
      Scene<2> alone(parameters, MPI_COMM_SELF), together(parameters, MPI_COMM_WORLD);
      alone.begin();
      together.begin();
      const State a = after_steps(alone, 250), b = after_steps(together, 250);
      CHECK(a.sums.elastic_energy > 1e-3);
      CHECK(b.sums.elastic_energy == Approx(a.sums.elastic_energy).epsilon(1e-7));
      CHECK(norm(b.sums.momentum - a.sums.momentum) < 1e-8 * norm(a.sums.momentum));
      CHECK(norm(b.position - a.position) < 1e-9);
    }
}

TEST_CASE("Contact between groups goes on from a checkpoint", "[simulation]")
{
  // In the middle of the impact; contact remembers nothing, so both are the same to the last bit.
  const Parameters<2> parameters = parameters_of_groups("separate", "separate");
  Scene<2> scene(parameters, MPI_COMM_SELF), resumed(parameters, MPI_COMM_SELF);
  scene.begin();
  after_steps(scene, 150);
  const std::vector<Section> sections = scene.save();
  resumed.load(sections, [&](std::vector<Body<2>> &bodies) { bodies = scene.bodies(); });
  const State a = after_steps(scene, 60), b = after_steps(resumed, 60);
  CHECK(a.sums.elastic_energy > 1e-3);
  CHECK(b.sums.elastic_energy == a.sums.elastic_energy);
  CHECK(norm(b.sums.momentum - a.sums.momentum) == 0.);
}

TEST_CASE("Groups far apart do not notice each other", "[simulation]")
{
  // A block alone, and the same with bodies of other groups that it does not reach in the time: to the last bit.
  const Parameters<2> three = parameters_of_groups("separate", "separate");
  Parameters<2> one         = three;
  one.bodies.resize(1);
  one.rigid_bodies.clear();
  Parameters<2> apart = three;
  apart.rigid_bodies.clear();
  for (const std::size_t b : {1, 2})
    {
      apart.bodies[b].shape.lower_corner[0] += 0.5;
      apart.bodies[b].shape.upper_corner[0] += 0.5;
    }
  apart.bodies[2].density = 1000.;
  Scene<2> alone(one, MPI_COMM_SELF), with_others(apart, MPI_COMM_SELF);
  for (Scene<2> *scene : {&alone, &with_others})
    {
      scene->begin();
      for (int n = 1; n <= 100; ++n)
        scene->step({5e-4 * n, n == 100, {}});
    }
  const ParticleSums<2> &a = alone.progress().sums[0], &b = with_others.progress().sums[0];
  CHECK(a.elastic_energy > 0.);
  CHECK(a.elastic_energy == b.elastic_energy);
  CHECK(norm(a.momentum - b.momentum) == 0.);
}
