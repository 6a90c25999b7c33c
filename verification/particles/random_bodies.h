#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_sort.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

/** Bodies whose particles are in random states: what holds for them holds for all. */
namespace magmpm::verification
{
  /** 16 cells along each edge; dx is no binary fraction and the corner is not the origin. */
  template <int dim>
  Lattice<dim>
  test_lattice()
  {
    Lattice<dim> lattice;
    lattice.spacing = 0.1;
    for (int d = 0; d < dim; ++d)
      {
        lattice.lower_corner[d] = 0.3 - 0.2 * d;
        lattice.n_cells[d]      = 16;
      }
    return lattice;
  }

  /** A body without particles; magnetic or not. */
  template <int dim>
  Body<dim>
  empty_body(const MechanicalLaw law, const bool is_magnetic, const std::string &name = "body")
  {
    BodyParameters<dim> parameters;
    parameters.name    = name;
    parameters.density = 2.;
    MaterialParameters material;
    material.law           = law;
    material.shear_modulus = 0.7;
    material.lame_lambda   = 1.1;
    material.bulk_modulus  = 1.3;
    material.viscosity     = 0.02;
    if (is_magnetic)
      material.magnetic = {5., 0.9, 3.};
    return Body<dim>(parameters, material);
  }

  class Random
  {
  public:
    explicit Random(const unsigned int seed)
      : engine(seed)
    {
    }

    /** In (lower, upper), the same on every machine. */
    double
    between(const double lower, const double upper)
    {
      return lower + (upper - lower) * (engine() + 0.5) / 4294967296.;
    }

  private:
    std::mt19937 engine;
  };

  /**
   * Adds particles between the lattice nodes @p lower and @p upper (the same in all directions), with
   * random velocity, affine velocity, deformation, mass, volume and magnetic state.
   */
  template <int dim>
  void
  add_random_particles(const Lattice<dim> &lattice,
                       const double lower,
                       const double upper,
                       const int n_particles,
                       Random &random,
                       Body<dim> &body)
  {
    ParticleSet<dim> &particles = body.particles;
    const auto fill             = [&](const ParticleProperty quantity,
                          const std::size_t p,
                          const double least,
                          const double largest) {
      for (int c = 0; c < particles.n_components(quantity); ++c)
        particles.component(quantity, c)[p] = random.between(least, largest);
    };
    for (int i = 0; i < n_particles; ++i)
      {
        const std::size_t p = particles.size();
        particles.resize(p + 1);
        particles.ids()[p] = p;
        for (int d = 0; d < dim; ++d)
          particles.component(ParticleProperty::position, d)[p] =
            lattice.lower_corner[d] + lattice.spacing * random.between(lower, upper);
        fill(ParticleProperty::velocity, p, -1., 1.);
        fill(ParticleProperty::affine_velocity, p, -3., 3.);
        fill(ParticleProperty::deformation, p, -0.2, 0.2);
        const int n_deformation = particles.n_components(ParticleProperty::deformation);
        for (int c = 0; c < n_deformation; c += dim + 1)
          particles.component(ParticleProperty::deformation, c)[p] += 1.;
        fill(ParticleProperty::mass, p, 0.5, 2.);
        fill(ParticleProperty::volume, p, 0.5, 2.);
        fill(ParticleProperty::magnetic_acceleration, p, -5., 5.);
        fill(ParticleProperty::magnetic_acceleration_gradient, p, -3., 3.);
        fill(ParticleProperty::magnetic_field, p, -5., 5.);
      }
  }

  /** A magnetic solid and a fluid that share the blocks in the middle, 200 particles each. */
  template <int dim>
  std::vector<Body<dim>>
  random_bodies(const Lattice<dim> &lattice)
  {
    Random random(dim);
    std::vector<Body<dim>> bodies;
    bodies.push_back(empty_body<dim>(MechanicalLaw::neo_hookean, true, "solid"));
    bodies.push_back(empty_body<dim>(MechanicalLaw::viscoelastic_fluid, false, "fluid"));
    add_random_particles(lattice, -0.9, 7.5, 200, random, bodies[0]);
    add_random_particles(lattice, 3., 12., 200, random, bodies[1]);
    return bodies;
  }

  /** Blocks with particles and all around them, owned by this rank. */
  template <int dim>
  BlockSet<dim>
  active_blocks(const std::vector<Body<dim>> &bodies, const Lattice<dim> &lattice)
  {
    std::set<Index<dim>> active;
    for (const Index<dim> &block : occupied_blocks(bodies, lattice).blocks)
      for (int n = 0; n < n_neighbours<dim>; ++n)
        active.insert(neighbour_block<dim>(block, n));
    return BlockSet<dim>({active.begin(), active.end()}, static_cast<int>(active.size()));
  }

  template <int dim>
  void
  sort_all(const BlockSet<dim> &blocks, const Lattice<dim> &lattice, std::vector<Body<dim>> &bodies)
  {
    for (Body<dim> &body : bodies)
      sort_into_blocks(blocks, lattice, body);
  }

  /** f(position, lanes) for all nodes of a field. */
  template <int dim, typename Function>
  void
  for_each_node(const BlockSet<dim> &blocks,
                const Lattice<dim> &lattice,
                const NodeNumbers<dim> &field,
                const Function &f)
  {
    for (int slot = 0; slot < blocks.size(); ++slot)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        f(lattice.node_position(node_of_block<dim>(blocks.block(slot), n)), field.node(slot, n));
  }
} // namespace magmpm::verification
