#include "catch.h"

#include <verification/magnetostatics/sampled_setup.h>
#include <verification/magnetostatics/sources.h>

using namespace magmpm;
using namespace magmpm::verification;

// What a solve with its force and field costs in exchanges between ranks, with content and mass before it
// and the accelerations after it, as MagneticCoupling does: 2 + 11 + 2 + 3 + 2 + 1. Each sends the lanes
// in use, of which there are 43 (content 2 x 4; the indicator 3 + 2 + 3 x 2 + 3; mass 2; force 3 x 3; field
// 4 + 3; accelerations 3).
TEST_CASE("A solve has 21 exchanges", "[magnetics][mpi]")
{
  const double spacing = 0.01;
  SampledSetup<3> setup(16, spacing, 2., {});
  setup.set_bodies({sphere<3>({{0.08, 0.08, 0.08}}, 0.03, {8e4, 0.9})});
  setup.problem.solve(setup.content, ExternalField<3>({uniform_source<3>({{0., 0., 1e4}})}));
  NodeField<3, SingleVector> force, field;
  setup.problem.compute_force(setup.mass, force);
  setup.problem.compute_field(field);
  setup.partition.update_ghosts(force);
  CHECK(setup.partition.exchanges().n_exchanges == 21);
  CHECK(setup.partition.exchanges().n_lanes == 43);
}
