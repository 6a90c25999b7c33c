#pragma once

#include <string>
#include <vector>

namespace magmpm
{
  /** How the parameters of a run differ from those of the checkpoint that it resumes from. */
  struct ParameterChanges
  {
    /** Of what particles and lattice depend on; such a run cannot go on. "Box/Cell size = 0.1, was 0.2" */
    std::vector<std::string> critical;
    /** All others. */
    std::vector<std::string> allowed;
  };

  /**
   * Compares two complete sets of parameters. Critical are the dimension, the box, the bodies, the
   * mechanical law and the grains of the materials, and the magnetization law.
   *
   * @param now   Parameters::complete_text of the run.
   * @param then  the same of the checkpoint.
   */
  ParameterChanges
  parameter_changes(const std::string &now, const std::string &then);

  /**
   * The same for a run that is to go on.
   *
   * @return a line for each change that is allowed, each after a line break.
   * @throw InputError  names all changes that are critical.
   */
  std::string
  check_resumable(const std::string &now, const std::string &then);
} // namespace magmpm
