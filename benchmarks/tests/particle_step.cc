#include <magmpm/base/exceptions.h>

#include <verification/catch.h>

#include <particle_step/options.h>
#include <particle_step/timed_step.h>

using namespace magmpm;
using namespace magmpm::benchmarks;

namespace
{
  /** Notes the phases that it is asked for. */
  class NotedStep : public TimedStep
  {
  public:
    void
    run(const Phase phase) override
    {
      phases.push_back(phase);
    }

    std::vector<Phase> phases;
  };
} // namespace

// One sort, then the phases of each step in their order: what the table calls ns per step holds as
// many of each.
TEST_CASE("Timed steps begin with a sort and take all phases", "[benchmarks]")
{
  NotedStep step;
  time_of_steps(step, 2);
  CHECK(
    step.phases ==
    std::vector<Phase>{
      Phase::sort, Phase::p2g, Phase::lattice, Phase::g2p, Phase::p2g, Phase::lattice, Phase::g2p});
}

// Both codes on a small cube and a small block of fluid. Each phase takes time, so none is left out;
// how much is not a matter of a test.
TEST_CASE("The particle step runs with kernels and plain loops", "[benchmarks]")
{
  for (const FallingBlock &block : {elastic_cube(500.), fluid_block(500.)})
    {
      CHECK(block.bodies[0].particles.size() == 512);
      for (const auto &step : {make_plain_step(block), make_kernel_step(block)})
        for (const double seconds : time_of_steps(*step, 3).seconds)
          CHECK(seconds > 0.);
    }
}

// Three and four numbers in no order: their least one, and the middle one or the mean of the two,
// read off.
TEST_CASE("A spread is the least value and the one in the middle", "[benchmarks]")
{
  CHECK(spread({3., 1., 2.}).least == 1.);
  CHECK(spread({3., 1., 2.}).median == 2.);
  CHECK(spread({4., 1., 3., 2.}).median == 2.5);
}

// Values come to where they belong, lists at their commas; messages name the option, the value and
// what was meant, in the words that a user meets.
TEST_CASE("Options of particle_step", "[benchmarks]")
{
  const StepOptions options = parse_step_options({"--particles", "1e5,4e6", "--steps", "7"});
  CHECK(options.particles == std::vector<double>{1e5, 4e6});
  CHECK(options.steps == 7);
  CHECK_THROWS_WITH(parse_step_options({"--particle", "5"}),
                    Catch::Matchers::Contains("did you mean '--particles'"));
  CHECK_THROWS_WITH(parse_step_options({"--repeats", "few"}),
                    Catch::Matchers::Contains("'few' cannot follow --repeats"));
  CHECK_THROWS_WITH(parse_step_options({"--repeats"}),
                    Catch::Matchers::Contains("nothing follows --repeats"));
}
