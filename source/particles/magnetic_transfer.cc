// Kernels, as particle_grid_transfer.cc.

#include <magmpm/base/simd_functions.h>
#include <magmpm/particles/affine_batch.h>
#include <magmpm/particles/magnetic_transfer.h>
#include <magmpm/particles/quantity_transfer.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    constexpr auto magnetic_bodies = [](const auto &body) { return body.magnetic.is_magnetic(); };

    /** What the accelerations of the nodes become on the particles of a run. */
    template <int dim>
    [[gnu::flatten]] void
    take_acceleration(const ParticleRun<dim> &run, const double *accelerations)
    {
      StencilBatch<dim> stencils;
      LinearBatch<dim> batch;
      for_each_batch(run, [&](const std::size_t first, const int n) {
        place_stencils(run, first, n, stencils);
        gather_batch(stencils, n, accelerations, [&](const int p, const auto &rows) {
          sum_linear(stencils, rows, p, batch);
        });
        batch.repeat_last(n);
        for_each_lanes(first, n, [&](const auto place, const int p) {
          const VectorAndMatrix<dim> taken = affine_motion(stencils, batch, run.spacing, p);
          store_vector<dim>(taken.vector, run.particles.magnetic_acceleration, place);
          store_matrix<dim>(taken.matrix, run.particles.magnetic_acceleration_gradient, place);
        });
      });
    }
  } // namespace

  template <int dim>
  void
  magnetic_content_to_lattice(std::vector<Body<dim>> &bodies,
                              const BlockSet<dim> &blocks,
                              const Lattice<dim> &lattice,
                              NodeField<dim, NodeContent> &content)
  {
    const double per_cell = 1. / std::pow(lattice.spacing, dim);
    scatter(
      bodies,
      blocks,
      lattice,
      magnetic_bodies,
      [per_cell](const Body<dim> &body, const auto &law) {
        return [&body, law, per_cell, particles = body.particles.arrays()](const auto place,
                                                                           auto &lanes) {
          using Law               = std::decay_t<decltype(law)>;
          const SimdDouble volume = per_cell * load(particles.volume, place);
          lanes[NodeContent::volume.lane] =
            volume * law.volume_ratio(load_state<dim, Law>(particles, place));
          lanes[NodeContent::saturation.lane]     = volume * body.magnetic.saturation_magnetization;
          lanes[NodeContent::susceptibility.lane] = volume * body.magnetic.initial_susceptibility;
          lanes[NodeContent::grains.lane]         = volume * body.magnetic.number_density;
        };
      },
      content);
  }

  template <int dim>
  void
  magnetic_mass_to_lattice(std::vector<Body<dim>> &bodies,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           NodeField<dim, SingleScalar> &mass)
  {
    scatter(
      bodies,
      blocks,
      lattice,
      magnetic_bodies,
      [](const Body<dim> &body, const auto &) {
        return [particles = body.particles.arrays()](const auto place, auto &lanes) {
          lanes[SingleScalar::value.lane] = load(particles.mass, place);
        };
      },
      mass);
  }

  template <int dim>
  void
  accelerations_to_particles(const NodeField<dim, SingleVector> &accelerations,
                             const BlockSet<dim> &blocks,
                             const Lattice<dim> &lattice,
                             std::vector<Body<dim>> &bodies)
  {
    Arena<dim> arena;
    for_each_run(
      bodies,
      blocks,
      lattice,
      magnetic_bodies,
      [&](const int slot) { arena.load(accelerations, blocks, slot); },
      [&](const std::size_t, const ParticleRun<dim> &run) { take_acceleration(run, arena.data()); },
      [](const int) {});
  }

  template <int dim>
  void
  interpolate_to_particles(const NodeField<dim, SingleVector> &field,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           const ParticleProperty quantity,
                           std::vector<Body<dim>> &bodies)
  {
    gather(
      field,
      blocks,
      lattice,
      magnetic_bodies,
      [quantity](Body<dim> &body) {
        std::array<double *, dim> components;
        for (int d = 0; d < dim; ++d)
          components[d] = body.particles.component(quantity, d);
        return [components](const std::size_t p, const NodeLanes &lanes) {
          for (int d = 0; d < dim; ++d)
            components[d][p] = lanes[d];
        };
      },
      bodies);
  }

#define INSTANTIATE(dim)                                                              \
  template void magnetic_content_to_lattice<dim>(std::vector<Body<dim>> &,            \
                                                 const BlockSet<dim> &,               \
                                                 const Lattice<dim> &,                \
                                                 NodeField<dim, NodeContent> &);      \
  template void magnetic_mass_to_lattice<dim>(std::vector<Body<dim>> &,               \
                                              const BlockSet<dim> &,                  \
                                              const Lattice<dim> &,                   \
                                              NodeField<dim, SingleScalar> &);        \
  template void accelerations_to_particles<dim>(const NodeField<dim, SingleVector> &, \
                                                const BlockSet<dim> &,                \
                                                const Lattice<dim> &,                 \
                                                std::vector<Body<dim>> &);            \
  template void interpolate_to_particles<dim>(const NodeField<dim, SingleVector> &,   \
                                              const BlockSet<dim> &,                  \
                                              const Lattice<dim> &,                   \
                                              ParticleProperty,                       \
                                              std::vector<Body<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
