// The main function of portable_kernel_tests, which know neither deal.II nor MPI.

#define CATCH_CONFIG_MAIN
#include "catch.h"
