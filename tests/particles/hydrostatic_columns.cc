#include <magmpm/particles/hydrostatic_columns.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  template <int dim>
  using Bodies = std::pair<std::vector<BodyParameters<dim>>, std::vector<Body<dim>>>;

  /** Adds a box over the width of the test lattice, between two heights in it. @return its parameters. */
  template <int dim>
  BodyParameters<dim> &
  add_layer(const double lower,
            const double upper,
            const double density,
            const double bulk_modulus,
            Bodies<dim> &bodies)
  {
    const Lattice<dim> lattice = test_lattice<dim>();
    BodyParameters<dim> parameters;
    parameters.density            = density;
    parameters.shape.lower_corner = lattice.lower_corner;
    parameters.shape.upper_corner = lattice.upper_corner();
    parameters.shape.lower_corner[dim - 1] += lower;
    parameters.shape.upper_corner[dim - 1] = lattice.lower_corner[dim - 1] + upper;
    MaterialParameters material;
    material.law          = MechanicalLaw::viscoelastic_fluid;
    material.bulk_modulus = bulk_modulus;
    if (bulk_modulus > 0.)
      parameters.initial_state = InitialState::hydrostatic;
    bodies.first.push_back(parameters);
    bodies.second.emplace_back(parameters, material);
    return bodies.first.back();
  }

  template <int dim>
  Vector<dim>
  downward(const double acceleration, const double lean = 0.)
  {
    Vector<dim> gravity;
    gravity[0]       = lean;
    gravity[dim - 1] = -acceleration;
    return gravity;
  }

  template <int dim>
  HydrostaticColumns<dim>
  columns_of(const Bodies<dim> &bodies,
             const Vector<dim> &gravity,
             const std::vector<Obstacle<dim>> &rigid_bodies = {})
  {
    return {bodies.first, bodies.second, gravity, test_lattice<dim>(), rigid_bodies};
  }

  /** In the middle of the test lattice, at a height in it. */
  template <int dim>
  Vector<dim>
  middle_at(const double height)
  {
    const Lattice<dim> lattice = test_lattice<dim>();
    Vector<dim> place          = 0.5 * (lattice.lower_corner + lattice.upper_corner());
    place[dim - 1]             = lattice.lower_corner[dim - 1] + height;
    return place;
  }

  /** p after dp/dz = rho_0 g/(1 - p/K) over a depth, by small steps of Runge and Kutta's fourth order. */
  double
  integrated(double pressure, const double depth, const double weight, const double bulk_modulus)
  {
    constexpr int n   = 1000;
    const double step = depth / n;
    const auto slope  = [&](const double p) { return weight / (1. - p / bulk_modulus); };
    for (int i = 0; i < n; ++i)
      {
        const double k1 = slope(pressure), k2 = slope(pressure + 0.5 * step * k1);
        const double k3 = slope(pressure + 0.5 * step * k2), k4 = slope(pressure + step * k3);
        pressure += step / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
      }
    return pressure;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("the pressure in layers is the weight above",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Water under oil under a slab that is not compressed, with interfaces off the lattice, in gravity along an axis and
  // leaning by 3 to 4: against the integral of the weight over the way up. The bodies are listed in another order.
  Bodies<dim> bodies;
  add_layer<dim>(0.83, 1.01, 800., 2e4, bodies); // oil
  add_layer<dim>(1.01, 1.13, 500., 0., bodies);  // slab
  add_layer<dim>(0., 0.83, 1000., 6e4, bodies);  // water
  for (const double lean : {0., 7.5})
    {
      const auto columns      = columns_of(bodies, downward<dim>(10., lean));
      const double steeper    = 10. / std::sqrt(100. + lean * lean); // height over way
      const double g          = 10. / steeper;
      const double below_slab = 500. * g * 0.12 / steeper;
      CHECK(columns.pressure(1, middle_at<dim>(1.09)) == Approx(500. * g * 0.04 / steeper));
      CHECK(columns.pressure(0, middle_at<dim>(0.9)) ==
            Approx(integrated(below_slab, 0.11 / steeper, 800. * g, 2e4)).epsilon(1e-9));
      const double below_oil = integrated(below_slab, 0.18 / steeper, 800. * g, 2e4);
      CHECK(columns.pressure(2, middle_at<dim>(0.8)) ==
            Approx(integrated(below_oil, 0.03 / steeper, 1000. * g, 6e4)).epsilon(1e-9));
      CHECK(columns.pressure(2, middle_at<dim>(0.5)) ==
            Approx(integrated(below_oil, 0.33 / steeper, 1000. * g, 6e4)).epsilon(1e-9));
    }
}

TEST_CASE("what does not stand on a fluid does not press", "[particles]")
{
  // A slab 3 dx above the surface of a pool is about to fall into it: the pool bears its own weight alone, and none
  // at the surface, above which some particles lie. What lies below the floor is that much deeper.
  Bodies<2> bodies;
  add_layer<2>(0., 0.5, 1000., 5e4, bodies);
  add_layer<2>(0.8, 1., 1000., 0., bodies);
  const auto columns = columns_of(bodies, downward<2>(10.));
  CHECK(columns.pressure(0, middle_at<2>(0.3)) == Approx(pressure_below(0., 2000., 5e4)));
  CHECK(columns.pressure(0, middle_at<2>(0.51)) == 0.);
  CHECK(columns.pressure(0, middle_at<2>(-0.01)) ==
        Approx(pressure_below(0., 5000., 5e4) + 100.).epsilon(1e-6));
}

TEST_CASE("a pool bears rigid bodies by what they displace", "[particles]")
{
  // A pool with a hole for a ball that is under water, and with one for a ball that floats: at any place, also below
  // the balls, the pressure is that at the same depth in a pool without. Weight of the water alone would be less there.
  for (const double height : {0.4, 0.75})
    {
      Bodies<2> bodies;
      BodyParameters<2> &pool     = add_layer<2>(0., 0.83, 1000., 6e4, bodies);
      ShapeParameters<2> box      = pool.shape, ball;
      ball.type                   = ShapeType::sphere;
      ball.centre                 = middle_at<2>(height);
      ball.radius                 = 0.25;
      pool.shape                  = {};
      pool.shape.type             = ShapeType::difference;
      pool.shape.parts            = {box, ball};
      const std::shared_ptr shape = make_shape(ball);
      const auto columns =
        columns_of<2>(bodies, downward<2>(10.), {[shape](const Vector<2> &place) {
                        return shape->surface_distance(place);
                      }});
      for (const double across : {0., 0.1, 0.22, 0.6})
        {
          Vector<2> place = middle_at<2>(0.05);
          place[0] += across;
          CHECK(columns.pressure(0, place) == Approx(pressure_below(0., 7800., 6e4)));
        }
    }
}

TEST_CASE("pressure at the floor balances that of its image", "[particles]")
{
  // A particle at the distance t from the floor and its image push the first node above it by p N(d) d each.
  // Pressure that goes on linearly would be larger in the image by 2 t; what is added to both makes up for it.
  const auto spline = [](const double x) {
    return x < 0.5 ? 0.75 - x * x : 0.5 * std::pow(std::max(1.5 - x, 0.), 2);
  };
  for (const double t : {0., 0.01, 0.125, 0.25, 0.4, 0.49, 0.5, 0.6, 1.4})
    {
      const double particle = spline(std::abs(1. - t)) * (1. - t),
                   image    = spline(1. + t) * (1. + t);
      CHECK(floor_excess(t) * (particle + image) == Approx(image * 2. * t).margin(1e-15));
    }
}

TEST_CASE("compressed fluid fills its shape", "[particles]")
{
  // Particles keep their places and the volume J V_0, and weigh rho_0 V_0: more than before, by 1/J. Pressure is that
  // of the depth and, next to the floor, the excess for its images. What bears too much tells the weight that it
  // bears.
  Bodies<2> bodies;
  add_layer<2>(0., 0.83, 1000., 6e4, bodies);
  bodies.first[0].jitter = 0.5;
  seed_particles(bodies.first[0], test_lattice<2>(), 0, 0, 1, bodies.second[0]);
  ParticleSet<2> &particles     = bodies.second[0].particles;
  const ParticleSet<2> at_first = particles;
  const Compression compression = columns_of(bodies, downward<2>(10.)).compress(0, particles);
  double error                  = 0.;
  for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const double volume  = particles.component(ParticleProperty::volume, 0)[p];
      const double ratio   = particles.component(ParticleProperty::deformation, 0)[p];
      const double height  = particles.position(p)[1] - 0.1;
      const double weight  = 1e4 * std::max(0.83 - height, 0.);
      const double at_rest = pressure_below(0., weight, 6e4) +
                             1e4 * 0.1 * floor_excess(height / 0.1);
      error = std::max(
        {error,
         norm(particles.position(p) - at_first.position(p)),
         std::abs(ratio * volume / at_first.component(ParticleProperty::volume, 0)[p] - 1.),
         std::abs(particles.component(ParticleProperty::mass, 0)[p] / (1000. * volume) - 1.),
         std::abs(ratio - 1. + at_rest / 6e4)});
    }
  CHECK(error < 1e-9);
  CHECK(compression.smallest_ratio == Approx(0.852).epsilon(0.01));
  CHECK(compression.largest_weight == 0.);
  const Compression too_much =
    columns_of(bodies, downward<2>(100.)).compress(0, bodies.second[0].particles);
  CHECK(too_much.smallest_ratio < 0.5);
  CHECK(too_much.largest_weight == Approx(8.3e4).epsilon(0.05));
}

TEST_CASE("gravity may point along any axis", "[particles]")
{
  // A pool at the ceiling in gravity upward is the mirror image of one on the floor; fluid that fills the box is as deep
  // towards either side. The lowest particles lie dx/4 from the wall.
  const auto smallest_ratio = [](const double lower, const double upper, const Vector<2> &gravity) {
    Bodies<2> bodies;
    add_layer<2>(lower, upper, 1000., 6e4, bodies);
    seed_particles(bodies.first[0], test_lattice<2>(), 0, 0, 1, bodies.second[0]);
    return columns_of(bodies, gravity).compress(0, bodies.second[0].particles).smallest_ratio;
  };
  const auto expected = [](const double depth) {
    return 1. -
           (pressure_below(0., 1e4 * (depth - 0.025), 6e4) + 1e4 * 0.1 * floor_excess(0.25)) / 6e4;
  };
  CHECK(smallest_ratio(0., 0.8, downward<2>(10.)) == Approx(expected(0.8)).epsilon(1e-10));
  CHECK(smallest_ratio(0.8, 1.6, downward<2>(-10.)) == Approx(expected(0.8)).epsilon(1e-10));
  for (const double sideways : {10., -10.})
    CHECK(smallest_ratio(0., 0.8, downward<2>(0., sideways)) ==
          Approx(expected(1.6)).epsilon(1e-10));
}
