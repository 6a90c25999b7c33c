#pragma once

#include <verification/program/paths.h>
#include <verification/program/program_run.h>

#include <string>

namespace magmpm::testing
{
  /**
   * Runs a file of parameter_files/ with other values (more --set), without fields and checkpoints. Its
   * results go to @p folder.
   */
  inline verification::Outcome
  run_parameter_file(const std::string &scene,
                     const std::string &folder,
                     const std::string &options)
  {
    return verification::run_magmpm(verification::source_folder() + "/parameter_files/" + scene +
                                    ".prm --set 'Output directory=" + folder +
                                    "' --set Output/Fields=false --set 'Checkpoint every=never' " +
                                    options);
  }
} // namespace magmpm::testing
