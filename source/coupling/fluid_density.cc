#include <magmpm/parallel/reduce.h>

#include <magmpm/coupling/fluid_density.h>

namespace magmpm
{
  template <int dim>
  double
  relax_density(const double time,
                const BlockPartition<dim> &partition,
                const Lattice<dim> &lattice,
                const OpenFaces<dim> &open,
                const MPI_Comm communicator,
                NodeField<dim> &scratch,
                std::vector<Body<dim>> &bodies)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    fluid_fraction_to_lattice(bodies, blocks, lattice, scratch);
    partition.add_ghosts_to_owners(scratch);
    complete_fluid_fraction(blocks, lattice, open, scratch);
    partition.update_ghosts(scratch);
    const DensityError error = relax_volume_ratios(scratch, blocks, lattice, time, bodies);
    const double n_particles = parallel::sum(error.n_particles, communicator);
    const double sum         = parallel::sum(error.sum, communicator);
    return n_particles > 0. ? sum / n_particles : 0.;
  }

#define INSTANTIATE(dim)                                     \
  template double relax_density(double,                      \
                                const BlockPartition<dim> &, \
                                const Lattice<dim> &,        \
                                const OpenFaces<dim> &,      \
                                const MPI_Comm,              \
                                NodeField<dim> &,            \
                                std::vector<Body<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
