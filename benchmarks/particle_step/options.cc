#include <particle_step/options.h>
#include <shared/command_line.h>

namespace magmpm::benchmarks
{
  StepOptions
  parse_step_options(const std::vector<std::string> &arguments)
  {
    StepOptions options;
    CommandLine line("particle_step");
    line.add_switch("--help", options.help);
    line.add("--particles", [&](const std::string &value) {
      options.particles.clear();
      for (const std::string &number : split(value))
        options.particles.push_back(number_from_one("--particles", number));
    });
    line.add("--repeats", [&](const std::string &value) {
      options.repeats = static_cast<int>(number_from_one("--repeats", value));
    });
    line.add("--steps", [&](const std::string &value) {
      options.steps = static_cast<int>(number_from_one("--steps", value));
    });
    line.read(arguments);
    return options;
  }

  std::string
  step_usage()
  {
    return "particle_step [OPTION VALUE ...]\n"
           "  --particles N[,N...]   about how many, one run each (110592)\n"
           "  --repeats N            of each measurement, the two codes taking turns (10)\n"
           "  --steps N              of a repeat, after one sort (40)\n";
  }
} // namespace magmpm::benchmarks
