// Kernels, as particle_grid_transfer.cc.

#include <magmpm/base/simd_functions.h>
#include <magmpm/particles/magnetic_transfer.h>
#include <magmpm/particles/transfer_runs.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Adds value(place) to the nodes around particles: a function of the lanes of a node. */
    template <int dim, typename Value>
    [[gnu::flatten]] void
    scatter(const Run<dim> &run, const Value &value, double *arena)
    {
      StencilBatch<dim> stencils;
      alignas(64) double numbers[batch_size][n_lanes];
      for_each_batch(run, [&](const std::size_t first, const int n) {
        place_stencils(run, first, n, stencils);
        for_each_lanes(first, n, [&](const auto place, const int p) {
          SimdDouble lanes[n_lanes] = {};
          value(place, lanes);
          store_transposed(lanes, numbers[p], n_lanes);
        });
        scatter_batch(stencils, n, arena, [&](const int p, auto &rows) {
          add_constant(stencils, NodeLanes::load(numbers[p]), p, rows);
        });
      });
    }

    template <int dim>
    [[gnu::flatten]] void
    gather_vector(const Run<dim> &run, const double *arena, double *const (&components)[dim])
    {
      StencilBatch<dim> stencils;
      for_each_batch(run, [&](const std::size_t first, const int n) {
        place_stencils(run, first, n, stencils);
        gather_batch(stencils, n, arena, [&](const int p, const auto &rows) {
          const NodeLanes sum = sum_constant(stencils, rows, p);
          for (int d = 0; d < dim; ++d)
            components[d][first + p] = sum[d];
        });
      });
    }

    /** P2G of magnetic particles: value_of(body, law) makes the function of scatter(). */
    template <int dim, typename ValueOf>
    void
    scatter_magnetic(std::vector<Body<dim>> &bodies,
                     const BlockSet<dim> &blocks,
                     const Lattice<dim> &lattice,
                     NodeField<dim> &field,
                     const ValueOf &value_of)
    {
      Arena<dim> arena;
      field.set_zero();
      for_each_run(
        bodies,
        blocks,
        lattice,
        true,
        [&](const int) { arena.set_zero(); },
        [&](const std::size_t b, const Run<dim> &run) {
          std::visit(
            [&](const auto &law) {
              scatter(
                run, value_of(bodies[b], law.template with_number<SimdDouble>()), arena.data());
            },
            bodies[b].material);
        },
        [&](const int slot) { arena.add_to(field, blocks, slot); });
    }
  } // namespace

  template <int dim>
  void
  magnetic_content_to_lattice(std::vector<Body<dim>> &bodies,
                              const BlockSet<dim> &blocks,
                              const Lattice<dim> &lattice,
                              NodeField<dim> &content)
  {
    const double per_cell = 1. / std::pow(lattice.spacing, dim);
    scatter_magnetic(
      bodies, blocks, lattice, content, [per_cell](const Body<dim> &body, const auto &law) {
        return [&body, law, per_cell, particles = body.particles.arrays()](const auto place,
                                                                           auto &lanes) {
          using Law               = std::decay_t<decltype(law)>;
          const SimdDouble volume = per_cell * load(particles.volume, place);
          lanes[0] = volume * law.volume_ratio(load_state<dim, Law>(particles, place));
          lanes[1] = volume * body.magnetic.saturation_magnetization;
          lanes[2] = volume * body.magnetic.initial_susceptibility;
          lanes[3] = volume * body.magnetic.number_density;
        };
      });
  }

  template <int dim>
  void
  magnetic_mass_to_lattice(std::vector<Body<dim>> &bodies,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           NodeField<dim> &mass)
  {
    scatter_magnetic(bodies, blocks, lattice, mass, [](const Body<dim> &body, const auto &) {
      return [particles = body.particles.arrays()](const auto place, auto &lanes) {
        lanes[3] = load(particles.mass, place);
      };
    });
  }

  template <int dim>
  void
  interpolate_to_particles(const NodeField<dim> &field,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           const ParticleProperty quantity,
                           std::vector<Body<dim>> &bodies)
  {
    Arena<dim> arena;
    for_each_run(
      bodies,
      blocks,
      lattice,
      true,
      [&](const int slot) { arena.load(field, blocks, slot); },
      [&](const std::size_t b, const Run<dim> &run) {
        double *components[dim];
        for (int d = 0; d < dim; ++d)
          components[d] = bodies[b].particles.component(quantity, d);
        gather_vector(run, arena.data(), components);
      },
      [](const int) {});
  }

#define INSTANTIATE(dim)                                                                      \
  template void magnetic_content_to_lattice<dim>(                                             \
    std::vector<Body<dim>> &, const BlockSet<dim> &, const Lattice<dim> &, NodeField<dim> &); \
  template void magnetic_mass_to_lattice<dim>(                                                \
    std::vector<Body<dim>> &, const BlockSet<dim> &, const Lattice<dim> &, NodeField<dim> &); \
  template void interpolate_to_particles<dim>(const NodeField<dim> &,                         \
                                              const BlockSet<dim> &,                          \
                                              const Lattice<dim> &,                           \
                                              ParticleProperty,                               \
                                              std::vector<Body<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
