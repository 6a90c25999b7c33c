#pragma once

#include <magmpm/parameters/run_parameters.h>

#include <chrono>
#include <string>

namespace magmpm
{
  /**
   * What is asked of a run from outside, while it runs: to end after the step it is in, or to write a
   * checkpoint because the last one is old. Asks for an end: SIGTERM, SIGINT (Ctrl-C; a
   * second one ends the program at once), SIGUSR1 (what batch systems send before their time limit), a
   * file `stop` in the output directory, and the end of the wall time.
   *
   * Each rank sees requests of its own; the largest of all ranks is that of the run.
   */
  class RunControl
  {
  public:
    enum class Request
    {
      none,
      checkpoint,
      stop_after_wall_time,
      stop_by_file,
      stop_by_signal,
      stop_by_interrupt
    };

    /** Takes the signals over. The clock starts. @param rank  of this process; rank 0 watches file and clock. */
    RunControl(const CheckpointParameters &parameters,
               const std::string &output_directory,
               const unsigned int rank);

    /** Gives the signals back to whoever handled them before. */
    ~RunControl();

    RunControl(const RunControl &) = delete;

    /** What is asked of this rank now. */
    Request
    request() const;

    /** A checkpoint was written: the next is due after the interval. */
    void
    restart_interval();

    /** A request to stop was obeyed: removes the file that made it. */
    void
    clear_stop_file() const;

    /** "SIGTERM or SIGUSR1" and the like; what made a run stop. */
    static std::string
    reason(const Request request);

  private:
    using Clock = std::chrono::steady_clock;

    const CheckpointParameters parameters;
    const std::string stop_file;
    const bool is_watching; ///< file and clock
    const Clock::time_point start;
    Clock::time_point last_checkpoint;
    static constexpr int n_signals = 3;
    void (*earlier_handlers[n_signals])(int);
  };
} // namespace magmpm
