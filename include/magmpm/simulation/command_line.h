#pragma once

#include <magmpm/simulation/start.h>

#include <string>
#include <vector>

namespace magmpm
{
  /** What the user asked for: magmpm FILE.prm [--resume] [--set "Section/Name=value"]... [option]. */
  struct CommandLine
  {
    enum class Task
    {
      run,
      validate,         ///< read and check the file, run nothing
      print_parameters, ///< the manual of all parameters, in Markdown
      version,
      help
    };

    Task task   = Task::run;
    Start start = Start::afresh;
    std::string file;                   ///< empty if the task needs none
    std::vector<std::string> overrides; ///< what follows each --set
  };

  /**
   * @param arguments   those behind the name of the program.
   * @throw InputError  an unknown option (with the one probably meant), no file, or too many.
   */
  CommandLine
  parse_command_line(const std::vector<std::string> &arguments);

  /** What --help says. */
  std::string
  usage();
} // namespace magmpm
