#include <deal.II/base/mpi.h>

#include <magmpm/domain_decomposition.h>
#include <magmpm/particles/particle_migration.h>

namespace magmpm
{
  template <int dim>
  DomainDecomposition<dim>::DomainDecomposition(const Parameters<dim> &parameters,
                                                const MPI_Comm communicator)
    : lattice(parameters.lattice)
    , communicator(communicator)
    , has_force(parameters.mesh.carries_potential)
    , background_mesh(communicator, parameters.lattice, parameters.mesh)
    , block_partition(background_mesh)
  {
  }

  template <int dim>
  typename DomainDecomposition<dim>::Regrouping
  DomainDecomposition<dim>::regroup(std::vector<Body<dim>> &bodies)
  {
    std::size_t n_lost = 0;
    for (Body<dim> &body : bodies)
      n_lost += remove_lost_particles(lattice, body);

    const OccupiedBlocks<dim> occupied = occupied_blocks(bodies, lattice, has_force);
    background_mesh.adapt(occupied.blocks, occupied.n_particles);
    const std::size_t n_migrated = migrate_to_owners(occupied, bodies);
    block_partition.rebuild(occupied_blocks(bodies, lattice, has_force).blocks);
    for (Body<dim> &body : bodies)
      sort_into_blocks(blocks(), lattice, body);
    return {dealii::Utilities::MPI::sum(n_lost, communicator),
            dealii::Utilities::MPI::sum(n_migrated, communicator)};
  }

  template <int dim>
  std::size_t
  DomainDecomposition<dim>::migrate_to_owners(const OccupiedBlocks<dim> &occupied,
                                              std::vector<Body<dim>> &bodies) const
  {
    const BlockSet<dim> occupied_set(occupied.blocks, static_cast<int>(occupied.blocks.size()));
    const std::vector<unsigned int> owners = background_mesh.owners(occupied.blocks);
    std::size_t n_sent                     = 0;
    for (Body<dim> &body : bodies)
      {
        std::vector<unsigned int> destination(body.particles.size());
        for (std::size_t p = 0; p < destination.size(); ++p)
          destination[p] =
            owners[occupied_set.slot(block_of<dim>(lattice.base_node(body.particles.position(p))))];
        n_sent += migrate_particles(communicator, destination, body.particles);
      }
    return n_sent;
  }

  template class DomainDecomposition<2>;
  template class DomainDecomposition<3>;
} // namespace magmpm
