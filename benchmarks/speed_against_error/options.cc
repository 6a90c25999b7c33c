#include <shared/command_line.h>
#include <speed_against_error/options.h>

#include <map>

namespace magmpm::benchmarks
{
  namespace
  {
    const std::map<std::string, std::vector<ExperimentKind>> experiments_by_name = {
      {"sphere", {ExperimentKind::sphere_in_uniform_field}},
      {"dipole", {ExperimentKind::sphere_near_dipole}},
      {"cube", {ExperimentKind::cube_near_magnet}}};
  } // namespace

  SpeedOptions
  parse_speed_options(const std::vector<std::string> &arguments)
  {
    SpeedOptions options;
    CommandLine line("speed_against_error");
    line.add_switch("--help", options.help);
    line.add_number("--argument", options.medium.argument);
    line.add_number("--max-resolution", options.max_resolution);
    line.add_number("--max-seconds", options.max_seconds);
    line.add_number("--reference", options.reference);
    line.add_number("--repetitions", options.repetitions);
    line.add_number("--susceptibility", options.medium.susceptibility);
    line.add_number("--tolerance", options.tolerance);
    line.add("--csv", [&](const std::string &value) { options.csv_file = value; });
    line.add("--only", [&](const std::string &value) {
      std::vector<std::string> names;
      for (const auto &entry : experiments_by_name)
        names.push_back(entry.first);
      options.experiments = experiments_by_name.at(one_of("--only", value, names));
    });
    line.read(arguments);
    return options;
  }

  std::string
  speed_usage()
  {
    return "speed_against_error [OPTION VALUE ...]\n"
           "  --only SCENE           sphere (in a uniform field), dipole (near a sphere) or cube; "
           "otherwise\n"
           "                         all three\n"
           "  --max-resolution N     R/dx at most (16); R is half the edge of a cube\n"
           "  --max-seconds S        what takes longer (cold) is left out on finer lattices (10)\n"
           "  --repetitions N        of each measurement at small R/dx, each at another place (4)\n"
           "  --argument A           a of Langevin's law in the sphere in the uniform field (1)\n"
           "  --susceptibility CHI   chi_0 (0.91)\n"
           "  --tolerance T          of Newton's method, relative (1e-6)\n"
           "  --reference N          R/dx of the cube that others are compared with (24)\n"
           "  --csv FILE             the table for plot_speed_against_error.py\n"
           "                         (speed_against_error.csv)\n";
  }
} // namespace magmpm::benchmarks
