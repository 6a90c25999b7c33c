// The volume of a body on the lattice, as it reaches the rank that writes the surface.

#include "../test_folder.h"
#include "catch.h"

#include <magmpm/parallel/reduce.h>
#include <magmpm/surface/body_volume.h>

#include <cmath>

using namespace magmpm;

namespace
{
  /** Some particles of this rank, of one volume, on both sides of the corner of the lattice. */
  template <int dim>
  Body<dim>
  scattered_body(const double volume)
  {
    BodyParameters<dim> parameters;
    parameters.density = 1000.;
    MaterialParameters material;
    material.law = MechanicalLaw::viscoelastic_fluid;
    Body<dim> body(parameters, material);
    body.particles.resize(20 + testing::this_rank());
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      {
        for (int d = 0; d < dim; ++d)
          body.particles.component(ParticleProperty::position,
                                   d)[p] = std::sin(1. + p + 100 * testing::this_rank() + 10 * d);
        body.particles.component(ParticleProperty::volume, 0)[p]      = volume;
        body.particles.component(ParticleProperty::deformation, 0)[p] = 1.5;
      }
    return body;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("Slabs of a body's volume are those of the whole box",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  // B-splines add up to one, so the fractions add up to the volume J V_0 of the particles of all ranks over
  // dx^dim. In slabs, each of which repeats the last layer of the one before, stand the same numbers as in one
  // that is the whole box, whose outermost layers are empty.
  Lattice<dim> lattice;
  lattice.spacing = 0.07;
  lattice.n_cells.fill(16);
  const double volume   = 3e-4;
  const Body<dim> body  = scattered_body<dim>(volume);
  const double n        = parallel::sum(double(body.particles.size()), MPI_COMM_WORLD);
  const double expected = n * 1.5 * volume / std::pow(lattice.spacing, dim);

  const BodyVolume<dim> fractions(body, lattice, MPI_COMM_WORLD);
  std::vector<double> whole, joined;
  fractions.for_each_slab([&](const NodeBox<dim> &box) { whole = box.values; }, 1u << 30);
  int n_slabs = 0;
  fractions.for_each_slab(
    [&](const NodeBox<dim> &slab) {
      const std::size_t n_layer = slab.values.size() / slab.count[dim - 1];
      const std::size_t overlap = n_slabs++ == 0 ? 0 : n_layer;
      for (std::size_t i = 0; i < overlap; ++i)
        CHECK(slab.values[i] == joined[joined.size() - n_layer + i]);
      joined.insert(joined.end(), slab.values.begin() + overlap, slab.values.end());
    },
    1);

  if (testing::this_rank() > 0)
    {
      CHECK(whole.empty());
      return;
    }
  CHECK(n_slabs > 4);
  CHECK(joined == whole);
  double sum = 0.;
  for (const double fraction : whole)
    sum += fraction;
  CHECK(sum == Approx(expected).epsilon(1e-12));
  CHECK(whole.front() == 0.);
  CHECK(whole.back() == 0.);
}

TEST_CASE("A body without particles has no slabs", "[surface][mpi]")
{
  // No rank has any: nothing is called, and no rank waits.
  BodyParameters<3> parameters;
  parameters.density = 1000.;
  Body<3> body(parameters, {});
  Lattice<3> lattice;
  lattice.spacing = 0.1;
  int n_slabs     = 0;
  BodyVolume<3>(body, lattice, MPI_COMM_WORLD)
    .for_each_slab([&](const NodeBox<3> &) { ++n_slabs; }, 1);
  CHECK(n_slabs == 0);
}
