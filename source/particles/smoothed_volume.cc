// Kernels, as particle_grid_transfer.cc.

#include <magmpm/base/simd_functions.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/make_material.h>
#include <magmpm/particles/smoothed_volume.h>
#include <magmpm/particles/transfer_runs.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** Hats that reach a point. */
    template <int dim>
    constexpr int n_hats = power(2, dim);

    /** Distance in an arena from a particle's first node to that of hat @p k [doubles]. */
    template <int dim>
    constexpr int
    hat_offset(const int k)
    {
      int offset = 0;
      for (int d = 0; d < dim; ++d)
        offset += ((k >> d) & 1) * Arena<dim>::stride(d);
      return offset;
    }

    /** The hats of a batch of particles. */
    template <int dim>
    struct HatBatch
    {
      alignas(64) int first[batch_size]; ///< place of the first node in the arena [doubles]
      alignas(64) double weights[n_hats<dim>][batch_size];
    };

    /** Fills the hats of the particles at @p place, number @p p of the batch on. */
    template <int dim, typename Place>
    inline void
    place_hats(const ParticleRun<dim> &run, const Place place, const int p, HatBatch<dim> &hats)
    {
      Vector<dim, SimdDouble> offsets;
      const auto first = run.stencils.first_nodes(load_vector<dim>(run.particles.position, place),
                                                  offsets);
      std::memcpy(&hats.first[p], &first, sizeof(first));
      SimdDouble weights[n_hats<dim>];
      weights[0] = 1.;
      for (int d = 0; d < dim; ++d)
        {
          // No weight may be negative by rounding: a sum of weights would be about zero.
          const SimdDouble upper = max(offsets[d] - 0.5, SimdDouble(0.));
          const SimdDouble lower = max(1.5 - offsets[d], SimdDouble(0.));
          for (int k = 0; k < power(2, d); ++k)
            {
              weights[k + power(2, d)] = upper * weights[k];
              weights[k] *= lower;
            }
        }
      for (int k = 0; k < n_hats<dim>; ++k)
        weights[k].store(&hats.weights[k][p]);
    }

    /** A number in all lanes, by a load alone: one that becomes a Simd is added to zero. */
    inline NodeLanes
    broadcast(const double number)
    {
      static_assert(NodeLanes::n_lanes == 4, "as many as there are numbers here");
      return NodeLanes::Register{number, number, number, number};
    }

    /** Adds V and V ln J, and leaves ln J in the place of the volumetric stress. */
    template <int dim, typename Law>
    [[gnu::flatten]] void
    scatter_strain(const ParticleRun<dim> &run, const Law &law, double *arena)
    {
      HatBatch<dim> hats;
      alignas(64) double numbers[batch_size][n_lanes];
      for_each_batch(run, [&](const std::size_t first, const int n) {
        for_each_lanes(first, n, [&](const auto place, const int p) {
          place_hats(run, place, p, hats);
          const auto state        = load_state<dim, Law>(run.particles, place);
          const SimdDouble strain = log(law.volume_ratio(state));
          const SimdDouble volume = load(run.particles.volume, place);
          store(strain, run.particles.volumetric_stress, place);
          const SimdDouble lanes[n_lanes] = {volume * strain, 0., 0., volume};
          store_transposed(lanes, numbers[p], n_lanes);
        });
        for (int p = 0; p < n;)
          {
            const int node               = hats.first[p];
            NodeLanes nodes[n_hats<dim>] = {};
            do
              {
                const NodeLanes lanes = NodeLanes::load(numbers[p]);
                for (int k = 0; k < n_hats<dim>; ++k)
                  nodes[k] += broadcast(hats.weights[k][p]) * lanes;
              }
            while (++p < n && hats.first[p] == node);
            for (int k = 0; k < n_hats<dim>; ++k)
              {
                double *const at = arena + node + hat_offset<dim>(k);
                (NodeLanes::load(at) + nodes[k]).store(at);
              }
          }
      });
    }

    /** Makes the volumetric stress of the ln J in its place and the means on the nodes. */
    template <int dim>
    [[gnu::flatten]] void
    gather_strain(const ParticleRun<dim> &run, const NeoHookean<dim> &law, const double *arena)
    {
      const double smoothed = law.smoothed_modulus(), own = law.lame_lambda - smoothed;
      HatBatch<dim> hats;
      alignas(64) double means[batch_size];
      for_each_batch(run, [&](const std::size_t first, const int n) {
        for_each_lanes(first, n, [&](const auto place, const int p) {
          place_hats(run, place, p, hats);
        });
        for (int p = 0; p < n; ++p)
          {
            double mean = 0.;
            for (int k = 0; k < n_hats<dim>; ++k)
              mean += hats.weights[k][p] * arena[hats.first[p] + hat_offset<dim>(k)];
            means[p] = mean;
          }
        for_each_lanes(first, n, [&](const auto place, const int p) {
          double *const stress    = run.particles.volumetric_stress;
          const SimdDouble strain = load(stress, place);
          store(own * strain + smoothed * SimdDouble::load(&means[p]), stress, place);
        });
      });
    }

    template <int dim>
    bool
    is_of(const Body<dim> &body, const SmoothedMaterial &material)
    {
      const auto *solid = std::get_if<NeoHookean<dim>>(&body.material);
      return solid != nullptr && solid->shear_modulus == material.moduli.shear_modulus &&
             solid->lame_lambda == material.moduli.lame_lambda &&
             body.contact_group == material.contact_group;
    }
  } // namespace

  template <int dim>
  std::vector<SmoothedMaterial>
  smoothed_materials(const std::vector<Body<dim>> &bodies)
  {
    std::vector<SmoothedMaterial> materials;
    for (const Body<dim> &body : bodies)
      if (smoothed_modulus(body.material) > 0. &&
          std::none_of(materials.begin(), materials.end(), [&](const SmoothedMaterial &known) {
            return is_of(body, known);
          }))
        {
          const auto &solid = std::get<NeoHookean<dim>>(body.material);
          materials.push_back({{solid.shear_modulus, solid.lame_lambda}, body.contact_group});
        }
    return materials;
  }

  template <int dim>
  void
  sum_strain(std::vector<Body<dim>> &bodies,
             const SmoothedMaterial &material,
             const BlockSet<dim> &blocks,
             const Lattice<dim> &lattice,
             NodeField<dim, NodeStrain> &field)
  {
    Arena<dim> arena;
    field.set_zero();
    for_each_run(
      bodies,
      blocks,
      lattice,
      [&](const Body<dim> &body) { return is_of(body, material); },
      [&](const int) { arena.set_zero(); },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        const auto &law = std::get<NeoHookean<dim>>(bodies[b].material);
        scatter_strain(run, law.template with_number<SimdDouble>(), arena.data());
      },
      [&](const int slot) { arena.add_to(field, blocks, slot); });
  }

  template <int dim>
  void
  divide_by_weight(const BlockSet<dim> &blocks, NodeField<dim, NodeStrain> &field)
  {
    for_nodes(blocks, [&](const int slot, const int n) {
      const double weight = field.get(NodeStrain::weight, slot, n);
      if (weight > 0.)
        field.set(NodeStrain::strain, slot, n, field.get(NodeStrain::strain, slot, n) / weight);
    });
  }

  template <int dim>
  void
  find_volumetric_stress(const NodeField<dim, NodeStrain> &field,
                         const SmoothedMaterial &material,
                         const BlockSet<dim> &blocks,
                         const Lattice<dim> &lattice,
                         std::vector<Body<dim>> &bodies)
  {
    Arena<dim> arena;
    for_each_run(
      bodies,
      blocks,
      lattice,
      [&](const Body<dim> &body) { return is_of(body, material); },
      [&](const int slot) { arena.load(field, blocks, slot); },
      [&](const std::size_t b, const ParticleRun<dim> &run) {
        gather_strain(run, std::get<NeoHookean<dim>>(bodies[b].material), arena.data());
      },
      [](const int) {});
  }

#define INSTANTIATE(dim)                                                                     \
  template std::vector<SmoothedMaterial> smoothed_materials(const std::vector<Body<dim>> &); \
  template void sum_strain(std::vector<Body<dim>> &,                                         \
                           const SmoothedMaterial &,                                         \
                           const BlockSet<dim> &,                                            \
                           const Lattice<dim> &,                                             \
                           NodeField<dim, NodeStrain> &);                                    \
  template void divide_by_weight(const BlockSet<dim> &, NodeField<dim, NodeStrain> &);       \
  template void find_volumetric_stress(const NodeField<dim, NodeStrain> &,                   \
                                       const SmoothedMaterial &,                             \
                                       const BlockSet<dim> &,                                \
                                       const Lattice<dim> &,                                 \
                                       std::vector<Body<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
