// Kernels: raw pointers and ranges only, nothing of MPI or deal.II (design: the unit of work is a
// block, so that the same bodies can become blocks of a GPU).

#include <magmpm/lattice/arena.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/lanes.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_state.h>

#include <limits>

namespace magmpm
{
  namespace
  {
    /** The 3^dim nodes around one particle. */
    template <int dim>
    struct Stencil
    {
      int first = 0;                      ///< place of the first node in the arena [doubles]
      double weights[dim][stencil_width]; ///< of the nodes in each direction
      double distance[dim]; ///< from the particle to the first node, per direction [m]
    };

    /** Places particles on the lattice of one arena. */
    template <int dim>
    class StencilOfBlock
    {
    public:
      StencilOfBlock(const Lattice<dim> &lattice, const Index<dim> &block)
        : origin(lattice.node_position(Arena<dim>::first_node(block)))
        , spacing(lattice.spacing)
        , inverse_spacing(1. / lattice.spacing)
      {
      }

      Stencil<dim>
      at(const ParticleArrays<dim> &particles, const std::size_t p) const
      {
        Stencil<dim> stencil;
        for (int d = 0; d < dim; ++d)
          {
            const double x      = (particles.position[d][p] - origin[d]) * inverse_spacing;
            const int node      = static_cast<int>(x - 0.5);
            const double offset = x - node;
            quadratic_bspline(offset, stencil.weights[d]);
            stencil.first += node * Arena<dim>::stride(d);
            stencil.distance[d] = -offset * spacing;
          }
        return stencil;
      }

    private:
      Vector<dim> origin;
      double spacing;
      double inverse_spacing;
    };

    /** Calls f(place in the arena, weight, {i, j, k}) for the nodes around a particle. */
    template <int dim, typename Function>
    inline void
    for_each_node(const Stencil<dim> &stencil, const Function &f)
    {
      for (int k = 0; k < (dim == 3 ? stencil_width : 1); ++k)
        for (int j = 0; j < stencil_width; ++j)
          {
            int place     = stencil.first + j * Arena<dim>::stride(1);
            double weight = stencil.weights[1][j];
            if constexpr (dim == 3)
              {
                place += k * Arena<dim>::stride(2);
                weight *= stencil.weights[2][k];
              }
            for (int i = 0; i < stencil_width; ++i)
              f(place + i * n_lanes, weight * stencil.weights[0][i], i, j, k);
          }
    }

    /** Adds a value that varies linearly, value + sum_d slope[d] (x_i - x_p)_d, to the nodes. */
    template <int dim>
    inline void
    scatter_linear(const Stencil<dim> &stencil,
                   const double spacing,
                   const Lanes &value,
                   const Lanes (&slope)[dim],
                   double *arena)
    {
      Lanes start = value;
      Lanes step[dim];
      for (int d = 0; d < dim; ++d)
        {
          start += stencil.distance[d] * slope[d];
          step[d] = spacing * slope[d];
        }
      for_each_node<dim>(
        stencil, [&](const int place, const double weight, const int i, const int j, const int k) {
          Lanes here = start + double(i) * step[0] + double(j) * step[1];
          if constexpr (dim == 3)
            here += double(k) * step[2];
          store_lanes(load_lanes(arena + place) + weight * here, arena + place);
        });
    }

    /** Interpolates: returns sum_i N_i q_i, and sum_i N_i q_i (x_i - x_p)_d in @p moment[d]. */
    template <int dim>
    inline Lanes
    gather_linear(const Stencil<dim> &stencil,
                  const double spacing,
                  const double *arena,
                  Lanes (&moment)[dim])
    {
      Lanes sum = {};
      for (int d = 0; d < dim; ++d)
        moment[d] = Lanes{};
      for_each_node<dim>(
        stencil, [&](const int place, const double weight, const int i, const int j, const int k) {
          const Lanes q = weight * load_lanes(arena + place);
          sum += q;
          moment[0] += double(i) * q;
          moment[1] += double(j) * q;
          if constexpr (dim == 3)
            moment[2] += double(k) * q;
        });
      for (int d = 0; d < dim; ++d)
        moment[d] = spacing * moment[d] + stencil.distance[d] * sum;
      return sum;
    }

    /** One run of particles: the kernels below work on it. */
    template <int dim>
    struct Run
    {
      ParticleArrays<dim> particles;
      std::size_t begin, end;
      StencilOfBlock<dim> stencils;
      double spacing;
    };

    template <int dim, typename Law>
    void
    scatter_momentum(const Run<dim> &run, const Law &law, const double time_step, double *arena)
    {
      const ParticleArrays<dim> &particles = run.particles;
      const double stress_factor           = -time_step * 4. / (run.spacing * run.spacing);
      const bool is_magnetic               = particles.magnetic_acceleration[0] != nullptr;
      for (std::size_t p = run.begin; p < run.end; ++p)
        {
          const Matrix<dim> affine = load_matrix<dim>(particles.affine_velocity, p);
          const Matrix<dim> stress = law.kirchhoff_stress(load_state<dim, Law>(particles, p),
                                                          affine);
          const double mass        = particles.mass[p];
          const Matrix<dim> slope  = mass * affine + (stress_factor * particles.volume[p]) * stress;

          Lanes value = {};
          value[3]    = mass;
          Lanes slopes[dim];
          for (int d = 0; d < dim; ++d)
            {
              double velocity = particles.velocity[d][p];
              if (is_magnetic)
                velocity += time_step * particles.magnetic_acceleration[d][p];
              value[d]  = mass * velocity;
              slopes[d] = Lanes{};
              for (int c = 0; c < dim; ++c)
                slopes[d][c] = slope(c, d);
            }
          scatter_linear<dim>(run.stencils.at(particles, p), run.spacing, value, slopes, arena);
        }
    }

    template <int dim, typename Law>
    void
    advance_particles(const Run<dim> &run,
                      const Law &law,
                      const double time_step,
                      const double *arena,
                      ParticleExtremes &extremes)
    {
      const ParticleArrays<dim> &particles = run.particles;
      const double affine_factor           = 4. / (run.spacing * run.spacing);
      const auto raise                     = [](double &largest, const double value) {
        largest = (value <= largest
                                         ? largest
                                         : (value > largest ? value : std::numeric_limits<double>::infinity()));
      };
      for (std::size_t p = run.begin; p < run.end; ++p)
        {
          Lanes moment[dim];
          const Lanes velocity =
            gather_linear<dim>(run.stencils.at(particles, p), run.spacing, arena, moment);
          Matrix<dim> affine;
          Vector<dim> v;
          for (int c = 0; c < dim; ++c)
            {
              v[c] = velocity[c];
              particles.position[c][p] += time_step * velocity[c];
              for (int d = 0; d < dim; ++d)
                affine(c, d) = affine_factor * moment[d][c];
            }
          const typename Law::State state =
            law.advanced(load_state<dim, Law>(particles, p), affine, time_step);
          store_vector<dim>(v, particles.velocity, p);
          store_matrix<dim>(affine, particles.affine_velocity, p);
          store_state<dim, Law>(state, particles, p);

          const double speed        = norm(v);
          const double volume_ratio = law.volume_ratio(state);
          raise(extremes.speed, speed);
          raise(extremes.signal_speed, speed + law.wave_speed(state));
          raise(extremes.affine_velocity, frobenius_norm(affine));
          raise(extremes.max_volume_ratio, volume_ratio);
          raise(extremes.max_inverse_volume_ratio,
                volume_ratio > 0. ? 1. / volume_ratio : std::numeric_limits<double>::infinity());
        }
    }

    /** Adds the same lanes to all nodes of a stencil, weighted. */
    template <int dim>
    void
    scatter(const Stencil<dim> &stencil, const Lanes &value, double *arena)
    {
      for_each_node<dim>(stencil, [&](const int place, const double weight, int, int, int) {
        store_lanes(load_lanes(arena + place) + weight * value, arena + place);
      });
    }

    template <int dim, typename Law>
    void
    scatter_content(const Run<dim> &run,
                    const Law &law,
                    const MagneticParameters &magnetic,
                    double *arena)
    {
      const double per_cell = 1. / std::pow(run.spacing, dim);
      const Lanes content   = {0.,
                               magnetic.saturation_magnetization,
                               magnetic.initial_susceptibility,
                               magnetic.number_density};
      for (std::size_t p = run.begin; p < run.end; ++p)
        {
          Lanes value = content;
          value[0]    = law.volume_ratio(load_state<dim, Law>(run.particles, p));
          value *= per_cell * run.particles.volume[p];
          scatter(run.stencils.at(run.particles, p), value, arena);
        }
    }

    template <int dim>
    void
    gather_vector(const Run<dim> &run, const double *arena, double *const *components)
    {
      for (std::size_t p = run.begin; p < run.end; ++p)
        {
          Lanes sum = {};
          for_each_node<dim>(run.stencils.at(run.particles, p),
                             [&](const int place, const double weight, int, int, int) {
                               sum += weight * load_lanes(arena + place);
                             });
          for (int d = 0; d < dim; ++d)
            components[d][p] = sum[d];
        }
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
              StencilOfBlock<dim>(lattice, blocks.block(slot)),
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
        std::visit([&](const auto &law) { scatter_momentum(run, law, time_step, arena.data()); },
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
            advance_particles(run, law, time_step, arena.data(), extremes[b]);
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
    Arena<dim> arena;
    content.set_zero();
    for_each_run(
      bodies,
      blocks,
      lattice,
      true,
      [&](const int) { arena.set_zero(); },
      [&](const std::size_t b, const Run<dim> &run) {
        std::visit(
          [&](const auto &law) { scatter_content(run, law, bodies[b].magnetic, arena.data()); },
          bodies[b].material);
      },
      [&](const int slot) { arena.add_to(content, blocks, slot); });
  }

  template <int dim>
  void
  magnetic_mass_to_lattice(std::vector<Body<dim>> &bodies,
                           const BlockSet<dim> &blocks,
                           const Lattice<dim> &lattice,
                           NodeField<dim> &mass)
  {
    Arena<dim> arena;
    mass.set_zero();
    for_each_run(
      bodies,
      blocks,
      lattice,
      true,
      [&](const int) { arena.set_zero(); },
      [&](const std::size_t, const Run<dim> &run) {
        for (std::size_t p = run.begin; p < run.end; ++p)
          scatter(run.stencils.at(run.particles, p),
                  Lanes{0., 0., 0., run.particles.mass[p]},
                  arena.data());
      },
      [&](const int slot) { arena.add_to(mass, blocks, slot); });
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
