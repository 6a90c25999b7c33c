#include "catch.h"

#include <magmpm/parallel/reduce.h>
#include <magmpm/surface/force_handover.h>

#include <verification/magnetostatics/sampled_setup.h>

using namespace magmpm;
using namespace magmpm::verification;

// Force on the two layers of nodes around the mass goes to nodes with mass, its sum (what is dropped
// further out included) stays, on any number of ranks: every node gives all it has in equal parts.
TEMPLATE_TEST_CASE_SIG("Force without mass is handed inward",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const double dx = 0.25;
  SampledSetup<dim> scene(16, dx, 2., {});
  Vector<dim> centre;
  for (int d = 0; d < dim; ++d)
    centre[d] = 2.1 + 0.05 * d;
  scene.set_bodies({sphere<dim>(centre, 1.2, {1., 1.})});

  constexpr auto vector = SingleVector::value;
  NodeField<dim, SingleVector> force(scene.partition.blocks().size());
  scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
    Vector<dim> f;
    for (int d = 0; d < dim; ++d)
      f[d] = 1. + std::sin(3. * x[0] + d) * std::cos(5. * x[1]);
    force.set(vector, slot, node, f);
  });
  const Vector<dim> before = scene.sum(force);

  const Vector<dim> dropped = hand_force_inward<dim>(scene.partition, scene.mass, force);

  for (int d = 0; d < dim; ++d)
    {
      const double all_dropped = parallel::sum(dropped[d], MPI_COMM_WORLD);
      CHECK(all_dropped > 0.);
      CHECK(scene.sum(force)[d] + all_dropped == Approx(before[d]).epsilon(1e-13));
    }
  double on_empty_nodes = 0., smallest_on_mass = 1e300;
  scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &) {
    const double f = std::abs(force.get(vector, slot, node)[0]);
    if (scene.mass.get(SingleScalar::value, slot, node) > 0.)
      smallest_on_mass = std::min(smallest_on_mass, f);
    else
      on_empty_nodes = std::max(on_empty_nodes, f);
  });
  CHECK(on_empty_nodes == 0.);
  CHECK(smallest_on_mass > 0.);

  // A single force two nodes from the mass arrives within two nodes: reach, not only sum.
  force.set_zero();
  scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
    Vector<dim> start = centre;
    start[0] -= 1.2 + 3. * dx;
    Vector<dim> f;
    f[0] = 1.;
    if (norm(scene.lattice.reduced(x - start)) < 0.9)
      force.set(vector, slot, node, f);
  });
  const double given = scene.sum(force)[0];
  const double lost  = parallel::sum(hand_force_inward<dim>(scene.partition, scene.mass, force)[0],
                                    MPI_COMM_WORLD);
  CHECK(given > 0.);
  CHECK(scene.sum(force)[0] + lost == Approx(given).epsilon(1e-13));
  scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
    if (force.get(vector, slot, node)[0] != 0.)
      CHECK(x[0] < centre[0]);
  });
}
