#pragma once

#include <optional>
#include <string>

namespace magmpm::verification
{
  /**
   * What the error of a case (rms over offsets from the lattice) may be at most, with the sharp
   * indicator and the case's cells; no value where none is promised.
   *
   * @param group       of cases, as in "magnetic_accuracy --only GROUP".
   * @param variant     of the group, or "".
   * @param resolution  R/dx.
   * @param measure     name of the error.
   */
  std::optional<double>
  accuracy_limit(const int dim,
                 const std::string &group,
                 const std::string &variant,
                 const double resolution,
                 const std::string &measure);
} // namespace magmpm::verification
