#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/magnetic_transfer.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_state.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/particles/velocity_filter.h>

#include "catch.h"

#include <baselines/plain_particles/plain_particles.h>
#include <verification/particles/random_bodies.h>

using namespace magmpm;
using namespace magmpm::baselines;
using namespace magmpm::verification;

namespace
{
  /** What the nodes or the particles carry together: {mass, momentum, angular momentum}. */
  template <int dim>
  struct Balance
  {
    double mass = 0.;
    Vector<dim> momentum;
    Vector<n_axial_components<dim>> angular_momentum;
  };

  template <int dim>
  Balance<dim>
  balance_of_nodes(const BlockSet<dim> &blocks,
                   const Lattice<dim> &lattice,
                   const NodeField<dim> &field)
  {
    Balance<dim> sum;
    for_each_node(blocks, lattice, field, [&](const Vector<dim> &position, const double *node) {
      Vector<dim> momentum;
      for (int d = 0; d < dim; ++d)
        momentum[d] = node[d];
      sum.mass += node[3];
      sum.momentum += momentum;
      sum.angular_momentum += cross(position, momentum);
    });
    return sum;
  }

  template <int dim>
  Balance<dim>
  balance_of_particles(const std::vector<Body<dim>> &bodies, const Lattice<dim> &lattice)
  {
    ParticleSums<dim> sums;
    for (const Body<dim> &body : bodies)
      sums += particle_sums(body, lattice, Vector<dim>(), MagnetizationLaw::langevin);
    return {sums.mass, sums.momentum, sums.angular_momentum};
  }

  template <int dim>
  void
  check_equal(const Balance<dim> &one, const Balance<dim> &other, const double tolerance)
  {
    CHECK(std::abs(one.mass - other.mass) < tolerance);
    CHECK(norm(one.momentum - other.momentum) < tolerance);
    CHECK(norm(one.angular_momentum - other.angular_momentum) < tolerance);
  }

  template <int dim>
  Matrix<dim>
  matrix_of(const ParticleSet<dim> &particles, const ParticleProperty quantity, const std::size_t p)
  {
    Matrix<dim> matrix;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        matrix(i, j) = particles.component(quantity, dim * i + j)[p];
    return matrix;
  }

  template <int dim>
  void
  store_state(const Matrix<dim> &state, const std::size_t p, ParticleSet<dim> &particles)
  {
    for (int c = 0; c < dim * dim; ++c)
      particles.component(ParticleProperty::deformation, c)[p] = state(c / dim, c % dim);
  }

  template <int dim>
  void
  store_state(const double state, const std::size_t p, ParticleSet<dim> &particles)
  {
    particles.component(ParticleProperty::deformation, 0)[p] = state;
  }

  /** Momenta of the nodes become velocities, with no force but those of the particles. */
  template <typename Lanes>
  void
  divide_by_mass(Lanes &lanes)
  {
    for (int d = 0; d < 3; ++d)
      lanes[d] = (lanes[3] > 0. ? lanes[d] / lanes[3] : 0.);
  }

  /** Adds what changes at @p rate over a step to a quantity of the particles. */
  template <int dim>
  void
  add_over_step(const ParticleProperty quantity,
                const ParticleProperty rate,
                const double time_step,
                ParticleSet<dim> &particles)
  {
    for (int c = 0; c < particles.n_components(rate); ++c)
      for (std::size_t p = 0; p < particles.size(); ++p)
        particles.component(quantity, c)[p] += time_step * particles.component(rate, c)[p];
  }

  /** The bodies after the impulse that their particles carry. */
  template <int dim>
  std::vector<Body<dim>>
  pushed_by_magnets(std::vector<Body<dim>> bodies, const double time_step)
  {
    using Property = ParticleProperty;
    for (Body<dim> &body : bodies)
      {
        add_over_step(
          Property::velocity, Property::magnetic_acceleration, time_step, body.particles);
        add_over_step(Property::affine_velocity,
                      Property::magnetic_acceleration_gradient,
                      time_step,
                      body.particles);
      }
    return bodies;
  }

  /** A step of the plain loops, of which the bodies become the result; returns the momenta. */
  template <int dim>
  PlainLattice<dim>
  reference_step(const Lattice<dim> &lattice,
                 const double time_step,
                 std::vector<Body<dim>> &bodies)
  {
    // The plain loops know no magnetic force.
    const std::vector<Body<dim>> pushed = pushed_by_magnets(bodies, time_step);
    PlainParticles<dim> plain(lattice, pushed);
    plain.particles_to_lattice(time_step);
    const PlainLattice<dim> momentum = plain.nodes();
    const int no_floor               = -1000;
    plain.update_lattice(time_step, 0., no_floor);
    plain.lattice_to_particles(time_step);
    plain.copy_to(bodies);
    return momentum;
  }

  /** The velocities of a lattice where all bodies have APIC. */
  template <int dim>
  LatticeVelocities<dim>
  only(const NodeField<dim> &velocity)
  {
    static const NodeField<dim> none;
    return {velocity, none, none};
  }

  /** The same step with the kernels under test; returns the momenta. */
  template <int dim>
  NodeField<dim>
  step(const BlockSet<dim> &blocks,
       const Lattice<dim> &lattice,
       const double time_step,
       std::vector<Body<dim>> &bodies)
  {
    NodeField<dim> field;
    field.reinit(blocks.size());
    particles_to_lattice(bodies, blocks, lattice, time_step, field);
    const NodeField<dim> momentum = field;
    for (int slot = 0; slot < blocks.size(); ++slot)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        {
          double *node = field.node(slot, n);
          divide_by_mass(node);
        }
    lattice_to_particles(only(field), blocks, lattice, time_step, bodies);
    return momentum;
  }

  /** Largest difference of a number of a node, also of nodes that only one of them has. */
  template <int dim>
  double
  largest_difference(const BlockSet<dim> &blocks,
                     const NodeField<dim> &field,
                     const PlainLattice<dim> &reference)
  {
    double largest     = 0.;
    const auto compare = [&largest](const double *lanes, const PlainNode<dim> &node) {
      for (int d = 0; d < dim; ++d)
        largest = std::max(largest, std::abs((lanes == nullptr ? 0. : lanes[d]) - node.motion[d]));
      largest = std::max(largest, std::abs((lanes == nullptr ? 0. : lanes[3]) - node.mass));
    };
    for (int slot = 0; slot < blocks.size(); ++slot)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        {
          const Index<dim> node = node_of_block<dim>(blocks.block(slot), n);
          compare(field.node(slot, n),
                  reference.contains(node) ? reference[reference.number(node)] : PlainNode<dim>());
        }
    for (std::size_t n = 0; n < reference.size(); ++n)
      if (blocks.slot(block_of<dim>(reference.node(n))) == invalid_slot)
        compare(nullptr, reference[n]);
    return largest;
  }

  /** Largest difference of a number that particles carry. */
  template <int dim>
  double
  largest_difference(const std::vector<Body<dim>> &bodies, const std::vector<Body<dim>> &reference)
  {
    double largest = 0.;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (int q = 0; q < n_particle_properties; ++q)
        for (int c = 0; c < bodies[b].particles.n_components(ParticleProperty(q)); ++c)
          for (std::size_t p = 0; p < bodies[b].particles.size(); ++p)
            largest =
              std::max(largest,
                       std::abs(bodies[b].particles.component(ParticleProperty(q), c)[p] -
                                reference[b].particles.component(ParticleProperty(q), c)[p]));
    return largest;
  }

  /** A vector that varies linearly, q = constant + slope x, on the nodes of all blocks. */
  template <int dim, typename Quantities>
  NodeField<dim, Quantities>
  linear_field(const NodeVector<Quantities> quantity,
               const BlockSet<dim> &blocks,
               const Lattice<dim> &lattice,
               const Vector<dim> &constant,
               const Matrix<dim> &slope)
  {
    NodeField<dim, Quantities> field(blocks.size());
    for_nodes_and_ghosts(blocks, [&](const int slot, const int n) {
      const Index<dim> node = node_of_block<dim>(blocks.block(slot), n);
      field.set(quantity, slot, n, constant + slope * lattice.node_position(node));
    });
    return field;
  }

  template <int dim>
  Vector<dim>
  some_vector()
  {
    Vector<dim> vector;
    for (int d = 0; d < dim; ++d)
      vector[d] = 0.8 - 0.5 * d;
    return vector;
  }

  template <int dim>
  Matrix<dim>
  some_matrix()
  {
    Matrix<dim> matrix;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        matrix(i, j) = 0.4 * i - 0.7 * j + 0.3 * i * j + 0.2;
    return matrix;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("P2G keeps mass, momentum and angular momentum",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Sums over the nodes against those over 400 particles in random states, the angular momentum with
  // the spin in the affine velocities. The B-splines sum to one and reproduce x, and their second
  // moment is dx^2/4, so all three are kept exactly; the numbers are of the order of 100.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  NodeField<dim> field;
  field.reinit(blocks.size());
  particles_to_lattice(bodies, blocks, lattice, 0., field);
  check_equal(
    balance_of_nodes(blocks, lattice, field), balance_of_particles(bodies, lattice), 1e-11);
}

TEMPLATE_TEST_CASE_SIG("stress keeps momentum and angular momentum, carried forces add theirs",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // P2G over a step of particles that carry magnetic accelerations, against particles that were pushed by
  // them before. Stress is an inner, symmetric action and leaves the sums alone.
  const Lattice<dim> lattice    = test_lattice<dim>();
  const double time_step        = 0.01;
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  const Balance<dim> expected = balance_of_particles(pushed_by_magnets(bodies, time_step), lattice);
  NodeField<dim> field;
  field.reinit(blocks.size());
  particles_to_lattice(bodies, blocks, lattice, time_step, field);
  check_equal(balance_of_nodes(blocks, lattice, field), expected, 1e-11);
}

TEMPLATE_TEST_CASE_SIG("G2P of a linear velocity field is exact",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // v = a + B x on the nodes, first with B = 0. Quadratic B-splines reproduce linear functions, so
  // each particle gets v = a + B x_p and C = B to rounding, moves by dt v, and deforms by I + dt B.
  const Lattice<dim> lattice = test_lattice<dim>();
  const double time_step     = 0.01;
  for (const Matrix<dim> &slope : {Matrix<dim>(), some_matrix<dim>()})
    {
      std::vector<Body<dim>> bodies = random_bodies(lattice);
      const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
      sort_all(blocks, lattice, bodies);
      const std::vector<Body<dim>> before = bodies;
      const NodeField<dim> field =
        linear_field(NodeMotion::velocity, blocks, lattice, some_vector<dim>(), slope);
      lattice_to_particles(only(field), blocks, lattice, time_step, bodies);

      std::vector<Body<dim>> expected = before;
      for (Body<dim> &body : expected)
        for (std::size_t p = 0; p < body.particles.size(); ++p)
          {
            ParticleSet<dim> &particles = body.particles;
            const Vector<dim> velocity  = some_vector<dim>() + slope * particles.position(p);
            for (int d = 0; d < dim; ++d)
              {
                particles.component(ParticleProperty::velocity, d)[p] = velocity[d];
                particles.component(ParticleProperty::position, d)[p] += time_step * velocity[d];
              }
            for (int c = 0; c < dim * dim; ++c)
              particles.component(ParticleProperty::affine_velocity, c)[p] = slope(c / dim,
                                                                                   c % dim);
            if (body.name == "solid")
              store_state((identity<dim>() + time_step * slope) *
                            matrix_of(particles, ParticleProperty::deformation, p),
                          p,
                          particles);
            else
              particles.component(ParticleProperty::deformation,
                                  0)[p] *= std::exp(time_step * trace(slope));
          }
      CHECK(largest_difference(bodies, expected) < 1e-12);
    }
}

TEMPLATE_TEST_CASE_SIG("steps equal those of a plain loop over particles and nodes",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Three steps of a solid and a fluid with stress, against loops written as the equations are, on
  // a lattice without blocks. Particles stay in the blocks of the first sort, and only the order of
  // the sums differs, which changes the last digits of numbers of the order of 10.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  std::vector<Body<dim>> reference = bodies;
  for (int i = 0; i < 3; ++i)
    {
      const NodeField<dim> momentum              = step(blocks, lattice, 1e-3, bodies);
      const PlainLattice<dim> reference_momentum = reference_step(lattice, 1e-3, reference);
      CHECK(largest_difference<dim>(blocks, momentum, reference_momentum) < 1e-11);
      CHECK(largest_difference(bodies, reference) < 1e-11);
    }
}

TEMPLATE_TEST_CASE_SIG("particles may drift by a cell between sorts",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // After the sort each particle moves by -1, 0 or 1 cell (less 1e-9) in every direction, and the
  // step must still be that of the plain loop. The arena of a block has a margin of one cell for
  // this; with less, the outermost of these particles would write beyond it.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  const double way = (1. - 1e-9) * lattice.spacing;
  int number       = 0;
  for (Body<dim> &body : bodies)
    for (std::size_t p = 0; p < body.particles.size(); ++p, ++number)
      for (int d = 0, rest = number; d < dim; ++d, rest /= 3)
        body.particles.component(ParticleProperty::position, d)[p] += way * (rest % 3 - 1);

  std::vector<Body<dim>> reference           = bodies;
  const NodeField<dim> momentum              = step(blocks, lattice, 1e-3, bodies);
  const PlainLattice<dim> reference_momentum = reference_step(lattice, 1e-3, reference);
  CHECK(largest_difference<dim>(blocks, momentum, reference_momentum) < 1e-11);
  CHECK(largest_difference(bodies, reference) < 1e-11);
}

namespace
{
  /** Random velocities on the nodes that have mass, and the masses. */
  template <int dim>
  NodeField<dim>
  random_velocities(const NodeField<dim> &mass, const BlockSet<dim> &blocks, Random &random)
  {
    NodeField<dim> field(blocks.size());
    for_nodes(blocks, [&](const int slot, const int n) {
      const double m = mass.get(NodeMotion::mass, slot, n);
      Vector<dim> velocity;
      for (int d = 0; d < dim; ++d)
        velocity[d] = random.between(-1., 1.);
      field.set(NodeMotion::mass, slot, n, m);
      if (m > 0.)
        field.set(NodeMotion::velocity, slot, n, velocity);
    });
    return field;
  }

  /** Sum over the nodes of a . b, of velocity and momentum. */
  template <int dim>
  double
  product(const NodeField<dim> &a, const NodeField<dim> &b, const BlockSet<dim> &blocks)
  {
    double sum = 0.;
    for_nodes(blocks, [&](const int slot, const int n) {
      sum += dot(a.get(NodeMotion::velocity, slot, n), b.get(NodeMotion::momentum, slot, n));
    });
    return sum;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("The filter is symmetric, damps, and keeps linear fields",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // m P = G^T m_p G, with the velocity and the affine velocity of a particle orthogonal in its kinetic
  // energy: so u . m P v = v . m P u and 0 <= v . m P v <= v . m v. B-splines reproduce linear functions, and
  // particles with C hold them, so P v = v of these. What one body alone loses has no momentum.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  NodeField<dim> mass(blocks.size());
  particles_to_lattice(bodies, blocks, lattice, 0., mass);
  const auto filtered = [&](const NodeField<dim> &velocity) {
    NodeField<dim> momentum(blocks.size());
    filter_velocity(bodies, {1., 1.}, blocks, lattice, velocity, momentum);
    return momentum;
  };

  Random random(3);
  const NodeField<dim> u = random_velocities(mass, blocks, random);
  const NodeField<dim> v = random_velocities(mass, blocks, random);
  const double uv        = product(u, filtered(v), blocks);
  CHECK(std::abs(uv) > 1e-3);
  CHECK(uv == Approx(product(v, filtered(u), blocks)).epsilon(1e-11));
  double whole = 0.;
  for_nodes(blocks, [&](const int slot, const int n) {
    whole += mass.get(NodeMotion::mass, slot, n) *
             norm_square(v.get(NodeMotion::velocity, slot, n));
  });
  const double kept = product(v, filtered(v), blocks);
  CHECK(kept > 0.);
  CHECK(kept < 0.9 * whole);

  NodeField<dim> of_one(blocks.size());
  filter_velocity(bodies, {0.7, 0.}, blocks, lattice, v, of_one);
  Vector<dim> lost;
  double size = 0.;
  for_nodes(blocks, [&](const int slot, const int n) {
    const Vector<dim> here = of_one.get(NodeMotion::mass, slot, n) *
                               v.get(NodeMotion::velocity, slot, n) -
                             of_one.get(NodeMotion::momentum, slot, n);
    lost += here;
    size += norm(here);
  });
  CHECK(size > 1.);
  CHECK(norm(lost) < 1e-12 * size);

  const NodeField<dim> line =
    linear_field(NodeMotion::velocity, blocks, lattice, some_vector<dim>(), some_matrix<dim>());
  const NodeField<dim> momentum = filtered(line);
  double largest                = 0.;
  for_nodes(blocks, [&](const int slot, const int n) {
    const double m = mass.get(NodeMotion::mass, slot, n);
    largest        = std::max(largest,
                       norm(momentum.get(NodeMotion::momentum, slot, n) -
                            m * line.get(NodeMotion::velocity, slot, n)));
  });
  CHECK(largest < 1e-11);
}

TEMPLATE_TEST_CASE_SIG("FMPM gives back what the filter takes, and moves with what it leaves",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // v, P v and what is taken are three linear fields, which G2P reproduces. A solid with FMPM takes the last
  // and moves and deforms by P v. A fluid moves by what it takes, too; a solid with APIC by v.
  const Lattice<dim> lattice = test_lattice<dim>();
  const double time_step     = 0.01;
  const Vector<dim> a        = some_vector<dim>();
  const Matrix<dim> A        = some_matrix<dim>();
  for (const Transfer transfer : {Transfer::fmpm, Transfer::apic})
    {
      std::vector<Body<dim>> bodies = random_bodies(lattice);
      bodies[0].transfer            = transfer;
      const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
      sort_all(blocks, lattice, bodies);
      std::vector<Body<dim>> expected = bodies;
      for (Body<dim> &body : expected)
        for (std::size_t p = 0; p < body.particles.size(); ++p)
          {
            ParticleSet<dim> &particles = body.particles;
            const bool is_solid         = body.name == "solid";
            const double moved          = !is_solid ? 2. : (transfer == Transfer::fmpm ? 0.5 : 1.);
            const Vector<dim> x         = particles.position(p);
            store_vector<dim>(2. * (a + A * x), particles.arrays().velocity, p);
            store_matrix<dim>(2. * A, particles.arrays().affine_velocity, p);
            store_vector<dim>(
              x + (time_step * moved) * (a + A * x), particles.arrays().position, p);
            if (is_solid)
              store_state((identity<dim>() + (time_step * moved) * A) *
                            matrix_of(particles, ParticleProperty::deformation, p),
                          p,
                          particles);
            else
              particles.component(ParticleProperty::deformation,
                                  0)[p] *= std::exp(time_step * moved * trace(A));
          }
      const NodeField<dim> v = linear_field(NodeMotion::velocity, blocks, lattice, a, A);
      const NodeField<dim> filtered =
        linear_field(NodeMotion::velocity, blocks, lattice, 0.5 * a, 0.5 * A);
      const NodeField<dim> taken =
        linear_field(NodeMotion::velocity, blocks, lattice, 2. * a, 2. * A);
      lattice_to_particles<dim>({v, filtered, taken}, blocks, lattice, time_step, bodies);
      CHECK(largest_difference(bodies, expected) < 1e-12);
    }
}

TEST_CASE("What FMPM gives back counts time", "[particles]")
{
  // alpha = exp(-2 dt c/dx): of two steps together as of one of their length. APIC gives nothing back.
  Body<2> solid  = empty_body<2>(MechanicalLaw::neo_hookean, false);
  const double c = std::sqrt((1.1 + 2. * 0.7) / 2.);
  CHECK(share_given_back(solid, 0.1, 0.01) == 0.);
  solid.transfer = Transfer::fmpm;
  CHECK(share_given_back(solid, 0.1, 0.05) == Approx(std::exp(-c)));
  CHECK(std::pow(share_given_back(solid, 0.1, 0.02), 2) ==
        Approx(share_given_back(solid, 0.1, 0.04)));
}

TEST_CASE("G2P reports the extremes of each body, and what is not a number as infinite",
          "[particles]")
{
  // A velocity field of constant gradient around an undeformed solid and a fluid with J = 1/2, 1, 3,
  // in a step of no length: v, C, J and the wave speed sqrt((lambda + 2 mu)/rho) of the solid are
  // known. A velocity that is not a number, or J <= 0, exceeds every limit, as infinity does.
  const Lattice<2> lattice    = test_lattice<2>();
  std::vector<Body<2>> bodies = {empty_body<2>(MechanicalLaw::neo_hookean, false),
                                 empty_body<2>(MechanicalLaw::viscoelastic_fluid, false)};
  Random random(7);
  for (Body<2> &body : bodies)
    add_random_particles(lattice, 1., 3., 3, random, body);
  for (int p = 0; p < 3; ++p)
    {
      store_state(identity<2>(), p, bodies[0].particles);
      store_state(p == 0 ? 0.5 : 2. * p - 1., p, bodies[1].particles);
    }
  const BlockSet<2> blocks = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);

  NodeField<2> field = linear_field<2>(
    NodeMotion::velocity, blocks, lattice, {{3., 4.}}, Matrix<2>{{{0., -2.}, {2., 0.}}});
  std::vector<Body<2>> moved = bodies;
  auto extremes              = lattice_to_particles(only(field), blocks, lattice, 0., moved);
  REQUIRE(extremes.size() == 2);
  double speed = 0.;
  for (int p = 0; p < 3; ++p)
    speed = std::max(speed, norm(moved[0].particles.vector(ParticleProperty::velocity, p)));
  CHECK(speed > 4.);
  CHECK(extremes[0].speed == Approx(speed).epsilon(1e-12));
  CHECK(extremes[0].signal_speed ==
        Approx(speed + std::sqrt((1.1 + 2. * 0.7) / 2.)).epsilon(1e-12));
  CHECK(extremes[0].affine_velocity == Approx(std::sqrt(8.)).epsilon(1e-12));
  CHECK(extremes[0].max_volume_ratio == Approx(1.).epsilon(1e-12));
  CHECK(extremes[1].max_volume_ratio == Approx(3.).epsilon(1e-12));
  CHECK(extremes[1].max_inverse_volume_ratio == Approx(2.).epsilon(1e-12));

  // Not a number on the node closest to the first particle.
  const Index<2> node = lattice.nearest_node(bodies[0].particles.position(0));
  field.node(blocks.slot(block_of<2>(node)), (node[0] & 3) + 4 * (node[1] & 3))[0] = std::nan("");
  moved                                                                            = bodies;
  extremes = lattice_to_particles(only(field), blocks, lattice, 0., moved);
  CHECK(std::isinf(extremes[0].speed));
  CHECK(std::isinf(extremes[0].signal_speed));

  field.set_zero();
  moved = bodies;
  store_state(Matrix<2>{{{-1., 0.}, {0., 1.}}}, 1, moved[0].particles);
  extremes = lattice_to_particles(only(field), blocks, lattice, 0., moved);
  CHECK(std::isinf(extremes[0].max_inverse_volume_ratio));
  CHECK(extremes[0].max_volume_ratio == Approx(1.));
}

TEMPLATE_TEST_CASE_SIG("the magnetic content of the nodes is that of the magnetic particles",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Sums over the nodes times dx^dim against sum J V_0, and V_0 M_s, V_0 chi_0, V_0 n. The B-splines
  // sum to one, grains are not diluted by J since the lanes are per undeformed volume, and the fluid,
  // which is not magnetic, must not count.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  NodeField<dim, NodeContent> content(blocks.size());
  magnetic_content_to_lattice(bodies, blocks, lattice, content);

  const auto sum = [&](const NodeScalar<NodeContent> quantity) {
    double result = 0.;
    for_nodes_and_ghosts(blocks, [&](const int slot, const int n) {
      result += std::pow(lattice.spacing, dim) * content.get(quantity, slot, n);
    });
    return result;
  };
  double volume = 0., undeformed_volume = 0.;
  const ParticleSet<dim> &particles = bodies[0].particles;
  for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const double v0 = particles.component(ParticleProperty::volume, 0)[p];
      undeformed_volume += v0;
      volume += v0 * determinant(matrix_of(particles, ParticleProperty::deformation, p));
    }
  CHECK(sum(NodeContent::volume) == Approx(volume).epsilon(1e-12));
  CHECK(sum(NodeContent::saturation) == Approx(undeformed_volume * 5.).epsilon(1e-12));
  CHECK(sum(NodeContent::susceptibility) == Approx(undeformed_volume * 0.9).epsilon(1e-12));
  CHECK(sum(NodeContent::grains) == Approx(undeformed_volume * 3.).epsilon(1e-12));
}

TEMPLATE_TEST_CASE_SIG("magnetic particles take a linear field from the nodes exactly",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // H = a + B x on the nodes becomes H(x_p) on the particles, since quadratic B-splines reproduce
  // linear functions. Nothing else of the particles may change, nor any particle of a body that is
  // not magnetic.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  std::vector<Body<dim>> expected = bodies;
  for (std::size_t p = 0; p < expected[0].particles.size(); ++p)
    {
      const Vector<dim> value = some_vector<dim>() +
                                some_matrix<dim>() * expected[0].particles.position(p);
      for (int d = 0; d < dim; ++d)
        expected[0].particles.component(ParticleProperty::magnetic_field, d)[p] = value[d];
    }
  interpolate_to_particles(
    linear_field(SingleVector::value, blocks, lattice, some_vector<dim>(), some_matrix<dim>()),
    blocks,
    lattice,
    ParticleProperty::magnetic_field,
    bodies);
  CHECK(largest_difference(bodies, expected) < 1e-13);
}

TEMPLATE_TEST_CASE_SIG("magnetic particles give back sum and first moments of a force on nodes",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Particles take accelerations f_i/m_i of the nodes, a different one for each, and P2G makes momentum of them.
  // sum f_i and sum f_i x_i^T are kept for any f_i, since the affine part holds what the mean of a
  // particle's nodes loses: with D = dx^2/4 both sides are sum_p m_p sum_i N_ip a_i x_i^T.
  const Lattice<dim> lattice    = test_lattice<dim>();
  const double time_step        = 0.01;
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  constexpr auto vector = SingleVector::value;
  NodeField<dim, SingleScalar> masses(blocks.size());
  magnetic_mass_to_lattice(bodies, blocks, lattice, masses);

  Random random(11);
  NodeField<dim, SingleVector> accelerations(blocks.size());
  NodeField<dim> before(blocks.size()), after(blocks.size());
  for (const double factor : {0., 1.})
    {
      random = Random(11);
      for_nodes(blocks, [&](const int slot, const int n) {
        Vector<dim> a;
        for (int d = 0; d < dim; ++d)
          a[d] = factor * random.between(-5., 5.);
        accelerations.set(vector, slot, n, a);
      });
      accelerations_to_particles(accelerations, blocks, lattice, bodies);
      particles_to_lattice(bodies, blocks, lattice, time_step, factor == 0. ? before : after);
    }

  Matrix<dim> moment, expected_moment;
  Vector<dim> force, expected_force;
  for_nodes(blocks, [&](const int slot, const int n) {
    const Vector<dim> x = lattice.node_position(node_of_block<dim>(blocks.block(slot), n));
    const Vector<dim> f = masses.get(SingleScalar::value, slot, n) *
                          accelerations.get(vector, slot, n);
    const Vector<dim> given = (1. / time_step) * (after.get(NodeMotion::momentum, slot, n) -
                                                  before.get(NodeMotion::momentum, slot, n));
    expected_force += f;
    force += given;
    expected_moment += outer(f, x);
    moment += outer(given, x);
  });
  CHECK(norm(expected_force) > 1.);
  CHECK(norm(force - expected_force) < 1e-10);
  CHECK(frobenius_norm(moment + (-1.) * expected_moment) < 1e-10);
}
