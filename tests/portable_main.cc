// The main function of portable_kernel_tests, which know neither deal.II nor MPI.

#include "run_tests.h"

int
main(int argc, char **argv)
{
  return run_tests(argc, argv);
}
