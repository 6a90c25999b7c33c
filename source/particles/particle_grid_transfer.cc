// Kernels: raw pointers and ranges only, nothing of MPI or deal.II (design: the unit of work is a
// block, so that the same bodies can become blocks of a GPU).

#include <magmpm/base/simd_functions.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_state.h>
#include <magmpm/particles/transfer_batch.h>

#include <algorithm>
#include <limits>

namespace magmpm
{
  namespace
  {
    /** One run of particles: the kernels below work on it. */
    template <int dim>
    struct Run
    {
      ParticleArrays<dim> particles;
      std::size_t begin, end;
      StencilsOfBlock<dim> stencils;
      double spacing;
    };

    /** Calls f(first particle, n) for the batches of a run. */
    template <int dim, typename Function>
    inline void
    for_each_batch(const Run<dim> &run, const Function &f)
    {
      for (std::size_t first = run.begin; first < run.end; first += batch_size)
        f(first, static_cast<int>(std::min<std::size_t>(batch_size, run.end - first)));
    }

    /** Calls f(place of the particles, number in the batch) for @p n particles from @p first on. */
    template <typename Function>
    inline void
    for_each_lanes(const std::size_t first, const int n, const Function &f)
    {
      constexpr int width = SimdDouble::n_lanes;
      int p               = 0;
      for (; p + width <= n; p += width)
        f(FullLanes{first + p}, p);
      if (p < n)
        f(PartialLanes{first + p, n - p}, p);
    }

    template <int dim>
    inline void
    place_stencils(const Run<dim> &run,
                   const std::size_t first,
                   const int n,
                   StencilBatch<dim> &stencils)
    {
      for_each_lanes(first, n, [&](const auto place, const int p) {
        run.stencils.place(load_vector<dim>(run.particles.position, place), p, stencils);
      });
    }

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

    /** Mass and momentum of particles, with their slopes times dx, as P2G gives them to the nodes. */
    template <int dim, typename Law, typename Place>
    inline void
    momentum_of_particles(const ParticleArrays<dim> &particles,
                          const Law &law,
                          const double time_step,
                          const double spacing,
                          const Place place,
                          double *numbers)
    {
      const Matrix<dim, SimdDouble> affine = load_matrix<dim>(particles.affine_velocity, place);
      const Matrix<dim, SimdDouble> stress =
        law.kirchhoff_stress(load_state<dim, Law>(particles, place), affine);
      const SimdDouble mass          = load(particles.mass, place);
      const SimdDouble affine_factor = spacing * mass;
      const SimdDouble stress_factor = (-time_step * 4. / spacing) * load(particles.volume, place);
      Vector<dim, SimdDouble> velocity = load_vector<dim>(particles.velocity, place);
      if (particles.magnetic_acceleration[0] != nullptr)
        velocity += time_step * load_vector<dim>(particles.magnetic_acceleration, place);

      SimdDouble value[n_lanes] = {};
      for (int d = 0; d < dim; ++d)
        value[d] = mass * velocity[d];
      value[3] = mass;
      store_transposed(value, numbers, LinearBatch<dim>::stride);
      for (int d = 0; d < dim; ++d)
        {
          SimdDouble slope[n_lanes] = {};
          for (int c = 0; c < dim; ++c)
            slope[c] = affine_factor * affine(c, d) + stress_factor * stress(c, d);
          store_transposed(slope, numbers + (1 + d) * n_lanes, LinearBatch<dim>::stride);
        }
    }

    template <int dim, typename Law>
    [[gnu::flatten]] void
    scatter_momentum(const Run<dim> &run, const Law &law, const double time_step, double *arena)
    {
      StencilBatch<dim> stencils;
      LinearBatch<dim> batch;
      const auto &particles = run.particles;
      for_each_batch(run, [&](const std::size_t first, const int n) {
        place_stencils(run, first, n, stencils);
        for_each_lanes(first, n, [&](const auto place, const int p) {
          momentum_of_particles(
            particles, law, time_step, run.spacing, place, &batch.numbers[p][0][0]);
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

    /** Moves and deforms particles over a step, from what G2P found on their nodes. */
    template <int dim, typename Law, typename Place>
    inline void
    advance_particles(const ParticleArrays<dim> &particles,
                      const Law &law,
                      const double time_step,
                      const double spacing,
                      const Place place,
                      const double *numbers,
                      LaneExtremes &extremes)
    {
      Vector<dim, SimdDouble> velocity;
      Matrix<dim, SimdDouble> affine;
      SimdDouble lanes[n_lanes];
      load_transposed(numbers, LinearBatch<dim>::stride, lanes);
      for (int c = 0; c < dim; ++c)
        velocity[c] = lanes[c];
#pragma GCC unroll 3
      for (int d = 0; d < dim; ++d)
        {
          load_transposed(numbers + (1 + d) * n_lanes, LinearBatch<dim>::stride, lanes);
          for (int c = 0; c < dim; ++c)
            affine(c, d) = (4. / spacing) * lanes[c];
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
      extremes.raise(extremes.speed, speed);
      extremes.raise(extremes.signal_speed, speed + law.wave_speed(state));
      extremes.raise(extremes.affine_velocity, frobenius_norm(affine));
      extremes.raise(extremes.max_volume_ratio, volume_ratio);
      extremes.raise(extremes.max_inverse_volume_ratio,
                     SimdDouble::select(volume_ratio > 0.,
                                        1. / volume_ratio,
                                        std::numeric_limits<double>::infinity()));
    }

    template <int dim, typename Law>
    [[gnu::flatten]] void
    gather_velocity(const Run<dim> &run,
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
        for_each_lanes(first, n, [&](const auto place, const int p) {
          advance_particles(
            particles, law, time_step, run.spacing, place, &batch.numbers[p][0][0], lane_extremes);
        });
      });
      lane_extremes.add_to(extremes);
    }

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

    /** The run of @p body in the block of @p slot. */
    template <int dim>
    Run<dim>
    run_of(Body<dim> &body,
           const BlockSet<dim> &blocks,
           const Lattice<dim> &lattice,
           const int slot)
    {
      return {body.particles.arrays(),
              body.run_begin[slot],
              body.run_begin[slot + 1],
              StencilsOfBlock<dim>(lattice, blocks.block(slot)),
              lattice.spacing};
    }

    template <int dim>
    bool
    is_empty(const Body<dim> &body, const int slot)
    {
      return body.run_begin[slot] == body.run_begin[slot + 1];
    }

    /** For each owned block with particles of bodies that count: prepare(slot), f(body number, run) for all, finish(slot). */
    template <int dim, typename Prepare, typename Function, typename Finish>
    void
    for_each_run(std::vector<Body<dim>> &bodies,
                 const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 const bool only_magnetic,
                 const Prepare &prepare,
                 const Function &f,
                 const Finish &finish)
    {
      for (int slot = 0; slot < blocks.n_owned(); ++slot)
        {
          bool is_prepared = false;
          for (std::size_t b = 0; b < bodies.size(); ++b)
            {
              Body<dim> &body = bodies[b];
              if (is_empty(body, slot) || (only_magnetic && !body.magnetic.is_magnetic()))
                continue;
              if (!is_prepared)
                prepare(slot);
              is_prepared = true;
              f(b, run_of(body, blocks, lattice, slot));
            }
          if (is_prepared)
            finish(slot);
        }
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
      false,
      [&](const int) { arena.set_zero(); },
      [&](const std::size_t b, const Run<dim> &run) {
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
      false,
      [&](const int slot) { arena.load(field, blocks, slot); },
      [&](const std::size_t b, const Run<dim> &run) {
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
  template void particles_to_lattice<dim>(std::vector<Body<dim>> &,                           \
                                          const BlockSet<dim> &,                              \
                                          const Lattice<dim> &,                               \
                                          double,                                             \
                                          NodeField<dim> &);                                  \
  template std::vector<ParticleExtremes> lattice_to_particles<dim>(const NodeField<dim> &,    \
                                                                   const BlockSet<dim> &,     \
                                                                   const Lattice<dim> &,      \
                                                                   double,                    \
                                                                   std::vector<Body<dim>> &); \
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
