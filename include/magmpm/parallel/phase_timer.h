#pragma once

#include <mpi.h>

#include <chrono>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace magmpm::parallel
{
  /**
   * The wall time that a program spends in its phases, which may lie inside of one another. Every rank
   * measures for itself: nobody waits for anybody, and a rank that fails leaves no other waiting.
   */
  class PhaseTimer
  {
    struct Phase
    {
      unsigned long n_visits = 0;
      double seconds         = 0.; ///< of visits that are over
    };

  public:
    PhaseTimer();

    PhaseTimer(const PhaseTimer &) = delete;
    PhaseTimer &
    operator=(const PhaseTimer &) = delete;

    /** A visit of a phase: from here to the end of the block of code. */
    class Scope
    {
    public:
      Scope(PhaseTimer &timer, const std::string &phase);
      ~Scope();

      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;

    private:
      Phase &phase;
      const std::chrono::steady_clock::time_point start;
    };

    /** By phase [s], on this rank, of the visits that are over. */
    std::map<std::string, double>
    seconds() const;

    /**
     * A table of the phases in the order in which they were first met: how often (at most of the
     * ranks), and the least, mean and most time of all ranks, so that imbalance can be seen. Collective.
     */
    void
    print(const MPI_Comm communicator, std::ostream &stream) const;

  private:
    /** The phase of this name, which may be new. */
    Phase &
    phase(const std::string &name);

    const std::chrono::steady_clock::time_point start;
    std::map<std::string, Phase> phases;
    std::vector<std::string> order; ///< names of phases
  };
} // namespace magmpm::parallel
