#pragma once

#include <magmpm/base/exceptions.h>

#include <functional>
#include <string>

namespace magmpm::parallel
{
  /** What became of an action, in a form that can be told to other ranks. */
  struct Failure
  {
    ExitCode exit_code = ExitCode::success;
    std::string message;
  };

  /**
   * Does @p action and turns its exception, if there is one, into an exit code (2 for an InputError, 1
   * for any other) and a message of one line, also if deal.II or the system threw.
   */
  Failure
  failure_of(const std::function<void()> &action);
} // namespace magmpm::parallel
