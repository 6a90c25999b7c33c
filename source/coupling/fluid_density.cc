#include <magmpm/boundary/body_share.h>
#include <magmpm/coupling/closed_walls.h>
#include <magmpm/coupling/fluid_density.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/parallel/reduce.h>

namespace magmpm
{
  namespace
  {
    /** Sets a quantity to sum over weight where there is a weight. */
    template <int dim, typename Quantities>
    void
    set_mean(const BlockSet<dim> &blocks,
             const NodeScalar<Quantities> mean,
             const NodeField<dim, NodeClaims> &weights,
             NodeField<dim, Quantities> &field)
    {
      for_nodes(blocks, [&](const int slot, const int n) {
        const double weight = weights.get(NodeClaims::undeformed, slot, n);
        field.set(mean, slot, n, weight > 0. ? field.get(mean, slot, n) / weight : 0.);
      });
    }
  } // namespace

  template <int dim>
  FluidDensity<dim>::FluidDensity(const Lattice<dim> &lattice, const OpenFaces<dim> &open)
    : lattice(lattice)
    , walls(closed_walls(lattice, open))
  {
  }

  template <int dim>
  void
  FluidDensity<dim>::relax(const Clock &clock,
                           const BlockPartition<dim> &partition,
                           const std::vector<RigidBody<dim>> &rigid_bodies,
                           std::vector<Body<dim>> &bodies)
  {
    relaxed_this_step = has_fluid(bodies) && clock.step % relaxation_period == 0;
    if (!relaxed_this_step)
      return;
    const BlockSet<dim> &blocks      = partition.blocks();
    const std::vector<double> moduli = bulk_moduli(bodies);
    const auto claims                = sum_claims(moduli, partition, bodies);
    NodeField<dim, NodeFluid> field(blocks.size());
    find_excess(blocks, sum_fractions(claims, partition, rigid_bodies), field);
    found = {};
    for (std::size_t i = 0; i < moduli.size(); ++i)
      {
        for_nodes(blocks, [&](const int slot, const int n) {
          field.set(NodeFluid::mean_ratio, slot, n, claims[i].get(NodeClaims::fluid, slot, n));
        });
        set_mean(blocks, NodeFluid::mean_ratio, claims[i], field);
        partition.update_ghosts(field);
        Residuals residuals;
        relax_volume_ratios(field,
                            moduli[i],
                            blocks,
                            lattice,
                            relaxation_period * clock.time_step,
                            residuals,
                            found,
                            bodies);
        smooth(moduli[i], claims[i], residuals, partition, bodies);
      }
  }

  template <int dim>
  std::vector<NodeField<dim, NodeClaims>>
  FluidDensity<dim>::sum_claims(const std::vector<double> &moduli,
                                const BlockPartition<dim> &partition,
                                std::vector<Body<dim>> &bodies) const
  {
    std::vector<NodeField<dim, NodeClaims>> claims;
    for (const double modulus : moduli)
      {
        claims.emplace_back(partition.blocks().size());
        const bool with_solids = claims.size() == 1; // once
        scatter_claims(bodies, modulus, with_solids, partition.blocks(), lattice, claims.back());
        partition.add_ghosts_to_owners(claims.back());
        partition.update_ghosts(claims.back());
      }
    return claims;
  }

  template <int dim>
  NodeField<dim, SingleScalar>
  FluidDensity<dim>::sum_fractions(const std::vector<NodeField<dim, NodeClaims>> &claims,
                                   const BlockPartition<dim> &partition,
                                   const std::vector<RigidBody<dim>> &rigid_bodies) const
  {
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, SingleScalar> fraction(blocks.size());
    for_nodes_and_ghosts(blocks, [&](const int slot, const int n) {
      for (const NodeField<dim, NodeClaims> &claim : claims)
        fraction.add(SingleScalar::value,
                     slot,
                     n,
                     claim.get(NodeClaims::fluid, slot, n) + claim.get(NodeClaims::solid, slot, n));
    });
    add_images(blocks, blocks.size(), walls, Parity(), fraction);
    add_share_in_bodies(rigid_bodies, blocks, lattice, fraction);
    partition.update_ghosts(fraction);
    return fraction;
  }

  template <int dim>
  void
  FluidDensity<dim>::smooth(const double bulk_modulus,
                            const NodeField<dim, NodeClaims> &claims,
                            const Residuals &residuals,
                            const BlockPartition<dim> &partition,
                            std::vector<Body<dim>> &bodies) const
  {
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, SingleScalar> sums(blocks.size());
    scatter_residuals(bodies, bulk_modulus, residuals, blocks, lattice, sums);
    partition.add_ghosts_to_owners(sums);
    set_mean(blocks, SingleScalar::value, claims, sums);
    partition.update_ghosts(sums);
    take_noise(sums, bulk_modulus, residuals, blocks, lattice, bodies);
  }

  template <int dim>
  void
  FluidDensity<dim>::reduce(parallel::Reduction &reduction)
  {
    if (!relaxed_this_step)
      return;
    reduction.sum(found.sum);
    reduction.sum(found.n_particles);
  }

  template <int dim>
  void
  FluidDensity<dim>::take_reduced()
  {
    if (relaxed_this_step)
      mean_error = (found.n_particles > 0. ? found.sum / found.n_particles : 0.);
  }

  template <int dim>
  void
  FluidDensity<dim>::add_columns(ColumnTable &table) const
  {
    table.add("density error", "-", [this] { return mean_error; });
  }

  template <int dim>
  SectionTitle
  FluidDensity<dim>::title() const
  {
    return {"fluid density", 1};
  }

  template <int dim>
  std::string
  FluidDensity<dim>::save() const
  {
    return pack(mean_error);
  }

  template <int dim>
  void
  FluidDensity<dim>::load(const std::string &bytes)
  {
    unpack(bytes, mean_error);
  }

  template class FluidDensity<2>;
  template class FluidDensity<3>;
} // namespace magmpm
