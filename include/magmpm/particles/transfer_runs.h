#pragma once

#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_state.h>
#include <magmpm/particles/transfer_batch.h>

#include <algorithm>
#include <vector>

/** How the kernels of P2G and G2P go through the particles: block by block, body by body. */
namespace magmpm
{
  /** One run of particles: the kernels below work on it. */
  template <int dim>
  struct ParticleRun
  {
    ParticleArrays<dim> particles;
    std::size_t begin, end;
    StencilsOfBlock<dim> stencils;
    double spacing;
  };

  /** Calls f(first particle, n) for the batches of a run. */
  template <int dim, typename Function>
  inline void
  for_each_batch(const ParticleRun<dim> &run, const Function &f)
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
  place_stencils(const ParticleRun<dim> &run,
                 const std::size_t first,
                 const int n,
                 StencilBatch<dim> &stencils)
  {
    for_each_lanes(first, n, [&](const auto place, const int p) {
      run.stencils.place(load_vector<dim>(run.particles.position, place), p, stencils);
    });
  }

  /** The slopes of the stencils of the first @p n particles of a batch. */
  template <int dim>
  inline void
  find_slopes(const StencilBatch<dim> &stencils, const int n, StencilSlopes<dim> &slopes)
  {
    for (int p = 0; p < n; p += SimdDouble::n_lanes)
      StencilsOfBlock<dim>::find_slopes(stencils, p, slopes);
  }

  /** The run of @p body in the block of @p slot. */
  template <int dim>
  ParticleRun<dim>
  run_of(Body<dim> &body, const BlockSet<dim> &blocks, const Lattice<dim> &lattice, const int slot)
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

  /**
   * For each owned block with particles of bodies that count, counts(body): prepare(slot), f(body
   * number, run) for all of them, finish(slot).
   */
  template <int dim, typename Counts, typename Prepare, typename Function, typename Finish>
  void
  for_each_run(std::vector<Body<dim>> &bodies,
               const BlockSet<dim> &blocks,
               const Lattice<dim> &lattice,
               const Counts &counts,
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
            if (is_empty(body, slot) || !counts(body))
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
} // namespace magmpm
