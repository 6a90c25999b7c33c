#pragma once

#include <fstream>
#include <limits>
#include <string>

#include <malloc.h>

namespace magmpm::benchmarks
{
  /** Memory that the program took at most since this was made, as Linux counts it. */
  class MemoryGrowth
  {
  public:
    MemoryGrowth()
    {
      malloc_trim(0);                              // gives back what is free
      std::ofstream("/proc/self/clear_refs") << 5; // the peak is what it is now
      start = peak();
    }

    /** [B] */
    double
    bytes() const
    {
      return peak() - start;
    }

  private:
    static double
    peak()
    {
      std::ifstream status("/proc/self/status");
      for (std::string word; status >> word;)
        if (word == "VmHWM:")
          {
            double kilobytes = 0.;
            status >> kilobytes;
            return 1024. * kilobytes;
          }
      return std::numeric_limits<double>::quiet_NaN();
    }

    double start;
  };
} // namespace magmpm::benchmarks
