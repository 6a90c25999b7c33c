#include <magmpm/coupling/density_relaxation.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr int n_cells = 8; ///< of the pool along x; it is as deep, on the lower wall of y

  /**
   * A pool of 4 particles per cell in 2D, stretched along y by @p stretch, between the walls of x:
   * the lattice is 8 cells wide here.
   */
  std::vector<Body<2>>
  pool(const Lattice<2> &lattice, const MechanicalLaw law, const double stretch)
  {
    std::vector<Body<2>> bodies;
    bodies.push_back(empty_body<2>(law, false));
    ParticleSet<2> &particles = bodies[0].particles;
    particles.resize(4 * n_cells * n_cells);
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        const double x = 0.25 + 0.5 * (p % (2 * n_cells)), y = 0.25 + 0.5 * (p / (2 * n_cells));
        particles.ids()[p]                                    = p;
        particles.component(ParticleProperty::position, 0)[p] = lattice.lower_corner[0] +
                                                                lattice.spacing * x;
        particles.component(ParticleProperty::position, 1)[p] = lattice.lower_corner[1] +
                                                                lattice.spacing * stretch * y;
        particles.component(ParticleProperty::volume, 0)[p] = 0.25 * lattice.spacing *
                                                              lattice.spacing;
        for (int c = 0; c < particles.n_components(ParticleProperty::deformation); c += 3)
          particles.component(ParticleProperty::deformation, c)[p] = 1.;
      }
    return bodies;
  }

  DensityError
  relax(const Lattice<2> &lattice, const double time, std::vector<Body<2>> &bodies)
  {
    const BlockSet<2> blocks = active_blocks(bodies, lattice);
    sort_all(blocks, lattice, bodies);
    NodeField<2, SingleScalar> fraction(blocks.size());
    scatter_volume(bodies, undeformed_fluids(bodies), blocks, lattice, fraction);
    const NodeField<2, NodeFluid> field = fluid_on_nodes(blocks, lattice, OpenFaces<2>(), fraction);
    return relax_volume_ratios(field, blocks, lattice, time, bodies);
  }

  Lattice<2>
  narrow_lattice()
  {
    Lattice<2> lattice = test_lattice<2>();
    lattice.n_cells    = {n_cells, 16};
    return lattice;
  }
} // namespace

TEST_CASE("J of a fluid becomes that of the lattice, up to the walls", "[coupling]")
{
  // The pool is squeezed to 0.9 of its depth, but its J says 1. After a long time J is 0.9 wherever
  // the free surface is not near, also next to the walls (whose shares of B-splines are exact for a
  // continuum and off by less than 1 % for four particles per cell), and 1 still at the surface.
  const Lattice<2> lattice    = narrow_lattice();
  std::vector<Body<2>> bodies = pool(lattice, MechanicalLaw::viscoelastic_fluid, 0.9);
  const DensityError error    = relax(lattice, 1e9, bodies);
  const ParticleSet<2> &water = bodies[0].particles;
  double n_relaxed = 0., wrong = 0., top_changed = 0.;
  for (std::size_t p = 0; p < water.size(); ++p)
    {
      const double j      = water.component(ParticleProperty::deformation, 0)[p];
      const double height = (water.position(p)[1] - lattice.lower_corner[1]) / lattice.spacing;
      if (j != 1.)
        {
          n_relaxed += 1.;
          wrong = std::max(wrong, std::abs(j - 0.9));
        }
      if (height > 0.9 * n_cells - 0.6)
        top_changed += (j != 1.);
      if (height < 0.9 * n_cells - 2.)
        CHECK(j != 1.);
    }
  CHECK(wrong < 0.009);
  CHECK(top_changed == 0.);
  CHECK(error.n_particles == n_relaxed);
  CHECK(error.sum / error.n_particles == Approx(0.1).epsilon(0.05));
}

TEST_CASE("the way to the J of the lattice takes three times of sound across a cell", "[coupling]")
{
  // After t = 3 dx/c the rest of the way is 1/e of it: at a particle in the middle, from 1 to 0.9.
  const Lattice<2> lattice    = narrow_lattice();
  std::vector<Body<2>> bodies = pool(lattice, MechanicalLaw::viscoelastic_fluid, 0.9);
  const double speed          = std::sqrt(1.3 / 2.); // K and density of the test's fluid
  relax(lattice, 3. * lattice.spacing / speed, bodies);
  double middle = 0.;
  for (std::size_t p = 0; p < bodies[0].particles.size(); ++p)
    if (bodies[0].particles.ids()[p] == 4 * n_cells * n_cells / 2)
      middle = bodies[0].particles.component(ParticleProperty::deformation, 0)[p];
  CHECK(middle == Approx(0.9 + 0.1 * std::exp(-1.)).margin(0.001));
}

TEST_CASE("solids are not relaxed, and no free surface is taken for an inside", "[coupling]")
{
  // The same pool as a solid keeps its F. A fluid at 0.7 of its density is all free surface.
  const Lattice<2> lattice   = narrow_lattice();
  std::vector<Body<2>> solid = pool(lattice, MechanicalLaw::neo_hookean, 0.9);
  CHECK_FALSE(has_fluid(solid));
  CHECK(relax(lattice, 1e9, solid).n_particles == 0.);
  for (std::size_t p = 0; p < solid[0].particles.size(); ++p)
    CHECK(solid[0].particles.component(ParticleProperty::deformation, 0)[p] == 1.);

  std::vector<Body<2>> thin = pool(lattice, MechanicalLaw::viscoelastic_fluid, 1. / 0.7);
  CHECK(has_fluid(thin));
  CHECK(relax(lattice, 1e9, thin).n_particles == 0.);
}

TEST_CASE("in a spray J becomes one", "[coupling]")
{
  // Every third particle of every third row alone: its own share of a node is too little to be a fluid.
  const Lattice<2> lattice    = narrow_lattice();
  std::vector<Body<2>> bodies = pool(lattice, MechanicalLaw::viscoelastic_fluid, 1.);
  ParticleSet<2> &water       = bodies[0].particles;
  std::vector<std::uint32_t> sparse;
  for (std::uint32_t p = 0; p < water.size(); ++p)
    if ((p % (2 * n_cells)) % 3 == 0 && (p / (2 * n_cells)) % 3 == 0)
      sparse.push_back(p);
  water.reorder(sparse);
  for (std::size_t p = 0; p < water.size(); ++p)
    water.component(ParticleProperty::deformation, 0)[p] = (p % 2 == 0 ? 1.5 : 0.6);
  CHECK(relax(lattice, 1e9, bodies).n_particles == 0.);
  for (std::size_t p = 0; p < water.size(); ++p)
    CHECK(water.component(ParticleProperty::deformation, 0)[p] == Approx(1.));
}
