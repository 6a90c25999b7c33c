#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>
#include <magmpm/parallel/ranks.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/simulation/command_line.h>
#include <magmpm/simulation/run.h>

#include <deal.II/base/mpi.h>

#include <iostream>

using namespace magmpm;

template <int dim>
static void
run_scene(const ParameterFile &file,
          const CommandLine &command_line,
          std::ostream &terminal,
          parallel::FailureLog &failures)
{
  const Parameters<dim> parameters = read_parameters<dim>(file);
  if (command_line.task == CommandLine::Task::run)
    return Run<dim>(parameters, MPI_COMM_WORLD, command_line.start).run(failures);

  terminal << file.name << ": valid" << std::endl;
  for (const std::string &warning : parameters.warnings)
    terminal << "warning: " << warning << std::endl;
}

static void
run_program(const CommandLine &command_line, std::ostream &terminal, parallel::FailureLog &failures)
{
  using Task = CommandLine::Task;
  if (command_line.task == Task::help)
    terminal << usage();
  else if (command_line.task == Task::version)
    terminal << version_string() << std::endl;
  else if (command_line.task == Task::print_parameters)
    terminal << parameter_manual();
  else
    {
      const ParameterFile file = read_parameter_file(command_line.file, command_line.overrides);
      if (read_dimension(file) == 2)
        run_scene<2>(file, command_line, terminal, failures);
      else
        run_scene<3>(file, command_line, terminal, failures);
    }
}

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // Of all ranks only the first is heard.
  std::ostream silence(nullptr);
  const bool first       = parallel::rank(MPI_COMM_WORLD) == 0;
  std::ostream &terminal = first ? std::cout : silence;
  return static_cast<int>(
    parallel::report_errors(MPI_COMM_WORLD, std::cerr, [&](parallel::FailureLog &failures) {
      run_program(parse_command_line({argv + 1, argv + argc}), terminal, failures);
    }));
}
