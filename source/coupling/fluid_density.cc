#include <magmpm/coupling/fluid_density.h>
#include <magmpm/parallel/reduce.h>

namespace magmpm
{
  template <int dim>
  FluidDensity<dim>::FluidDensity(const Lattice<dim> &lattice, const OpenFaces<dim> &open)
    : lattice(lattice)
    , open(open)
  {
  }

  template <int dim>
  void
  FluidDensity<dim>::relax(const Clock &clock,
                           const BlockPartition<dim> &partition,
                           std::vector<Body<dim>> &bodies)
  {
    relaxed_this_step = has_fluid(bodies) && clock.step % relaxation_period == 0;
    if (!relaxed_this_step)
      return;
    const BlockSet<dim> &blocks = partition.blocks();
    const NodeField<dim, NodeFluid> field =
      fluid_on_nodes(blocks,
                     lattice,
                     open,
                     volume_fraction(bodies, undeformed_fluids(bodies), partition, lattice));
    found =
      relax_volume_ratios(field, blocks, lattice, relaxation_period * clock.time_step, bodies);
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
