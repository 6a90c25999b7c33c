#pragma once

#include <magmpm/magnetics/potential_problem.h>
#include <magmpm/mesh/background_mesh.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/parallel/phase_timer.h>

namespace magmpm::verification
{
  /** A lattice with its mesh, partition and potential: all that solves for the field, but no material. */
  template <int dim>
  struct MagneticSetup
  {
    /** @param lattice  spacing and mechanical box. */
    MagneticSetup(const MPI_Comm communicator,
                  const Lattice<dim> &lattice,
                  const MeshParameters<dim> &mesh_parameters,
                  const MagneticsParameters<dim> &magnetics);

    const MPI_Comm communicator;
    const Lattice<dim> lattice;
    BackgroundMesh<dim> mesh;
    BlockPartition<dim> partition;
    parallel::PhaseTimer timer;
    PotentialProblem<dim> problem;
  };
} // namespace magmpm::verification
