// Kernels: raw pointers and ranges only, nothing of MPI or deal.II (design: the unit of work is a
// block, so that the same bodies can become blocks of a GPU).

#include <magmpm/base/prefetch.h>
#include <magmpm/base/simd_functions.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/transfer_runs.h>

#include <algorithm>
#include <limits>

namespace magmpm
{
  namespace
  {
    constexpr auto all_bodies = [](const auto &) { return true; };

    template <int n_components, int batch>
    inline void
    add_arrays(double *const (&components)[n_components],
               const std::size_t first,
               Prefetch<batch> &prefetch)
    {
      for (const double *component : components)
        if (component != nullptr)
          prefetch.add(component + first);
    }

    /** Mass and momentum of the particles at @p place, number @p p of the batch, for P2G. */
    template <int dim, typename Law, typename Place>
    inline void
    momentum_of_particles(const ParticleRun<dim> &run,
                          const StencilBatch<dim> &stencils,
                          const Law &law,
                          const double time_step,
                          const Place place,
                          const int p,
                          LinearBatch<dim> &batch)
    {
      const auto &particles                = run.particles;
      const double dx                      = run.spacing;
      const Matrix<dim, SimdDouble> affine = load_matrix<dim>(particles.affine_velocity, place);
      const Matrix<dim, SimdDouble> stress =
        law.kirchhoff_stress(load_state<dim, Law>(particles, place), affine);
      const SimdDouble mass            = load(particles.mass, place);
      const SimdDouble affine_factor   = dx * mass;
      const SimdDouble stress_factor   = (-time_step * 4. / dx) * load(particles.volume, place);
      Vector<dim, SimdDouble> velocity = load_vector<dim>(particles.velocity, place);
      if (particles.magnetic_acceleration[0] != nullptr)
        velocity += time_step * load_vector<dim>(particles.magnetic_acceleration, place);

      constexpr int stride      = LinearBatch<dim>::stride;
      SimdDouble first[n_lanes] = {};
      for (int c = 0; c < dim; ++c)
        first[c] = mass * velocity[c];
      for (int d = 0; d < dim; ++d)
        {
          const SimdDouble offset  = SimdDouble::load(&stencils.offsets[d][p]);
          SimdDouble step[n_lanes] = {};
          for (int c = 0; c < dim; ++c)
            {
              step[c] = affine_factor * affine(c, d) + stress_factor * stress(c, d);
              first[c] -= offset * step[c];
            }
          store_transposed(step, batch.numbers[p][1 + d], stride);
        }
      first[3] = mass;
      store_transposed(first, batch.numbers[p][0], stride);
    }

    template <int dim, typename Law>
    [[gnu::flatten]] void
    scatter_momentum(const ParticleRun<dim> &run,
                     const Law &law,
                     const double time_step,
                     double *arena)
    {
      StencilBatch<dim> stencils;
      LinearBatch<dim> batch;
      const auto &particles = run.particles;
      for_each_batch(run, [&](const std::size_t first, const int n) {
        place_stencils(run, first, n, stencils);
        for_each_lanes(first, n, [&](const auto place, const int p) {
          momentum_of_particles(run, stencils, law, time_step, place, p, batch);
        });
        Prefetch<batch_size> next;
        add_arrays(particles.position, first + batch_size, next);
        add_arrays(particles.velocity, first + batch_size, next);
        add_arrays(particles.affine_velocity, first + batch_size, next);
        add_arrays(particles.deformation, first + batch_size, next);
        add_arrays(particles.magnetic_acceleration, first + batch_size, next);
        next.add(particles.mass + first + batch_size);
        next.add(particles.volume + first + batch_size);
        next.finish();
        scatter_batch(stencils, n, arena, [&](const int p, auto &rows) {
          next.template ask<false>(p);
          add_linear(stencils, batch, p, rows);
        });
      });
    }

    /** ParticleExtremes lane by lane. */
    struct LaneExtremes
    {
      SimdDouble speed = 0., signal_speed = 0., affine_velocity = 0., max_volume_ratio = 0.,
                 max_inverse_volume_ratio = 0.;

      /** A value that is not a number counts as infinite. */
      static void
      raise(SimdDouble &largest, const SimdDouble &value)
      {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        largest                   = SimdDouble::select(
          value <= largest, largest, SimdDouble::select(value > largest, value, infinity));
      }

      void
      add_to(ParticleExtremes &extremes) const
      {
        for (int lane = 0; lane < SimdDouble::n_lanes; ++lane)
          {
            extremes.speed            = std::max(extremes.speed, speed[lane]);
            extremes.signal_speed     = std::max(extremes.signal_speed, signal_speed[lane]);
            extremes.affine_velocity  = std::max(extremes.affine_velocity, affine_velocity[lane]);
            extremes.max_volume_ratio = std::max(extremes.max_volume_ratio, max_volume_ratio[lane]);
            extremes.max_inverse_volume_ratio = std::max(extremes.max_inverse_volume_ratio,
                                                         max_inverse_volume_ratio[lane]);
          }
      }
    };

    /**
     * Moves and deforms the particles at @p place, number @p p of the batch, over a step, with what
     * G2P found on their nodes.
     */
    template <int dim, typename Law, typename Place>
    inline void
    advance_particles(const ParticleRun<dim> &run,
                      const StencilBatch<dim> &stencils,
                      const LinearBatch<dim> &batch,
                      const Law &law,
                      const double time_step,
                      const Place place,
                      const int p,
                      LaneExtremes &extremes)
    {
      const auto &particles = run.particles;
      constexpr int stride  = LinearBatch<dim>::stride;
      SimdDouble sum[n_lanes];
      load_transposed(batch.numbers[p][0], stride, sum);
      Vector<dim, SimdDouble> velocity;
      for (int c = 0; c < dim; ++c)
        velocity[c] = sum[c];
      Matrix<dim, SimdDouble> affine;
      for (int d = 0; d < dim; ++d)
        {
          const SimdDouble offset = SimdDouble::load(&stencils.offsets[d][p]);
          SimdDouble moment[n_lanes];
          load_transposed(batch.numbers[p][1 + d], stride, moment);
          for (int c = 0; c < dim; ++c)
            affine(c, d) = (4. / run.spacing) * (moment[c] - offset * velocity[c]);
        }
      const typename Law::State state =
        law.advanced(load_state<dim, Law>(particles, place), affine, time_step);
      store_vector<dim>(load_vector<dim>(particles.position, place) + time_step * velocity,
                        particles.position,
                        place);
      store_vector<dim>(velocity, particles.velocity, place);
      store_matrix<dim>(affine, particles.affine_velocity, place);
      store_state<dim, Law>(state, particles, place);

      const SimdDouble speed        = norm(velocity);
      const SimdDouble volume_ratio = law.volume_ratio(state);
      LaneExtremes::raise(extremes.speed, speed);
      LaneExtremes::raise(extremes.signal_speed, speed + law.wave_speed(state));
      LaneExtremes::raise(extremes.affine_velocity, frobenius_norm(affine));
      LaneExtremes::raise(extremes.max_volume_ratio, volume_ratio);
      LaneExtremes::raise(extremes.max_inverse_volume_ratio,
                          SimdDouble::select(volume_ratio > 0.,
                                             1. / volume_ratio,
                                             std::numeric_limits<double>::infinity()));
    }

    template <int dim, typename Law>
    [[gnu::flatten]] void
    gather_velocity(const ParticleRun<dim> &run,
                    const Law &law,
                    const double time_step,
                    const double *arena,
                    ParticleExtremes &extremes)
    {
      StencilBatch<dim> stencils;
      LinearBatch<dim> batch;
      LaneExtremes lane_extremes;
      const auto &particles = run.particles;
      for_each_batch(run, [&](const std::size_t first, const int n) {
        place_stencils(run, first, n, stencils);
        Prefetch<batch_size> soon;
        add_arrays(particles.position, first + batch_size, soon);
        add_arrays(particles.velocity, first, soon);
        add_arrays(particles.affine_velocity, first, soon);
        add_arrays(particles.deformation, first, soon);
        soon.finish();
        gather_batch(stencils, n, arena, [&](const int p, const auto &rows) {
          soon.template ask<true>(p);
          sum_linear(stencils, rows, p, batch);
        });
        batch.repeat_last(n);
        for_each_lanes(first, n, [&](const auto place, const int p) {
          advance_particles(run, stencils, batch, law, time_step, place, p, lane_extremes);
        });
      });
      lane_extremes.add_to(extremes);
    }
  } // namespace

  template <int dim>
  void
  particles_to_lattice(std::vector<Body<dim>> &bodies,
                       const BlockSet<dim> &blocks,
                       const Lattice<dim> &lattice,
                       const double time_step,
                       NodeField<dim> &field)
  {
    Arena<dim> arena;
    field.set_zero();
    for_each_run(
      bodies,
      blocks,
      lattice,
      all_bodies,
      [&](const int) { arena.set_zero(); },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        std::visit(
          [&](const auto &law) {
            scatter_momentum(run, law.template with_number<SimdDouble>(), time_step, arena.data());
          },
          bodies[b].material);
      },
      [&](const int slot) { arena.add_to(field, blocks, slot); });
  }

  template <int dim>
  std::vector<ParticleExtremes>
  lattice_to_particles(const NodeField<dim> &field,
                       const BlockSet<dim> &blocks,
                       const Lattice<dim> &lattice,
                       const double time_step,
                       std::vector<Body<dim>> &bodies)
  {
    std::vector<ParticleExtremes> extremes(bodies.size());
    Arena<dim> arena;
    for_each_run(
      bodies,
      blocks,
      lattice,
      all_bodies,
      [&](const int slot) { arena.load(field, blocks, slot); },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        std::visit(
          [&](const auto &law) {
            gather_velocity(
              run, law.template with_number<SimdDouble>(), time_step, arena.data(), extremes[b]);
          },
          bodies[b].material);
      },
      [](const int) {});
    return extremes;
  }

#define INSTANTIATE(dim)                                                                   \
  template void particles_to_lattice<dim>(std::vector<Body<dim>> &,                        \
                                          const BlockSet<dim> &,                           \
                                          const Lattice<dim> &,                            \
                                          double,                                          \
                                          NodeField<dim> &);                               \
  template std::vector<ParticleExtremes> lattice_to_particles<dim>(const NodeField<dim> &, \
                                                                   const BlockSet<dim> &,  \
                                                                   const Lattice<dim> &,   \
                                                                   double,                 \
                                                                   std::vector<Body<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
