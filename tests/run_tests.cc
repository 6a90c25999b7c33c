// All that Catch2 2 keeps in its one header, compiled once for all test programs.

#define CATCH_CONFIG_RUNNER
#include "run_tests.h"
#include "catch.h"

int
run_tests(int argc, char **argv)
{
  return Catch::Session().run(argc, argv);
}
