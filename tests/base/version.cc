#include <magmpm/base/version.h>

#include "catch.h"

#include <regex>

// The version names the project, its commit, the libraries and the build type, in the form that the
// log of a run opens with. The pattern allows every version number and any commit.
TEST_CASE("The version names what the program was built from", "[base][version]")
{
  const std::regex pattern(
    R"(magmpm \d+\.\d+\.\d+ \(([0-9a-f]{7,}|unknown)\), deal\.II \d+\.\d+\.\d+, )"
    R"(Trilinos \d+\.\d+(\.\d+)?, p4est \d+\.\d+(\.\d+)*, (RELEASE|DEBUG))");

  INFO(magmpm::version_string());
  CHECK(std::regex_match(magmpm::version_string(), pattern));
}
