#pragma once

#include <chrono>

namespace magmpm::benchmarks
{
  /** Wall time since it was made. */
  class Stopwatch
  {
  public:
    /** [s] */
    double
    seconds() const
    {
      return std::chrono::duration<double>(Clock::now() - start).count();
    }

  private:
    using Clock                   = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
  };
} // namespace magmpm::benchmarks
