#pragma once

#include <magmpm/particles/transfer_runs.h>

#include <variant>

/** P2G and G2P of any quantities of particles, with the kernels of transfer_batch.h. */
namespace magmpm
{
  /** Adds value(place, lanes), up to four lanes for the nodes around each particle of a run, to an arena. */
  template <int dim, typename Value>
  [[gnu::flatten]] void
  scatter_run(const ParticleRun<dim> &run, const Value &value, double *arena)
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

  /** Calls take(particle, sum_i N_i q_i of the lanes) for each particle of a run. */
  template <int dim, typename Take>
  [[gnu::flatten]] void
  gather_run(const ParticleRun<dim> &run, const double *arena, const Take &take)
  {
    StencilBatch<dim> stencils;
    for_each_batch(run, [&](const std::size_t first, const int n) {
      place_stencils(run, first, n, stencils);
      gather_batch(stencils, n, arena, [&](const int p, const auto &rows) {
        take(first + p, sum_constant(stencils, rows, p));
      });
    });
  }

  /**
   * P2G: sum over particles of N_i q, for quantities q of up to four lanes.
   *
   * @param counts    whether particles of a body count: counts(body).
   * @param value_of  value_of(body, law) makes the function that sets the lanes of q for the particles
   *                  at a place: value(place, lanes); load() reads what the particles carry there, and
   *                  the law takes such numbers.
   * @param field     on return the sums over this rank's particles, also on ghosts.
   */
  template <int dim, typename Quantities, typename Counts, typename ValueOf>
  void
  scatter(std::vector<Body<dim>> &bodies,
          const BlockSet<dim> &blocks,
          const Lattice<dim> &lattice,
          const Counts &counts,
          const ValueOf &value_of,
          NodeField<dim, Quantities> &field)
  {
    Arena<dim> arena;
    field.set_zero();
    for_each_run(
      bodies,
      blocks,
      lattice,
      counts,
      [&](const int) { arena.set_zero(); },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        std::visit(
          [&](const auto &law) {
            scatter_run(
              run, value_of(bodies[b], law.template with_number<SimdDouble>()), arena.data());
          },
          bodies[b].material);
      },
      [&](const int slot) { arena.add_to(field, blocks, slot); });
  }

  /**
   * G2P: sum_i N_i q_i at particles.
   *
   * @param field    of up to four lanes, ghosts up to date.
   * @param counts   whether a body takes part.
   * @param take_of  take_of(body) makes the function that is given the lanes of a particle:
   *                 take(particle, lanes).
   */
  template <int dim, typename Quantities, typename Counts, typename TakeOf>
  void
  gather(const NodeField<dim, Quantities> &field,
         const BlockSet<dim> &blocks,
         const Lattice<dim> &lattice,
         const Counts &counts,
         const TakeOf &take_of,
         std::vector<Body<dim>> &bodies)
  {
    Arena<dim> arena;
    for_each_run(
      bodies,
      blocks,
      lattice,
      counts,
      [&](const int slot) { arena.load(field, blocks, slot); },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        gather_run(run, arena.data(), take_of(bodies[b]));
      },
      [](const int) {});
  }
} // namespace magmpm
