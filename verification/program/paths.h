#pragma once

#include <string>

/**
 * Where this build has what tests start and read. Functions and not macros: their absolute paths are
 * seen by one small file, so that a compiler cache serves all others in any folder.
 */
namespace magmpm::verification
{
  /** The folder of the source tree, with parameter_files/ and doc/ in it. */
  std::string
  source_folder();

  /** The program magmpm. */
  std::string
  magmpm_program();

  /** What starts a program on several ranks. */
  std::string
  mpiexec();
} // namespace magmpm::verification
