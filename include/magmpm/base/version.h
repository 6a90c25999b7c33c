#pragma once

#include <string>

namespace magmpm
{
  /**
   * What this binary was built from, on one line: "magmpm 0.1.0 (3f2c1ab), deal.II 9.4.1,
   * Trilinos 13.2, p4est 2.2, RELEASE".
   *
   * In brackets the commit it was built on, or "unknown" outside a git clone. The last word is the
   * build type, in capitals so that nobody times a DEBUG build by accident.
   */
  std::string
  version_string();
} // namespace magmpm
