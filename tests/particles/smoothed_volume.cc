// What nearly incompressible solids make of their volume ratios, against what holds for every state.

#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_state.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/particles/smoothed_volume.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

#include <map>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  template <int dim>
  Body<dim>
  solid(const double shear_modulus, const double lame_lambda)
  {
    BodyParameters<dim> body;
    body.density = 2.;
    MaterialParameters material;
    material.shear_modulus = shear_modulus;
    material.lame_lambda   = lame_lambda;
    return Body<dim>(body, material);
  }

  /** Two bodies of one material and one of another in the same cells, and one that is not smoothed. */
  template <int dim>
  std::vector<Body<dim>>
  mixed_bodies(const Lattice<dim> &lattice)
  {
    Random random(dim);
    std::vector<Body<dim>> bodies = {
      solid<dim>(1., 49.), solid<dim>(1., 49.), solid<dim>(0.5, 30.), solid<dim>(1., 9.)};
    for (Body<dim> &body : bodies)
      add_random_particles(lattice, 1., 7.5, 150, random, body);
    return bodies;
  }

  /** All that a rank of its own does. */
  template <int dim>
  void
  smooth(const BlockSet<dim> &blocks, const Lattice<dim> &lattice, std::vector<Body<dim>> &bodies)
  {
    NodeField<dim, NodeStrain> strain(blocks.size());
    for (const SmoothedMaterial &material : smoothed_materials(bodies))
      {
        sum_strain(bodies, material, blocks, lattice, strain);
        divide_by_weight(blocks, strain);
        find_volumetric_stress(strain, material, blocks, lattice, bodies);
      }
  }

  /** kappa; written out here, of the bodies above [Pa]. */
  template <int dim>
  double
  kappa(const Body<dim> &body)
  {
    const auto &law = std::get<NeoHookean<dim>>(body.material);
    return law.lame_lambda > 9.5 * law.shear_modulus ? law.lame_lambda - 9. * law.shear_modulus
                                                     : 0.;
  }

  template <int dim>
  double
  log_volume_ratio(const Body<dim> &body, const std::size_t p)
  {
    return std::log(determinant(load_matrix<dim>(body.particles.arrays().deformation, p)));
  }

  /** Gives a particle a volume ratio of e^@p strain. */
  template <int dim>
  void
  set_log_volume_ratio(const double strain, const std::size_t p, Body<dim> &body)
  {
    store_matrix<dim>(
      std::exp(strain / dim) * identity<dim>(), body.particles.arrays().deformation, p);
  }

  /** f(cell, weight) for the cells whose hats reach a point: linear between their centres. */
  template <int dim, typename Function>
  void
  for_hats(const Lattice<dim> &lattice, const Vector<dim> &position, const Function &f)
  {
    for (int k = 0; k < power(2, dim); ++k)
      {
        Index<dim> cell;
        double weight = 1.;
        for (int d = 0; d < dim; ++d)
          {
            const double x = (position[d] - lattice.lower_corner[d]) / lattice.spacing - 0.5;
            cell[d]        = static_cast<int>(std::floor(x)) + (k >> d & 1);
            weight *= 1. - std::abs(x - cell[d]);
          }
        f(cell, weight);
      }
  }

  /** The volumetric stress of a body's particles, among the bodies with its moduli, by plain loops. */
  template <int dim>
  std::vector<double>
  plain_volumetric_stress(const Lattice<dim> &lattice,
                          const std::vector<Body<dim>> &bodies,
                          const Body<dim> &body)
  {
    std::map<Index<dim>, std::pair<double, double>> sums;
    for (const Body<dim> &other : bodies)
      if (kappa(other) == kappa(body))
        for (std::size_t p = 0; p < other.particles.size(); ++p)
          for_hats(lattice, other.particles.position(p), [&](const auto &cell, const double h) {
            const double volume = h * other.particles.component(ParticleProperty::volume, 0)[p];
            sums[cell].first += volume * log_volume_ratio(other, p);
            sums[cell].second += volume;
          });
    const auto &law = std::get<NeoHookean<dim>>(body.material);
    std::vector<double> stress;
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      {
        double mean = 0.;
        for_hats(lattice, body.particles.position(p), [&](const auto &cell, const double h) {
          if (sums[cell].second > 0.)
            mean += h * sums[cell].first / sums[cell].second;
        });
        stress.push_back(kappa(body) * mean + 9. * law.shear_modulus * log_volume_ratio(body, p));
      }
    return stress;
  }

  template <int dim>
  double
  volumetric_stress(const Body<dim> &body, const std::size_t p)
  {
    return body.particles.component(ParticleProperty::volumetric_stress, 0)[p];
  }

  template <int dim>
  double
  elastic_energy(const std::vector<Body<dim>> &bodies, const Lattice<dim> &lattice)
  {
    double energy = 0.;
    for (const Body<dim> &body : bodies)
      energy += particle_sums(body, lattice, {}, MagnetizationLaw::linear).elastic_energy;
    return energy;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("smoothing equals plain loops over particles and cells",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Four bodies in the same cells, also after each particle drifted by up to a cell since it was sorted.
  // Only the order of sums differs, of stresses of the order of 10. The body with lambda = 9 mu has none.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = mixed_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  CHECK(bodies[3].particles.n_components(ParticleProperty::volumetric_stress) == 0);
  CHECK(smoothed_materials(bodies).size() == 2);
  for (const double way : {0., 1. - 1e-9})
    {
      int number = 0;
      for (Body<dim> &body : bodies)
        for (std::size_t p = 0; p < body.particles.size(); ++p, ++number)
          for (int d = 0, rest = number; d < dim; ++d, rest /= 3)
            body.particles.component(ParticleProperty::position, d)[p] += way * lattice.spacing *
                                                                          (rest % 3 - 1);
      smooth(blocks, lattice, bodies);
      for (int b = 0; b < 3; ++b)
        {
          const std::vector<double> plain = plain_volumetric_stress(lattice, bodies, bodies[b]);
          double largest = 0., largest_difference = 0.;
          for (std::size_t p = 0; p < plain.size(); ++p)
            {
              largest            = std::max(largest, std::abs(plain[p]));
              largest_difference = std::max(largest_difference,
                                            std::abs(plain[p] - volumetric_stress(bodies[b], p)));
            }
          CHECK(largest > 2.);
          CHECK(largest_difference < 1e-10);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("smoothing leaves a constant volume ratio and a lone particle alone",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Means of equal numbers are that number, and hats add up to one at each point; of one particle all
  // means are its own. So it is lambda ln J, 49 times 0.3, to rounding.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = {solid<dim>(1., 49.)};
  Random random(dim);
  add_random_particles(lattice, 1., 7.5, 200, random, bodies[0]);
  for (std::size_t p = 0; p < 200; ++p)
    set_log_volume_ratio(0.3, p, bodies[0]);
  add_random_particles(lattice, 12., 12.9, 1, random, bodies[0]);
  const BlockSet<dim> blocks = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  smooth(blocks, lattice, bodies);
  for (std::size_t p = 0; p < bodies[0].particles.size(); ++p)
    CHECK(std::abs(volumetric_stress(bodies[0], p) - 49. * log_volume_ratio(bodies[0], p)) <
          1e-13 * 49.);
}

TEMPLATE_TEST_CASE_SIG("smoothing is symmetric in the product of V kappa",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // sum_p V a (S b) = sum_p V b (S a) for two random fields ln J = a and b, and 0 <= S <= 1:
  // sum V a (S a) lies between 0 and sum V a^2. Were it not so, the stress would have no energy.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = {solid<dim>(1., 49.)};
  Random random(dim);
  add_random_particles(lattice, 1., 7.5, 300, random, bodies[0]);
  const BlockSet<dim> blocks = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  const std::size_t n = bodies[0].particles.size();
  std::vector<double> fields[2], smoothed[2];
  for (int f = 0; f < 2; ++f)
    {
      for (std::size_t p = 0; p < n; ++p)
        {
          fields[f].push_back(random.between(-0.5, 0.5));
          set_log_volume_ratio(fields[f][p], p, bodies[0]);
        }
      smooth(blocks, lattice, bodies);
      for (std::size_t p = 0; p < n; ++p)
        smoothed[f].push_back((volumetric_stress(bodies[0], p) - 9. * fields[f][p]) / 40.);
    }
  const double *volume = bodies[0].particles.component(ParticleProperty::volume, 0);
  const auto product   = [&](const std::vector<double> &a, const std::vector<double> &b) {
    double sum = 0.;
    for (std::size_t p = 0; p < n; ++p)
      sum += volume[p] * a[p] * b[p];
    return sum;
  };
  const double square = product(fields[0], fields[0]);
  CHECK(std::abs(product(fields[0], smoothed[1]) - product(fields[1], smoothed[0])) <
        1e-12 * square);
  CHECK(product(fields[0], smoothed[0]) > 0.02 * square);
  CHECK(product(fields[0], smoothed[0]) < 0.9 * square);
}

TEMPLATE_TEST_CASE_SIG("the force of smoothed stress is the slope of the smoothed energy",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Nodes move by eps u, particles deform by I + eps grad u with their hats at rest: the energy of
  // particle_sums() grows by -eps sum_i f_i u_i, f the force that P2G gives to the nodes. The central
  // difference is right to eps^2, and its rounding to 1e-15/eps; forces times u are of the order of 100.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = mixed_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  for (Body<dim> &body : bodies)
    for (const ParticleProperty motion :
         {ParticleProperty::velocity, ParticleProperty::affine_velocity})
      for (int c = 0; c < body.particles.n_components(motion); ++c)
        std::fill_n(body.particles.component(motion, c), body.particles.size(), 0.);

  Random random(7);
  NodeField<dim> force(blocks.size()), shift(blocks.size());
  smooth(blocks, lattice, bodies);
  particles_to_lattice(bodies, blocks, lattice, 1., force);
  double work = 0.;
  for (int slot = 0; slot < blocks.size(); ++slot)
    for (int n = 0; n < nodes_per_block<dim>; ++n)
      for (int d = 0; d < dim; ++d)
        {
          shift.node(slot, n)[d] = random.between(-0.1, 0.1);
          work += shift.node(slot, n)[d] * force.node(slot, n)[d];
        }

  const double eps        = 1e-5;
  const auto energy_after = [&](const double step) {
    std::vector<Body<dim>> moved = bodies;
    const NodeField<dim> none;
    lattice_to_particles<dim>({shift, none, none}, blocks, lattice, step, moved);
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (int d = 0; d < dim; ++d)
        std::copy_n(bodies[b].particles.component(ParticleProperty::position, d),
                    bodies[b].particles.size(),
                    moved[b].particles.component(ParticleProperty::position, d));
    smooth(blocks, lattice, moved);
    return elastic_energy(moved, lattice);
  };
  const double slope = (energy_after(eps) - energy_after(-eps)) / (2. * eps);
  CHECK(std::abs(work) > 10.);
  CHECK(slope == Approx(-work).epsilon(1e-6));
}
