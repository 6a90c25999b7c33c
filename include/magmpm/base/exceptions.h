#pragma once

#include <stdexcept>
#include <string>

namespace magmpm
{
  /** What a program of this project returns to the shell. */
  enum class ExitCode : int
  {
    success     = 0,
    failed_run  = 1,
    wrong_input = 2
  };

  /**
   * The user asked for something that cannot be done: the message says what is wrong, which
   * input and value, what is allowed, and what to do. Ends the program with exit code 2.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * A run that was asked for correctly cannot go on (a particle ran away, a solver failed): the
   * message names what, where and when. Ends the program with exit code 1.
   */
  class RunError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace magmpm
