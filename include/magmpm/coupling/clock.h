#pragma once

namespace magmpm
{
  /** Where a scene is in time. */
  struct Clock
  {
    double time       = 0.; ///< of the start of the present step [s]
    double time_step  = 0.; ///< its length [s]
    unsigned int step = 0;  ///< its number, from 0

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &time;
      archive &time_step;
      archive &step;
    }
  };
} // namespace magmpm
