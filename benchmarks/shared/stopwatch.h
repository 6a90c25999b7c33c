#pragma once

#include <ctime>

namespace magmpm::benchmarks
{
  /**
   * Time that this program has spent computing since the watch was made: with one thread, the wall
   * time of a core of its own. On a shared machine wall time also has what others took.
   */
  class Stopwatch
  {
  public:
    /** [s] */
    double
    seconds() const
    {
      return now() - start;
    }

  private:
    const double start = now();

    static double
    now()
    {
      std::timespec time;
      clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
      return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }
  };
} // namespace magmpm::benchmarks
