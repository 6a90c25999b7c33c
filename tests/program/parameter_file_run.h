#pragma once

#include "program/program.h"

#include <string>

namespace magmpm::testing
{
  /**
   * Runs a file of parameter_files/ with other values (more --set), without fields and checkpoints. Its
   * results go to @p folder.
   */
  inline Outcome
  run_parameter_file(const std::string &scene,
                     const std::string &folder,
                     const std::string &options)
  {
    return run_magmpm(source_folder() + "/parameter_files/" + scene +
                      ".prm --set 'Output directory=" + folder +
                      "' --set Output/Fields=false --set 'Checkpoint every=never' " + options);
  }
} // namespace magmpm::testing
