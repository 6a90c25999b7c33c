#include <verification/magnetostatics/magnetic_setup.h>

namespace magmpm::verification
{
  template <int dim>
  MagneticSetup<dim>::MagneticSetup(const MPI_Comm communicator,
                                    const Lattice<dim> &lattice,
                                    const MeshParameters<dim> &mesh_parameters,
                                    const MagneticsParameters<dim> &magnetics)
    : communicator(communicator)
    , lattice(lattice)
    , mesh(communicator, lattice, mesh_parameters)
    , partition(mesh)
    , problem(mesh, partition, magnetics, timer)
  {
  }

  template struct MagneticSetup<2>;
  template struct MagneticSetup<3>;
} // namespace magmpm::verification
