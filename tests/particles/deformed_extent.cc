#include <magmpm/particles/deformed_extent.h>
#include <magmpm/particles/seeding.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

#include <algorithm>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  template <int dim>
  Body<dim>
  seeded_box(const Lattice<dim> &lattice,
             const Vector<dim> &lower,
             const Vector<dim> &upper,
             const int n)
  {
    BodyParameters<dim> parameters;
    parameters.density            = 1000.;
    parameters.particles_per_edge = n;
    parameters.shape.lower_corner = lower;
    parameters.shape.upper_corner = upper;
    Body<dim> body                = empty_body<dim>(MechanicalLaw::neo_hookean, false);
    seed_particles(parameters, lattice, 0, 0, 1, body);
    return body;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("The cofactor of a matrix is its determinant times its inverse, turned over",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  Random random(3);
  Matrix<dim> matrix = identity<dim>();
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      matrix(i, j) += random.between(-0.4, 0.4);
  const Matrix<dim> product = transpose(cofactor(matrix)) * matrix;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      CHECK(product(i, j) == Approx(i == j ? determinant(matrix) : 0.).margin(1e-14));
}

TEMPLATE_TEST_CASE_SIG("What particles at the faces of a body fill ends there",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A box off the lattice, of which no cell holds a part so small that it joins another, with one to three particles along the edge of a cell: those that look out of a
  // face reach it, and no others.
  Lattice<dim> lattice;
  lattice.spacing = 0.1;
  lattice.n_cells.fill(20);
  Vector<dim> lower, upper;
  for (int d = 0; d < dim; ++d)
    {
      lower[d] = 0.521 + 0.005 * d;
      upper[d] = 0.98 + 0.005 * d;
    }
  for (const int n : {1, 2, 3})
    {
      const Body<dim> body = seeded_box<dim>(lattice, lower, upper, n);
      const auto particles = body.particles.arrays();
      for (int face = 0; face < 2 * dim; ++face)
        {
          const int d = face / 2;
          Vector<dim> inward;
          inward[d]           = (face % 2 == 0 ? 1. : -1.);
          const double height = (face % 2 == 0 ? lower[d] : upper[d]);
          int n_looking       = 0;
          for (std::size_t p = 0; p < body.particles.size(); ++p)
            {
              const DeformedExtent<dim> extent(particles, identity<dim>(), p);
              const double gap = inward[d] * (body.particles.position(p)[d] - height) -
                                 extent.reach(inward);
              CHECK(gap > -1e-12);
              const bool looks = extent.facing(inward) > 0.1 * std::pow(0.02, dim - 1);
              CAPTURE(n, face, gap);
              CHECK(looks == (gap < 1e-12));
              n_looking += looks;
            }
          CHECK(n_looking >= 4 * (dim - 1));
        }
    }
}

TEST_CASE("Extents follow the deformation", "[particles]")
{
  // A full cell stretched to twice its length in x and turned by a right angle, to y: what was its face to -x, with
  // one particle of 0.2113 dx from it, is twice as far below; of as large an area.
  Lattice<2> lattice;
  lattice.spacing = 1.;
  lattice.n_cells.fill(20);
  const Body<2> body   = seeded_box<2>(lattice, {{4., 4.}}, {{5., 5.}}, 2);
  const auto particles = body.particles.arrays();
  Matrix<2> stretched_and_turned;
  stretched_and_turned(0, 1) = -1.;
  stretched_and_turned(1, 0) = 2.;
  const double half          = 0.5 - 0.5 / std::sqrt(3.);
  int n_below                = 0;
  for (std::size_t p = 0; p < body.particles.size(); ++p)
    {
      const DeformedExtent<2> extent(particles, stretched_and_turned, p);
      CHECK(extent.reach({{0., 1.}}) == Approx(2. * half));
      CHECK(extent.reach({{1., 0.}}) == Approx(half));
      const bool is_left = body.particles.position(p)[0] < 4.5;
      CHECK(extent.facing({{0., 1.}}) == Approx(is_left ? half : 0.).margin(0.01 * half));
      n_below += is_left;
    }
  CHECK(n_below == 2);
}
