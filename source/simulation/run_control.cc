#include <magmpm/simulation/run_control.h>

#include <csignal>
#include <filesystem>

namespace magmpm
{
  namespace
  {
    constexpr int signals[] = {SIGTERM, SIGUSR1, SIGINT};

    volatile std::sig_atomic_t signal_arrived = 0;

    void
    note_signal(const int signal)
    {
      signal_arrived = signal;
      // Whoever presses Ctrl-C again will not wait.
      if (signal == SIGINT)
        std::signal(SIGINT, SIG_DFL);
    }

    double
    seconds_since(const std::chrono::steady_clock::time_point start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  } // namespace

  RunControl::RunControl(const CheckpointParameters &parameters,
                         const std::string &output_directory,
                         const unsigned int rank)
    : parameters(parameters)
    , stop_file(output_directory + "/stop")
    , is_watching(rank == 0)
    , start(Clock::now())
    , last_checkpoint(start)
  {
    clear_stop_file(); // one that is left from an earlier run asks nothing of this one
    signal_arrived = 0;
    for (int s = 0; s < n_signals; ++s)
      earlier_handlers[s] = std::signal(signals[s], note_signal);
  }

  RunControl::~RunControl()
  {
    for (int s = 0; s < n_signals; ++s)
      std::signal(signals[s], earlier_handlers[s]);
  }

  RunControl::Request
  RunControl::request() const
  {
    if (signal_arrived != 0)
      return signal_arrived == SIGINT ? Request::stop_by_interrupt : Request::stop_by_signal;
    std::error_code ignored; // a file that cannot be seen is not there
    if (is_watching && std::filesystem::exists(stop_file, ignored))
      return Request::stop_by_file;
    if (is_watching && seconds_since(start) > parameters.end_wall_time)
      return Request::stop_after_wall_time;
    if (is_watching && seconds_since(last_checkpoint) > parameters.wall_interval)
      return Request::checkpoint;
    return Request::none;
  }

  void
  RunControl::restart_interval()
  {
    last_checkpoint = Clock::now();
  }

  void
  RunControl::clear_stop_file() const
  {
    std::error_code ignored;
    if (is_watching)
      std::filesystem::remove(stop_file, ignored);
  }

  std::string
  RunControl::reason(const Request request)
  {
    switch (request)
      {
        case Request::stop_by_signal:
          return "SIGTERM or SIGUSR1";
        case Request::stop_by_interrupt:
          return "Ctrl-C";
        case Request::stop_by_file:
          return "the file 'stop'";
        case Request::stop_after_wall_time:
          return "End wall time";
        default:
          return "no request";
      }
  }
} // namespace magmpm
