#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_names.h>
#include <magmpm/simulation/command_line.h>

#include <map>

namespace magmpm
{
  namespace
  {
    using Task = CommandLine::Task;

    const std::map<std::string, Task> tasks = {{"--validate", Task::validate},
                                               {"--print-parameters", Task::print_parameters},
                                               {"--version", Task::version},
                                               {"--help", Task::help},
                                               {"-h", Task::help}};

    InputError
    unknown_option(const std::string &option)
    {
      std::vector<std::string> known = {"--set", "--resume", "--overwrite"};
      for (const auto &task : tasks)
        known.push_back(task.first);
      return InputError("unknown option '" + option + "'" + did_you_mean(option, known) +
                        " 'magmpm --help' lists all options.");
    }

    void
    set_start(const Start start, CommandLine &command_line)
    {
      if (command_line.start != Start::afresh && command_line.start != start)
        throw InputError(
          "--resume goes on with the earlier results, --overwrite replaces them: give "
          "one of the two.");
      command_line.start = start;
    }
  } // namespace

  CommandLine
  parse_command_line(const std::vector<std::string> &arguments)
  {
    CommandLine command_line;
    for (std::size_t i = 0; i < arguments.size(); ++i)
      {
        const std::string &argument = arguments[i];
        const auto task             = tasks.find(argument);
        if (task != tasks.end())
          command_line.task = task->second;
        else if (argument == "--resume" || argument == "--overwrite")
          set_start(argument == "--resume" ? Start::resume : Start::overwrite, command_line);
        else if (argument == "--set")
          {
            if (++i == arguments.size())
              throw InputError("nothing follows --set; write --set \"Section/Name=value\".");
            command_line.overrides.push_back(arguments[i]);
          }
        else if (argument.rfind('-', 0) == 0)
          throw unknown_option(argument);
        else if (command_line.file.empty())
          command_line.file = argument;
        else
          throw InputError("there are two parameter files, '" + command_line.file + "' and '" +
                           argument +
                           "', but a run takes one. If the second is a value, put it in "
                           "quotes: --set \"Section/Name=value\".");
      }

    const bool needs_file = command_line.task == Task::run || command_line.task == Task::validate;
    if (needs_file && command_line.file.empty())
      throw InputError("no parameter file is given. Write 'magmpm FILE.prm'; 'magmpm --help' tells "
                       "more.");
    return command_line;
  }

  std::string
  usage()
  {
    return R"(magmpm FILE.prm [--resume] [--set "Section/Name=value"]... [--validate] [--overwrite]
magmpm --print-parameters | --version | --help

Simulates the scene of the parameter file; its results go into the folder output-FILE.

  --set "Section/Name=value"  overrides a value of the file, as in --set "Bodies/cube/Density=1000"
  --resume                    goes on from the latest checkpoint of the scene
  --overwrite                 starts anew where an earlier run left a checkpoint, and removes its results
  --validate                  reads and checks the file, and runs nothing
  --print-parameters          prints the manual of all parameters (Markdown)
  --version                   prints the versions of magmpm and its libraries
  --help                      prints this

On several processor cores: mpirun -np 2 magmpm FILE.prm
Exit code: 0 success, 1 the run failed, 2 the command line or the parameter file is wrong.
)";
  }
} // namespace magmpm
