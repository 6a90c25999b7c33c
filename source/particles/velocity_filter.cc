// Kernels, as particle_grid_transfer.cc.

#include <magmpm/base/simd_functions.h>
#include <magmpm/particles/affine_batch.h>
#include <magmpm/particles/make_material.h>
#include <magmpm/particles/velocity_filter.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** G2P, and P2G of what it gives, without any step in between, of @p factor times the masses. */
    template <int dim>
    [[gnu::flatten]] void
    filter_run(const ParticleRun<dim> &run,
               const double factor,
               const double *velocity,
               double *momentum)
    {
      StencilBatch<dim> stencils;
      LinearBatch<dim> batch;
      for_each_batch(run, [&](const std::size_t first, const int n) {
        place_stencils(run, first, n, stencils);
        gather_batch(stencils, n, velocity, [&](const int p, const auto &rows) {
          sum_linear(stencils, rows, p, batch);
        });
        batch.repeat_last(n);
        for_each_lanes(first, n, [&](const auto place, const int p) {
          const VectorAndMatrix<dim> motion = affine_motion(stencils, batch, run.spacing, p);
          const SimdDouble mass             = factor * load(run.particles.mass, place);
          store_linear(
            stencils, mass, mass * motion.vector, (run.spacing * mass) * motion.matrix, p, batch);
        });
        scatter_batch(stencils, n, momentum, [&](const int p, auto &rows) {
          add_linear(stencils, batch, p, rows);
        });
      });
    }
  } // namespace

  template <int dim>
  double
  share_given_back(const Body<dim> &body, const double spacing, const double time_step)
  {
    constexpr double damping_time = 0.5; // of noise, in dx/c
    if (body.transfer == Transfer::apic)
      return 0.;
    return std::exp(-time_step * undeformed_wave_speed(body.material) / (damping_time * spacing));
  }

  template <int dim>
  void
  filter_velocity(std::vector<Body<dim>> &bodies,
                  const std::vector<double> &factors,
                  const BlockSet<dim> &blocks,
                  const Lattice<dim> &lattice,
                  const NodeField<dim> &velocity,
                  NodeField<dim> &sums,
                  const int group)
  {
    Arena<dim> from, to;
    sums.set_zero();
    for_each_run(
      bodies,
      blocks,
      lattice,
      [group](const auto &body) { return is_in_group(body, group); },
      [&](const int slot) {
        from.load(velocity, blocks, slot);
        to.set_zero();
      },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        if (factors[b] != 0.)
          filter_run(run, factors[b], from.data(), to.data());
      },
      [&](const int slot) { to.add_to(sums, blocks, slot); });
  }

#define INSTANTIATE(dim)                                                    \
  template double share_given_back<dim>(const Body<dim> &, double, double); \
  template void filter_velocity<dim>(std::vector<Body<dim>> &,              \
                                     const std::vector<double> &,           \
                                     const BlockSet<dim> &,                 \
                                     const Lattice<dim> &,                  \
                                     const NodeField<dim> &,                \
                                     NodeField<dim> &,                      \
                                     int);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
