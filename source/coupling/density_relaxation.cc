// Kernels, as particle_grid_transfer.cc.

#include <magmpm/coupling/density_relaxation.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/quantity_transfer.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** A node with less material than this on a node around is near a free surface. */
    constexpr double least_fraction = 0.8;

    /** As much too full a node near a free surface may be. */
    constexpr double margin = 0.1;

    /** The times in which J follows the density, in a fluid and in a spray, in times of sound across a cell. */
    constexpr double relaxation_time = 20., spray_time = 3.;

    /** A particle with less material around it than this, itself included, is one of a spray. */
    constexpr double spray_fraction = 0.4;

    /** The part of the noise that is taken. */
    constexpr double taken_noise = 0.5;

    template <int dim>
    const ViscoelasticFluid<dim> *
    as_fluid(const Body<dim> &body)
    {
      return std::get_if<ViscoelasticFluid<dim>>(&body.material);
    }

    /** Whether a body is a fluid of a bulk modulus. */
    auto
    is_fluid_of(const double bulk_modulus)
    {
      return [bulk_modulus](const auto &body) {
        const auto *fluid = as_fluid(body);
        return fluid != nullptr && fluid->bulk_modulus == bulk_modulus;
      };
    }

    template <int dim>
    double
    cells_per_volume(const Lattice<dim> &lattice)
    {
      return 1. / std::pow(lattice.spacing, dim);
    }
  } // namespace

  template <int dim>
  bool
  has_fluid(const std::vector<Body<dim>> &bodies)
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body<dim> &body) {
      return as_fluid(body) != nullptr;
    });
  }

  template <int dim>
  std::vector<double>
  bulk_moduli(const std::vector<Body<dim>> &bodies)
  {
    std::vector<double> moduli;
    for (const Body<dim> &body : bodies)
      if (const auto *fluid = as_fluid(body);
          fluid != nullptr &&
          std::find(moduli.begin(), moduli.end(), fluid->bulk_modulus) == moduli.end())
        moduli.push_back(fluid->bulk_modulus);
    return moduli;
  }

  template <int dim>
  void
  scatter_claims(std::vector<Body<dim>> &bodies,
                 const double bulk_modulus,
                 const bool with_solids,
                 const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 NodeField<dim, NodeClaims> &claims)
  {
    const auto is_fluid   = is_fluid_of(bulk_modulus);
    const double per_cell = cells_per_volume(lattice);
    scatter(
      bodies,
      blocks,
      lattice,
      [&](const Body<dim> &body) {
        return is_fluid(body) || (with_solids && as_fluid(body) == nullptr);
      },
      [per_cell](const Body<dim> &body, const auto &law) {
        return [law, per_cell, particles = body.particles.arrays()](const auto place, auto &lanes) {
          using Law               = std::decay_t<decltype(law)>;
          const SimdDouble volume = per_cell * load(particles.volume, place);
          const SimdDouble claim  = volume *
                                   law.volume_ratio(load_state<dim, Law>(particles, place));
          if (Law::stores_deformation_gradient)
            lanes[NodeClaims::solid.lane] = claim;
          else
            {
              lanes[NodeClaims::fluid.lane]      = claim;
              lanes[NodeClaims::undeformed.lane] = volume;
            }
        };
      },
      claims);
  }

  template <int dim>
  void
  find_excess(const BlockSet<dim> &blocks,
              const NodeField<dim, SingleScalar> &fraction,
              NodeField<dim, NodeFluid> &field)
  {
    for_nodes(blocks, [&](const int slot, const int n) {
      int n_full = 0;
      if (fraction.get(SingleScalar::value, slot, n) > least_fraction)
        for_nodes_around(blocks, slot, n, [&](const int other, const int node) {
          n_full += fraction.get(SingleScalar::value, other, node) > least_fraction;
        });
      const bool is_near  = n_full < n_neighbours<dim>;
      const double excess = fraction.get(SingleScalar::value, slot, n) - 1.;
      field.set(NodeFluid::fraction, slot, n, 1. + excess);
      field.set(NodeFluid::excess, slot, n, is_near ? std::max(excess - margin, 0.) : excess);
      field.set(NodeFluid::near_surface, slot, n, is_near);
    });
  }

  template <int dim>
  void
  relax_volume_ratios(const NodeField<dim, NodeFluid> &field,
                      const double bulk_modulus,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      const double time,
                      Residuals &residuals,
                      DensityError &error,
                      std::vector<Body<dim>> &bodies)
  {
    residuals.resize(bodies.size());
    gather(
      field,
      blocks,
      lattice,
      is_fluid_of(bulk_modulus),
      [&](Body<dim> &body) {
        const double crossing         = lattice.spacing / as_fluid(body)->wave_speed(1.);
        const double way              = 1. - std::exp(-time / (relaxation_time * crossing));
        const double to_one           = 1. - std::exp(-time / (spray_time * crossing));
        double *ratio                 = body.particles.component(ParticleProperty::deformation, 0);
        std::vector<double> &residual = residuals[&body - bodies.data()];
        residual.resize(body.particles.size());
        return
          [&error, &residual, way, to_one, ratio](const std::size_t p, const NodeLanes &lanes) {
            const double fraction = lanes[NodeFluid::fraction.lane];
            residual[p]           = ratio[p] - lanes[NodeFluid::mean_ratio.lane];
            if (lanes[NodeFluid::near_surface.lane] == 0.)
              {
                error.sum += std::abs(fraction - 1.);
                error.n_particles += 1.;
              }
            ratio[p] *= 1. - way * lanes[NodeFluid::excess.lane];
            if (fraction < spray_fraction)
              ratio[p] += to_one * (1. - ratio[p]);
          };
      },
      bodies);
  }

  template <int dim>
  void
  scatter_residuals(std::vector<Body<dim>> &bodies,
                    const double bulk_modulus,
                    const Residuals &residuals,
                    const BlockSet<dim> &blocks,
                    const Lattice<dim> &lattice,
                    NodeField<dim, SingleScalar> &sums)
  {
    const double per_cell = cells_per_volume(lattice);
    scatter(
      bodies,
      blocks,
      lattice,
      is_fluid_of(bulk_modulus),
      [&](const Body<dim> &body, const auto &) {
        return [per_cell,
                volume   = body.particles.component(ParticleProperty::volume, 0),
                residual = residuals[&body - bodies.data()].data()](const auto place, auto &lanes) {
          lanes[SingleScalar::value.lane] = per_cell * load(volume, place) * load(residual, place);
        };
      },
      sums);
  }

  template <int dim>
  void
  take_noise(const NodeField<dim, SingleScalar> &means,
             const double bulk_modulus,
             const Residuals &residuals,
             const BlockSet<dim> &blocks,
             const Lattice<dim> &lattice,
             std::vector<Body<dim>> &bodies)
  {
    gather(
      means,
      blocks,
      lattice,
      is_fluid_of(bulk_modulus),
      [&](Body<dim> &body) {
        return [ratio    = body.particles.component(ParticleProperty::deformation, 0),
                residual = residuals[&body - bodies.data()].data()](const std::size_t p,
                                                                    const NodeLanes &lanes) {
          ratio[p] -= taken_noise * (residual[p] - lanes[SingleScalar::value.lane]);
        };
      },
      bodies);
  }

#define INSTANTIATE(dim)                                                                       \
  template bool has_fluid(const std::vector<Body<dim>> &);                                     \
  template std::vector<double> bulk_moduli(const std::vector<Body<dim>> &);                    \
  template void scatter_claims(std::vector<Body<dim>> &,                                       \
                               double,                                                         \
                               bool,                                                           \
                               const BlockSet<dim> &,                                          \
                               const Lattice<dim> &,                                           \
                               NodeField<dim, NodeClaims> &);                                  \
  template void find_excess(                                                                   \
    const BlockSet<dim> &, const NodeField<dim, SingleScalar> &, NodeField<dim, NodeFluid> &); \
  template void relax_volume_ratios(const NodeField<dim, NodeFluid> &,                         \
                                    double,                                                    \
                                    const BlockSet<dim> &,                                     \
                                    const Lattice<dim> &,                                      \
                                    double,                                                    \
                                    Residuals &,                                               \
                                    DensityError &,                                            \
                                    std::vector<Body<dim>> &);                                 \
  template void scatter_residuals(std::vector<Body<dim>> &,                                    \
                                  double,                                                      \
                                  const Residuals &,                                           \
                                  const BlockSet<dim> &,                                       \
                                  const Lattice<dim> &,                                        \
                                  NodeField<dim, SingleScalar> &);                             \
  template void take_noise(const NodeField<dim, SingleScalar> &,                               \
                           double,                                                             \
                           const Residuals &,                                                  \
                           const BlockSet<dim> &,                                              \
                           const Lattice<dim> &,                                               \
                           std::vector<Body<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
