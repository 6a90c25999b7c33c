#include <magmpm/materials/parameter_conversion.h>
#include <magmpm/particles/seeding.h>

#include <particle_step/falling_block.h>

#include <cmath>

namespace magmpm::benchmarks
{
  namespace
  {
    constexpr int particles_per_edge = 2;

    /** A block of n_cells^3 cells in a box with two cells of air on each side. */
    FallingBlock
    falling_block(const std::string &name,
                  const double n_particles,
                  const MaterialParameters &material,
                  const double density)
    {
      const int n_cells =
        std::max(1, static_cast<int>(std::lround(std::cbrt(n_particles) / particles_per_edge)));
      FallingBlock block;
      block.name            = name;
      block.time_step       = 5e-5;
      block.lattice.spacing = 1. / 128.;
      BodyParameters<3> body;
      body.name               = name;
      body.density            = density;
      body.particles_per_edge = particles_per_edge;
      body.jitter             = 0.4; // 0.1 dx to each side
      body.velocity           = {{0., 0., -1.}};
      for (int d = 0; d < 3; ++d)
        {
          const int first            = (d == 2 ? 1 : 2);
          block.lattice.n_cells[d]   = block_edge * ((n_cells + 2 * first) / block_edge + 1);
          body.shape.lower_corner[d] = block.lattice.spacing * first;
          body.shape.upper_corner[d] = block.lattice.spacing * (first + n_cells);
        }
      block.bodies.emplace_back(body, material);
      seed_particles(body, block.lattice, 0, 0, 1, block.bodies.back());
      return block;
    }
  } // namespace

  FallingBlock
  elastic_cube(const double n_particles, const double poisson_ratio)
  {
    const LameModuli moduli = lame_moduli(1e5, poisson_ratio);
    MaterialParameters material;
    material.law           = MechanicalLaw::neo_hookean;
    material.shear_modulus = moduli.shear_modulus;
    material.lame_lambda   = moduli.lame_lambda;
    return falling_block("elastic cube", n_particles, material, 2500.);
  }

  FallingBlock
  fluid_block(const double n_particles)
  {
    MaterialParameters material;
    material.law          = MechanicalLaw::viscoelastic_fluid;
    material.bulk_modulus = 1e5;
    material.viscosity    = 1.;
    return falling_block("fluid block", n_particles, material, 1000.);
  }
} // namespace magmpm::benchmarks
