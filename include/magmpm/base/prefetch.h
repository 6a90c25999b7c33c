#pragma once

#include <cstddef>

namespace magmpm
{
  /**
   * Asks for arrays ahead of their use, a few cache lines at a time, so that the memory has time to
   * answer: a kernel that reads many arrays side by side has more of them than the processor follows
   * by itself, and all lines asked for at once would have to wait for one another.
   *
   * @tparam batch_size  doubles of each array.
   */
  template <int batch_size>
  class Prefetch
  {
  public:
    /** The next array, from @p address on. There is room for 32; the processor is left alone with more. */
    void
    add(const double *address)
    {
      if (n_arrays < max_arrays)
        addresses[n_arrays++] = address;
    }

    /** To be called after the last add(). */
    void
    finish()
    {
      // An address that is mapped nowhere would cost more than one asked for twice.
      for (int a = n_arrays; a < max_arrays; ++a)
        addresses[a] = addresses[0];
    }

    /**
     * Call number @p i of batch_size: lines of all arrays in equal parts. To be written to: @p write.
     */
    template <bool write>
    void
    ask(const int i) const
    {
      const int line  = i % lines_per_array;
      const int group = i / lines_per_array;
      for (int a = 0; a < arrays_per_call; ++a)
        __builtin_prefetch(addresses[group * arrays_per_call + a] + line * doubles_per_line, write);
    }

  private:
    static constexpr int doubles_per_line = 8;
    static constexpr int lines_per_array  = batch_size / doubles_per_line;
    static constexpr int arrays_per_call  = 4;
    static constexpr int max_arrays       = arrays_per_call * doubles_per_line;

    const double *addresses[max_arrays] = {};
    int n_arrays                        = 0;
  };
} // namespace magmpm
