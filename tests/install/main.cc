// magmpm as a library, found by its package: steps the cube above a magnet and prints the force on the magnet.

#include <magmpm/simulation/scene.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iostream>

int
main(int argc, char **argv)
{
  if (argc != 2)
    {
      std::cerr << "usage: pull_on_magnet cube_nonlinear.prm" << std::endl;
      return 2;
    }
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const magmpm::ParameterFile file =
    magmpm::read_parameter_file(argv[1], {"Box/Cell size=0.03125"}); // 6 cells an edge
  magmpm::Scene<3> scene(magmpm::read_parameters<3>(file), MPI_COMM_WORLD);
  scene.begin();
  for (int i = 0; i < 3; ++i)
    scene.step();

  const double force = scene.force_on_magnet("ball").force[2];
  std::cout << "force on the magnet after " << scene.time() << " s: " << force << " N" << std::endl;
  return std::isfinite(force) && force != 0. ? 0 : 1;
}
