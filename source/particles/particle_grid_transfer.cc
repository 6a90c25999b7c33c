// Kernels: raw pointers and ranges only, nothing of MPI or deal.II (design: the unit of work is a
// block, so that the same bodies can become blocks of a GPU).

#include <magmpm/base/prefetch.h>
#include <magmpm/base/simd_functions.h>
#include <magmpm/particles/affine_batch.h>
#include <magmpm/particles/gradient_batch.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/transfer_runs.h>

#include <algorithm>
#include <limits>

namespace magmpm
{
  namespace
  {
    /** Whether a body counts for a contact group. */
    auto
    bodies_of(const int group)
    {
      return [group](const auto &body) { return is_in_group(body, group); };
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

    /** All that P2G loads of the particles from @p first on. */
    template <int dim>
    inline Prefetch<batch_size>
    prefetch_of_momentum(const ParticleArrays<dim> &particles, const std::size_t first)
    {
      Prefetch<batch_size> next;
      add_arrays(particles.position, first, next);
      add_arrays(particles.velocity, first, next);
      add_arrays(particles.affine_velocity, first, next);
      add_arrays(particles.deformation, first, next);
      add_arrays(particles.magnetic_acceleration, first, next);
      next.add(particles.mass + first);
      next.add(particles.volume + first);
      if (particles.volumetric_stress != nullptr)
        next.add(particles.volumetric_stress + first);
      add_arrays(particles.magnetic_acceleration_gradient, first, next); // last: not all find room
      next.finish();
      return next;
    }

    /**
     * The impulse of the stress over a step times the length 1/dx of gradients: -dt V_0 tau/dx.
     *
     * @tparam is_smoothed  with the volumetric part that smoothed_volume.h found.
     */
    template <bool is_smoothed, int dim, typename Law, typename Place>
    inline Matrix<dim, SimdDouble>
    stress_impulse(const ParticleRun<dim> &run,
                   const Law &law,
                   const double time_step,
                   const Matrix<dim, SimdDouble> &affine,
                   const Place place)
    {
      const SimdDouble factor = (-time_step / run.spacing) * load(run.particles.volume, place);
      const auto state        = load_state<dim, Law>(run.particles, place);
      if constexpr (is_smoothed)
        return factor *
               law.stress_with_pressure(state, load(run.particles.volumetric_stress, place));
      else
        return factor * law.kirchhoff_stress(state, affine);
    }

    /** The columns of a matrix of particles, number @p p of the batch on, for the gradients of P2G. */
    template <int dim>
    inline void
    store_gradient(const Matrix<dim, SimdDouble> &matrix, const int p, GradientBatch<dim> &batch)
    {
      for (int d = 0; d < dim; ++d)
        {
          SimdDouble column[n_lanes] = {};
          for (int c = 0; c < dim; ++c)
            column[c] = matrix(c, d);
          store_transposed(column, batch.numbers[p][d], GradientBatch<dim>::stride);
        }
    }

    /** Mass and momentum of the particles at @p place, number @p p of the batch, and their stress. */
    template <bool is_smoothed, int dim, typename Law, typename Place>
    inline void
    momentum_of_particles(const ParticleRun<dim> &run,
                          const StencilBatch<dim> &stencils,
                          const Law &law,
                          const double time_step,
                          const Place place,
                          const int p,
                          LinearBatch<dim> &batch,
                          GradientBatch<dim> &gradients)
    {
      const auto &particles                = run.particles;
      const Matrix<dim, SimdDouble> affine = load_matrix<dim>(particles.affine_velocity, place);
      const SimdDouble mass                = load(particles.mass, place);
      const Matrix<dim, SimdDouble> stress =
        stress_impulse<is_smoothed>(run, law, time_step, affine, place);
      Matrix<dim, SimdDouble> slope    = (run.spacing * mass) * affine;
      Vector<dim, SimdDouble> velocity = load_vector<dim>(particles.velocity, place);
      if (particles.magnetic_acceleration[0] != nullptr)
        {
          velocity += time_step * load_vector<dim>(particles.magnetic_acceleration, place);
          slope += (time_step * run.spacing * mass) *
                   load_matrix<dim>(particles.magnetic_acceleration_gradient, place);
        }
      if constexpr (Law::stores_deformation_gradient)
        store_gradient(stress, p, gradients);
      else
        slope += SimdDouble(4.) * stress;
      store_linear(stencils, mass, mass * velocity, slope, p, batch);
    }

    template <bool is_smoothed, int dim, typename Law>
    [[gnu::flatten]] void
    scatter_momentum(const ParticleRun<dim> &run,
                     const Law &law,
                     const double time_step,
                     double *arena)
    {
      StencilBatch<dim> stencils;
      StencilSlopes<dim> slopes;
      LinearBatch<dim> batch;
      GradientBatch<dim> gradients;
      for_each_batch(run, [&](const std::size_t first, const int n) {
        place_stencils(run, first, n, stencils);
        if constexpr (Law::stores_deformation_gradient)
          find_slopes(stencils, n, slopes);
        for_each_lanes(first, n, [&](const auto place, const int p) {
          momentum_of_particles<is_smoothed>(
            run, stencils, law, time_step, place, p, batch, gradients);
        });
        const Prefetch<batch_size> next = prefetch_of_momentum<dim>(run.particles,
                                                                    first + batch_size);
        scatter_batch(stencils, n, arena, [&](const int p, auto &rows) {
          next.template ask<false>(p);
          if constexpr (Law::stores_deformation_gradient)
            add_linear_and_gradient(stencils, slopes, batch, gradients, p, rows);
          else
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
     * Moves and deforms the particles at @p place over a step.
     *
     * @param motion     their new velocity and affine velocity.
     * @param transport  the velocity they move with, and the gradient they deform with.
     */
    template <int dim, typename Law, typename Place>
    inline void
    advance_particles(const ParticleArrays<dim> &particles,
                      const Law &law,
                      const double time_step,
                      const VectorAndMatrix<dim> &motion,
                      const VectorAndMatrix<dim> &transport,
                      const Place place,
                      LaneExtremes &extremes)
    {
      const typename Law::State state =
        law.advanced(load_state<dim, Law>(particles, place), transport.matrix, time_step);
      store_vector<dim>(load_vector<dim>(particles.position, place) + time_step * transport.vector,
                        particles.position,
                        place);
      store_vector<dim>(motion.vector, particles.velocity, place);
      store_matrix<dim>(motion.matrix, particles.affine_velocity, place);
      store_state<dim, Law>(state, particles, place);

      const SimdDouble speed        = norm(motion.vector);
      const SimdDouble volume_ratio = law.volume_ratio(state);
      LaneExtremes::raise(extremes.speed, speed);
      LaneExtremes::raise(extremes.speed, norm(transport.vector));
      LaneExtremes::raise(extremes.signal_speed, speed + law.wave_speed(state));
      LaneExtremes::raise(extremes.affine_velocity, frobenius_norm(motion.matrix));
      LaneExtremes::raise(extremes.max_volume_ratio, volume_ratio);
      LaneExtremes::raise(extremes.max_inverse_volume_ratio,
                          SimdDouble::select(volume_ratio > 0.,
                                             1. / volume_ratio,
                                             std::numeric_limits<double>::infinity()));
    }

    /** Where the velocities are that a run of G2P needs: arenas of its block. */
    struct VelocityArenas
    {
      const double *taken;     ///< of which particles take velocity and affine velocity
      const double *transport; ///< with which solids move and deform; fluids do with that one
    };

    template <int dim, typename Law>
    [[gnu::flatten]] void
    gather_velocity(const ParticleRun<dim> &run,
                    const Law &law,
                    const double time_step,
                    const VelocityArenas &arenas,
                    ParticleExtremes &extremes)
    {
      constexpr bool is_solid = Law::stores_deformation_gradient;
      StencilBatch<dim> stencils;
      StencilSlopes<dim> slopes;
      LinearBatch<dim> batch, transport;
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
        gather_batch(stencils, n, arenas.taken, [&](const int p, const auto &rows) {
          soon.template ask<true>(p);
          sum_linear(stencils, rows, p, batch);
        });
        batch.repeat_last(n);
        if constexpr (is_solid)
          {
            find_slopes(stencils, n, slopes);
            gather_batch(stencils, n, arenas.transport, [&](const int p, const auto &rows) {
              sum_gradient(stencils, slopes, rows, p, transport);
            });
            transport.repeat_last(n);
          }
        for_each_lanes(first, n, [&](const auto place, const int p) {
          const VectorAndMatrix<dim> motion = affine_motion(stencils, batch, run.spacing, p);
          if constexpr (is_solid)
            {
              VectorAndMatrix<dim> moved(transport, p);
              moved.matrix *= SimdDouble(1. / run.spacing);
              advance_particles(particles, law, time_step, motion, moved, place, lane_extremes);
            }
          else
            advance_particles(particles, law, time_step, motion, motion, place, lane_extremes);
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
                       NodeField<dim> &field,
                       const int group)
  {
    Arena<dim> arena;
    field.set_zero();
    for_each_run(
      bodies,
      blocks,
      lattice,
      bodies_of(group),
      [&](const int) { arena.set_zero(); },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        std::visit(
          [&](const auto &law) {
            const auto law_of_lanes = law.template with_number<SimdDouble>();
            if constexpr (law_of_lanes.stores_deformation_gradient)
              if (run.particles.volumetric_stress != nullptr)
                return scatter_momentum<true>(run, law_of_lanes, time_step, arena.data());
            scatter_momentum<false>(run, law_of_lanes, time_step, arena.data());
          },
          bodies[b].material);
      },
      [&](const int slot) { arena.add_to(field, blocks, slot); });
  }

  template <int dim>
  std::vector<ParticleExtremes>
  lattice_to_particles(const LatticeVelocities<dim> &velocities,
                       const BlockSet<dim> &blocks,
                       const Lattice<dim> &lattice,
                       const double time_step,
                       std::vector<Body<dim>> &bodies,
                       const int group)
  {
    std::vector<ParticleExtremes> extremes(bodies.size());
    const bool is_filtered = velocities.filtered.n_blocks() > 0;
    Arena<dim> plain, filtered, taken;
    for_each_run(
      bodies,
      blocks,
      lattice,
      bodies_of(group),
      [&](const int slot) {
        plain.load(velocities.velocity, blocks, slot);
        if (!is_filtered)
          return;
        filtered.load(velocities.filtered, blocks, slot);
        taken.load(velocities.taken, blocks, slot);
      },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        const VelocityArenas arenas = {is_filtered ? taken.data() : plain.data(),
                                       bodies[b].transfer == Transfer::fmpm ? filtered.data()
                                                                            : plain.data()};
        std::visit(
          [&](const auto &law) {
            gather_velocity(
              run, law.template with_number<SimdDouble>(), time_step, arenas, extremes[b]);
          },
          bodies[b].material);
      },
      [](const int) {});
    return extremes;
  }

#define INSTANTIATE(dim)                                                                           \
  template void particles_to_lattice<dim>(std::vector<Body<dim>> &,                                \
                                          const BlockSet<dim> &,                                   \
                                          const Lattice<dim> &,                                    \
                                          double,                                                  \
                                          NodeField<dim> &,                                        \
                                          int);                                                    \
  template std::vector<ParticleExtremes> lattice_to_particles<dim>(const LatticeVelocities<dim> &, \
                                                                   const BlockSet<dim> &,          \
                                                                   const Lattice<dim> &,           \
                                                                   double,                         \
                                                                   std::vector<Body<dim>> &,       \
                                                                   int);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
