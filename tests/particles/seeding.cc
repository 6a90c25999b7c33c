#include <magmpm/base/constants.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/particles/undeformed_moments.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

#include <map>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** A box of 4 x 6 (x 8) cells whose corners are lattice nodes. */
  template <int dim>
  BodyParameters<dim>
  box_on_nodes(const Lattice<dim> &lattice)
  {
    BodyParameters<dim> parameters;
    parameters.name    = "box";
    parameters.density = 1200.;
    Index<dim> lower, upper;
    for (int d = 0; d < dim; ++d)
      {
        lower[d] = 3 + d;
        upper[d] = lower[d] + 4 + 2 * d;
      }
    parameters.shape.lower_corner = lattice.node_position(lower);
    parameters.shape.upper_corner = lattice.node_position(upper);
    return parameters;
  }

  template <int dim>
  Body<dim>
  seeded(const BodyParameters<dim> &parameters,
         const Lattice<dim> &lattice,
         const unsigned int rank    = 0,
         const unsigned int n_ranks = 1,
         const unsigned int number  = 0)
  {
    Body<dim> body = empty_body<dim>(MechanicalLaw::neo_hookean, false);
    seed_particles(parameters, lattice, number, rank, n_ranks, body);
    return body;
  }

  template <int dim>
  double
  volume_of(const Body<dim> &body)
  {
    double volume = 0.;
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      volume += body.particles.component(ParticleProperty::volume, 0)[p];
    return volume;
  }

  /** Of the undeformed volumes of particles. */
  template <int dim>
  VolumeMoments<dim>
  moments_of(const Body<dim> &body)
  {
    const Vector<dim> origin = body.particles.position(0);
    return about_centroid(undeformed_moments(body.particles, origin), origin);
  }

  /** A sphere of radius 5.3 dx or, in 3D, a cylinder, around no special point of the lattice. */
  template <int dim>
  BodyParameters<dim>
  round_body(const Lattice<dim> &lattice, const ShapeType shape)
  {
    BodyParameters<dim> parameters;
    parameters.name         = "round";
    parameters.shape.type   = shape;
    parameters.density      = 1200.;
    parameters.shape.radius = 5.3 * lattice.spacing;
    parameters.shape.length = 7.1 * lattice.spacing;
    for (int d = 0; d < dim; ++d)
      {
        parameters.shape.centre[d] = lattice.lower_corner[d] + lattice.spacing * (8.1 + 0.13 * d);
        parameters.shape.axis[d]   = 0.7 - 0.9 * d;
      }
    return parameters;
  }

  template <int dim>
  void
  check_volume(const BodyParameters<dim> &parameters, const double volume, const double tolerance)
  {
    const Lattice<dim> lattice = test_lattice<dim>();
    const Body<dim> body       = seeded(parameters, lattice);
    CHECK(volume_of(body) == Approx(volume).epsilon(tolerance));

    // No particle far outside, and the bounding box is as small as it can be.
    const BoundingBox<dim> box = make_shape(parameters.shape)->bounding_box();
    const double margin        = 0.1 * lattice.spacing;
    for (int d = 0; d < dim; ++d)
      {
        const double *x     = body.particles.component(ParticleProperty::position, d);
        const auto extremes = std::minmax_element(x, x + body.particles.size());
        CHECK(*extremes.first >= box.lower[d] - margin);
        CHECK(*extremes.first < box.lower[d] + lattice.spacing);
        CHECK(*extremes.second <= box.upper[d] + margin);
        CHECK(*extremes.second > box.upper[d] - lattice.spacing);
      }
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("a box on lattice nodes is filled exactly",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // n^dim particles in each of its cells, with the volume of the box among them. Its corners are
  // nodes, up to the rounding of their coordinates, so nothing is left out and nothing is too much.
  const Lattice<dim> lattice     = test_lattice<dim>();
  BodyParameters<dim> parameters = box_on_nodes(lattice);
  const auto shape               = make_shape(parameters.shape);
  const int n_cells              = (dim == 3 ? 4 * 6 * 8 : 4 * 6);
  for (const int n : {1, 2, 3})
    {
      parameters.particles_per_edge = n;
      const Body<dim> body          = seeded(parameters, lattice);
      REQUIRE(body.particles.size() == std::size_t(n_cells * power(n, dim)));
      CHECK(volume_of(body) == Approx(n_cells * std::pow(lattice.spacing, dim)).epsilon(1e-12));

      std::map<Index<dim>, int> particles_in_cell;
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        {
          const Vector<dim> x = lattice.reduced(body.particles.position(p));
          Index<dim> cell;
          for (int d = 0; d < dim; ++d)
            cell[d] = static_cast<int>(std::floor(x[d]));
          ++particles_in_cell[cell];
          CHECK(shape->contains(body.particles.position(p)));
        }
      CHECK(particles_in_cell.size() == std::size_t(n_cells));
      for (const auto &cell : particles_in_cell)
        CHECK(cell.second == power(n, dim));
    }
}

TEMPLATE_TEST_CASE_SIG("every other place of a box is filled exactly",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Half as many particles of twice the volume: 4 places per edge are 32 particles a cell in 3D, and no
  // two of them are next to each other along an axis, so the nearest are next along two: for a fluid sqrt(2)
  // places apart, for a solid at the ends, where two Gauss points are 0.8611 - 0.3400 half cells apart.
  const Lattice<dim> lattice     = test_lattice<dim>();
  BodyParameters<dim> parameters = box_on_nodes(lattice);
  const int n_cells              = (dim == 3 ? 4 * 6 * 8 : 4 * 6);
  parameters.particles_per_edge  = 4;
  parameters.arrangement         = Arrangement::face_centred;
  const Body<dim> body           = seeded(parameters, lattice);
  REQUIRE(body.particles.size() == std::size_t(n_cells * power(4, dim) / 2));
  CHECK(volume_of(body) == Approx(n_cells * std::pow(lattice.spacing, dim)).epsilon(1e-12));

  const auto nearest_to_first = [](const Body<dim> &seeded_body) {
    double nearest = 1e300;
    for (std::size_t p = 1; p < seeded_body.particles.size(); ++p)
      nearest = std::min(
        nearest, norm(seeded_body.particles.position(p) - seeded_body.particles.position(0)));
    return nearest;
  };
  CHECK(nearest_to_first(body) ==
        Approx(std::sqrt(2.) * 0.5 * (0.8611363116 - 0.3399810436) * lattice.spacing));
  Body<dim> fluid = empty_body<dim>(MechanicalLaw::viscoelastic_fluid, false);
  seed_particles(parameters, lattice, 0, 0, 1, fluid);
  CHECK(nearest_to_first(fluid) == Approx(std::sqrt(2.) / 4. * lattice.spacing));
}

TEST_CASE("spheres and cylinders have their volume", "[particles]")
{
  // Volumes against the formulas: cells at the surface are cut by planes, which is right to 0.1 % at a
  // radius of 5.3 dx. Particles may lie beyond the box of the shape by a tenth of a cell.
  const Lattice<2> lattice2 = test_lattice<2>();
  const Lattice<3> lattice3 = test_lattice<3>();
  const double radius       = 0.53;
  const double length       = 0.71;
  check_volume(round_body(lattice2, ShapeType::sphere), constants::pi * radius * radius, 0.001);
  check_volume(
    round_body(lattice3, ShapeType::sphere), 4. / 3. * constants::pi * std::pow(radius, 3), 0.001);
  check_volume(
    round_body(lattice3, ShapeType::cylinder), constants::pi * radius * radius * length, 0.001);
}

TEMPLATE_TEST_CASE_SIG("a box anywhere is seeded with its moments",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Volume, centroid and second moments of boxes at 20 random places against the formulas. Parts of cells are
  // products of intervals, and 2 or more Gauss points along each axis have the moments of a part up to second
  // order, so nothing but rounding is left; the centres of sub-cells have 1 - 1/n^2 of the second moments.
  const Lattice<dim> lattice = test_lattice<dim>();
  Random random(4);
  for (int i = 0; i < 20; ++i)
    {
      BodyParameters<dim> parameters = box_on_nodes(lattice);
      for (int d = 0; d < dim; ++d)
        {
          parameters.shape.lower_corner[d] += lattice.spacing * random.between(-2., 1.);
          parameters.shape.upper_corner[d] += lattice.spacing * random.between(-1., 1.);
        }
      const VolumeMoments<dim> exact = make_shape(parameters.shape)->volume_moments();
      for (const int n : {1, 2, 3, 4})
        {
          parameters.particles_per_edge  = n;
          const VolumeMoments<dim> solid = moments_of(seeded(parameters, lattice));
          CHECK(std::abs(solid.volume / exact.volume - 1.) < 1e-12);
          CHECK(norm(solid.centroid - exact.centroid) < 1e-12 * lattice.spacing * 16.);
          if (n > 1)
            CHECK(frobenius_norm(solid.second + -1. * exact.second) <
                  1e-12 * frobenius_norm(exact.second));
          Body<dim> fluid = empty_body<dim>(MechanicalLaw::viscoelastic_fluid, false);
          seed_particles(parameters, lattice, 0, 0, 1, fluid);
          const VolumeMoments<dim> of_fluid = moments_of(fluid);
          CHECK(std::abs(of_fluid.volume / exact.volume - 1.) < 1e-12);
          CHECK(trace(of_fluid.second) < trace(exact.second));
        }
      parameters.particles_per_edge    = 4;
      parameters.arrangement           = Arrangement::face_centred;
      const VolumeMoments<dim> centred = moments_of(seeded(parameters, lattice));
      CHECK(std::abs(centred.volume / exact.volume - 1.) < 1e-12);
      for (int d = 0; d < dim; ++d)
        CHECK(centred.second(d, d) == Approx(exact.second(d, d)).epsilon(1e-12));
    }
}

TEST_CASE("full cells of solids hold particles at their Gauss points, of fluids evenly",
          "[particles]")
{
  // One cell: 2 particles an edge lie +-dx/(2 sqrt 3) from its middle, or +-dx/4, all with an eighth of it; the
  // three of a solid at 0 and +-sqrt(3/5)/2 dx, with weights of 8/18 and 5/18 along each axis.
  const Lattice<3> lattice      = test_lattice<3>();
  BodyParameters<3> parameters  = box_on_nodes(lattice);
  parameters.shape.lower_corner = lattice.node_position({5, 6, 7});
  parameters.shape.upper_corner = lattice.node_position({6, 7, 8});
  const Vector<3> middle = 0.5 * (parameters.shape.lower_corner + parameters.shape.upper_corner);
  const double full      = std::pow(lattice.spacing, 3);
  const auto check       = [&](const Body<3> &body, const double offset) {
    REQUIRE(body.particles.size() == 8);
    for (std::size_t p = 0; p < 8; ++p)
      {
        for (int d = 0; d < 3; ++d)
          CHECK(std::abs(body.particles.position(p)[d] - middle[d]) ==
                Approx(offset * lattice.spacing));
        CHECK(body.particles.component(ParticleProperty::volume, 0)[p] == Approx(full / 8.));
      }
  };
  check(seeded(parameters, lattice), 0.5 / std::sqrt(3.));
  Body<3> fluid = empty_body<3>(MechanicalLaw::viscoelastic_fluid, false);
  seed_particles(parameters, lattice, 0, 0, 1, fluid);
  check(fluid, 0.25);

  parameters.particles_per_edge = 3;
  const Body<3> three           = seeded(parameters, lattice);
  REQUIRE(three.particles.size() == 27);
  CHECK(three.particles.position(0)[0] ==
        Approx(middle[0] - 0.5 * std::sqrt(0.6) * lattice.spacing));
  CHECK(three.particles.component(ParticleProperty::volume, 0)[0] ==
        Approx(full * std::pow(5. / 18., 3)));
  CHECK(norm(three.particles.position(13) - middle) < 1e-15);
  CHECK(three.particles.component(ParticleProperty::volume, 0)[13] ==
        Approx(full * std::pow(8. / 18., 3)));
}

TEST_CASE("small parts join a neighbour, and no body vanishes", "[particles]")
{
  // Boxes that end a little beyond nodes: parts of 0.2 of a cell join the full ones behind them, so that there
  // are as many particles as without, and no lighter ones. Plates of 0.2 and of 0.04 dx have no other parts and
  // keep theirs, a crumb in the corner of eight cells its own; the volume is always that of the box.
  const Lattice<3> lattice     = test_lattice<3>();
  BodyParameters<3> parameters = box_on_nodes(lattice);
  const double dx              = lattice.spacing;
  const double particle        = dx * dx * dx / 8.;
  const auto box_from          = [&](const Vector<3> &lower, const Vector<3> &upper) {
    parameters.shape.lower_corner = lattice.lower_corner + dx * lower;
    parameters.shape.upper_corner = lattice.lower_corner + dx * upper;
    const Body<3> body            = seeded(parameters, lattice);
    const Vector<3> edges         = upper - lower;
    CHECK(volume_of(body) == Approx(dx * dx * dx * edges[0] * edges[1] * edges[2]).epsilon(1e-11));
    return body;
  };
  const auto least_volume = [](const Body<3> &body) {
    const double *volume = body.particles.component(ParticleProperty::volume, 0);
    return *std::min_element(volume, volume + body.particles.size());
  };
  const Body<3> merged = box_from({{3., 4., 5.}}, {{6.2, 7.2, 8.2}});
  CHECK(merged.particles.size() == 8 * 27);
  CHECK(least_volume(merged) == Approx(particle));
  const Body<3> large_parts = box_from({{3., 4., 5.}}, {{6.3, 7.3, 8.}});
  CHECK(large_parts.particles.size() == 8 * 3 * 15); // 0.3^2 of a cell joins
  CHECK(box_from({{3., 4., 5.4}}, {{6., 7., 5.6}}).particles.size() == 8 * 9);
  CHECK(box_from({{3., 4., 5.42}}, {{6., 7., 5.46}}).particles.size() == 8 * 9);
  const Body<3> thin = box_from({{3., 4., 4.97}}, {{6., 7., 5.15}});
  CHECK(thin.particles.size() == 8 * 9);
  CHECK(least_volume(thin) == Approx(0.18 * particle));
  CHECK(box_from({{2.97, 3.97, 4.97}}, {{3.03, 4.03, 5.03}}).particles.size() == 8 * 8);
}

TEMPLATE_TEST_CASE_SIG("no particle is seeded behind a wall or in a rigid body that touches",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A lens on the floor, and on a rigid table, by intersection of a ball and a box: where it is thin its parts are
  // wedges, below whose base the outer Gauss points of three an edge reach. They are put on it, so that none lies
  // below; without the table a few do. The volume is that of the shape.
  const Lattice<dim> lattice = test_lattice<dim>();
  const double dx            = lattice.spacing;
  BodyParameters<dim> parameters;
  parameters.name               = "lens";
  parameters.density            = 1000.;
  parameters.particles_per_edge = 3;
  parameters.shape.type         = ShapeType::intersection;
  ShapeParameters<dim> ball, box;
  ball.type            = ShapeType::sphere;
  ball.radius          = 5.37 * dx;
  box.lower_corner     = lattice.lower_corner;
  box.upper_corner     = lattice.upper_corner();
  const auto seeded_on = [&](const double height, const bool has_table) {
    const double floor        = lattice.lower_corner[dim - 1] + dx * height;
    box.lower_corner[dim - 1] = floor;
    ball.centre               = 0.5 * (lattice.lower_corner + lattice.upper_corner());
    ball.centre[dim - 1]      = floor - 4.6 * dx;
    parameters.shape.parts    = {ball, box};
    const Obstacle<dim> table = [floor](const Vector<dim> &point) {
      SurfaceDistance<dim> found = {point[dim - 1] - floor, {}};
      found.normal[dim - 1]      = 1.;
      return found;
    };
    Body<dim> body = empty_body<dim>(MechanicalLaw::neo_hookean, false);
    std::vector<Obstacle<dim>> obstacles;
    if (has_table)
      obstacles.push_back(table);
    seed_particles(parameters, lattice, 0, 0, 1, body, obstacles);
    CHECK(volume_of(body) ==
          Approx(make_shape(parameters.shape)->volume_moments().volume).epsilon(2e-3));
    const double *heights = body.particles.component(ParticleProperty::position, dim - 1);
    return *std::min_element(heights, heights + body.particles.size()) - floor;
  };
  CHECK(seeded_on(0., false) > 0.);
  CHECK(seeded_on(3.62, true) > 0.);
  CHECK(seeded_on(3.62, false) < 0.);
}

TEMPLATE_TEST_CASE_SIG("any number of ranks seeds the same particles",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The union over 2, 4 and 7 ranks of a jittered sphere against one rank: the same ids, each once,
  // with the same numbers to the last bit. Places and jitter are functions of the place alone.
  const Lattice<dim> lattice     = test_lattice<dim>();
  BodyParameters<dim> parameters = round_body(lattice, ShapeType::sphere);
  parameters.jitter              = 1.;
  const auto collect             = [&](const unsigned int n_ranks) {
    std::map<std::uint64_t, std::vector<double>> particles;
    std::size_t n = 0;
    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      {
        const Body<dim> body = seeded(parameters, lattice, rank, n_ranks);
        for (std::size_t p = 0; p < body.particles.size(); ++p)
          body.particles.append_record(p, particles[body.particles.ids()[p]]);
        n += body.particles.size();
      }
    CHECK(particles.size() == n);
    return particles;
  };
  const auto of_one_rank = collect(1);
  CHECK(of_one_rank.size() > 100);
  for (const unsigned int n_ranks : {2u, 4u, 7u})
    CHECK(collect(n_ranks) == of_one_rank);
}

TEST_CASE("ids of different bodies differ", "[particles]")
{
  // Two bodies in the same place: their ids have the number of the body above bit 40 and are
  // otherwise those of the place, so no id occurs twice.
  const Lattice<2> lattice           = test_lattice<2>();
  const BodyParameters<2> parameters = box_on_nodes(lattice);
  const Body<2> one                  = seeded(parameters, lattice, 0, 1, 0);
  const Body<2> other                = seeded(parameters, lattice, 0, 1, 1);
  std::set<std::uint64_t> ids(one.particles.ids().begin(), one.particles.ids().end());
  ids.insert(other.particles.ids().begin(), other.particles.ids().end());
  CHECK(ids.size() == one.particles.size() + other.particles.size());
}

TEMPLATE_TEST_CASE_SIG("jitter moves particles by at most half of its fraction of their spacing",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Offsets of a jittered box from the regular one, with the same ids and number. They are uniform
  // in +-jitter/2 spacings: none beyond it, some beyond 90 % of it, and the mean of N is 0 up to
  // 4 standard deviations, spacing jitter/sqrt(12 N).
  const Lattice<dim> lattice     = test_lattice<dim>();
  BodyParameters<dim> parameters = box_on_nodes(lattice);
  const Body<dim> regular        = seeded(parameters, lattice);
  parameters.jitter              = 0.6;
  const Body<dim> jittered       = seeded(parameters, lattice);
  REQUIRE(jittered.particles.ids() == regular.particles.ids());

  const double bound = 0.5 * 0.6 * 0.5 * lattice.spacing;
  double largest     = 0.;
  Vector<dim> sum;
  const std::size_t n = regular.particles.size();
  for (std::size_t p = 0; p < n; ++p)
    {
      const Vector<dim> offset = jittered.particles.position(p) - regular.particles.position(p);
      for (int d = 0; d < dim; ++d)
        largest = std::max(largest, std::abs(offset[d]));
      sum += offset;
    }
  CHECK(largest <= bound);
  CHECK(largest > 0.9 * bound);
  for (int d = 0; d < dim; ++d)
    CHECK(std::abs(sum[d]) / n < 4. * bound / std::sqrt(3. * n));
}

TEMPLATE_TEST_CASE_SIG("a spinning body moves as a rigid one",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // v = v_0 + omega x r about the middle of the body, and C = grad v, for every particle. The state
  // is undeformed and mass is density times volume, so kinetic energy is that of the rigid body.
  const Lattice<dim> lattice     = test_lattice<dim>();
  BodyParameters<dim> parameters = box_on_nodes(lattice);
  for (int d = 0; d < dim; ++d)
    parameters.velocity[d] = 1. - 0.4 * d;
  for (int c = 0; c < n_axial_components<dim>; ++c)
    parameters.angular_velocity[c] = 2. - 3. * c;
  Matrix<dim> gradient; // of omega x r
  for (int d = 0; d < dim; ++d)
    {
      Vector<dim> direction;
      direction[d]             = 1.;
      const Vector<dim> column = rotation_velocity<dim>(parameters.angular_velocity, direction);
      for (int c = 0; c < dim; ++c)
        gradient(c, d) = column[c];
    }

  const Body<dim> body     = seeded(parameters, lattice);
  const Vector<dim> centre = 0.5 * (parameters.shape.lower_corner + parameters.shape.upper_corner);
  double error             = 0.;
  for (std::size_t p = 0; p < body.particles.size(); ++p)
    {
      const ParticleSet<dim> &particles = body.particles;
      const Vector<dim> r               = particles.position(p) - centre;
      const Vector<dim> velocity        = parameters.velocity +
                                   rotation_velocity<dim>(parameters.angular_velocity, r);
      error = std::max(error, norm(particles.vector(ParticleProperty::velocity, p) - velocity));
      for (int c = 0; c < dim * dim; ++c)
        {
          const int i = c / dim, j = c % dim;
          error = std::max(error,
                           std::abs(particles.component(ParticleProperty::affine_velocity, c)[p] -
                                    gradient(i, j)));
          error = std::max(error,
                           std::abs(particles.component(ParticleProperty::deformation, c)[p] -
                                    (i == j ? 1. : 0.)));
        }
      error = std::max(error,
                       std::abs(particles.component(ParticleProperty::mass, 0)[p] -
                                1200. * particles.component(ParticleProperty::volume, 0)[p]));
    }
  CHECK(error < 1e-12);
}

TEST_CASE("a fluid is seeded with J = 1", "[particles]")
{
  // A body that stores J alone has one component of deformation, and nothing is to be written
  // beyond it. J = 1 is the undeformed state.
  const Lattice<3> lattice = test_lattice<3>();
  Body<3> body             = empty_body<3>(MechanicalLaw::viscoelastic_fluid, true);
  seed_particles(box_on_nodes(lattice), lattice, 0, 0, 1, body);
  REQUIRE(body.particles.n_components(ParticleProperty::deformation) == 1);
  const double *j = body.particles.component(ParticleProperty::deformation, 0);
  CHECK(std::all_of(j, j + body.particles.size(), [](const double value) { return value == 1.; }));
}

TEST_CASE("more particles or bodies than there are ids are refused", "[particles]")
{
  // An id is 2^40 times the number of the body and a number in it, and has to be below 2^53, where
  // doubles hold it exactly: body 8191 is the last. 2^40 places are reached by 10,300 cells along each
  // edge with 8 particles each; it takes no particle to say so.
  const Lattice<3> lattice     = test_lattice<3>();
  BodyParameters<3> parameters = box_on_nodes(lattice);
  const Body<3> last           = seeded(parameters, lattice, 0, 1, 8191);
  for (const std::uint64_t id : last.particles.ids())
    REQUIRE(static_cast<std::uint64_t>(static_cast<double>(id)) == id);
  CHECK_THROWS_WITH(seeded(parameters, lattice, 0, 1, 8192),
                    "there are more bodies than the 8192 that particles can be told apart by. Make "
                    "one body of several: a mesh may have many parts.");

  parameters.shape.lower_corner = lattice.node_position({0, 0, 0});
  parameters.shape.upper_corner = lattice.node_position({10400, 10400, 10400});
  CHECK_THROWS_WITH(
    seeded(parameters, lattice),
    "body 'box' has places for 8.99891e+12 particles; at most 2^40, 1.1e+12, can be "
    "told apart. Choose larger cells ('Box/Cell size'), or fewer particles per cell.");
}
