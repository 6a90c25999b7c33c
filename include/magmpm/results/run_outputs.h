#pragma once

#include <magmpm/results/run_output.h>

#include <string>
#include <vector>

namespace magmpm
{
  /** All that this room may write, each as its output describes it. */
  const std::vector<RunOutput> &
  run_outputs();

  /**
   * Removes the frames of every kind that an earlier run left in @p directory, so that none lies
   * beside those of a new one. One rank only.
   *
   * @throw RunError  if one cannot be removed.
   */
  void
  remove_earlier_frames(const std::string &directory);
} // namespace magmpm
