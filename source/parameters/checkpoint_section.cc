#include <magmpm/base/number_text.h>
#include <magmpm/parameters/checkpoint_section.h>

#include <regex>

namespace magmpm
{
  void
  declare_checkpoint(ParameterRegister &declarations, CheckpointParameters &checkpoint)
  {
    declarations.add_text(
      "Checkpoint every",
      "10 min",
      "s, min, h or frames",
      "When a checkpoint is written, from which 'magmpm --resume' goes on: after so much "
      "wall time (10 min, 2 h), after every so many frames (20 frames; then the same run "
      "gives the same numbers again), or never.");
    declarations.add("Checkpoints kept",
                     checkpoint.n_kept,
                     "-",
                     "Checkpoints that stay on the disk, the latest included.",
                     at_least_one);
    declarations.add_text(
      "End wall time",
      "never",
      "s, min or h",
      "Wall time after which the run finishes its step, writes a checkpoint and ends (11.5 h), "
      "or never. So do a file 'stop' in the output directory, SIGUSR1 and SIGTERM.");
  }

  void
  convert_checkpoint(const ParameterRegister &declarations, CheckpointParameters &checkpoint)
  {
    const std::string &every = declarations.value("Checkpoint every");
    const std::string &end   = declarations.value("End wall time");
    const std::regex frames("([1-9][0-9]{0,8}) frames?");
    std::smatch number;
    if (const auto seconds = seconds_from(every))
      checkpoint.wall_interval = *seconds;
    else if (std::regex_match(every, number, frames))
      checkpoint.every_n_frames = std::stoi(number[1]);
    else if (every != "never")
      throw declarations.error(
        "Checkpoint every",
        "must be a wall time (90 s, 10 min, 2 h), a number of frames (20 frames), "
        "or never.");

    if (const auto seconds = seconds_from(end))
      checkpoint.end_wall_time = *seconds;
    else if (end != "never")
      throw declarations.error("End wall time",
                               "must be a wall time (90 s, 10 min, 11.5 h) or never.");
  }
} // namespace magmpm
