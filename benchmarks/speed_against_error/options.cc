#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_names.h>

#include <speed_against_error/options.h>

#include <algorithm>
#include <map>

namespace magmpm::benchmarks
{
  namespace
  {
    const std::map<std::string, std::vector<ExperimentKind>> experiments_by_name = {
      {"sphere", {ExperimentKind::sphere_in_uniform_field}},
      {"dipole", {ExperimentKind::sphere_near_dipole}},
      {"cube", {ExperimentKind::cube_near_magnet}}};

    double
    positive(const std::string &option, const std::string &value)
    {
      std::size_t end = 0;
      double number   = 0.;
      try
        {
          number = std::stod(value, &end);
        }
      catch (const std::exception &)
        {
        }
      if (end != value.size() || !(number > 0.))
        throw InputError("'" + value + "' cannot follow " + option +
                         ". Write a number greater than zero.");
      return number;
    }

    /** The options that take a number, and where it goes. */
    std::map<std::string, double *>
    numbers(SpeedOptions &options)
    {
      return {{"--argument", &options.medium.argument},
              {"--max-resolution", &options.max_resolution},
              {"--max-seconds", &options.max_seconds},
              {"--reference", &options.reference},
              {"--repetitions", &options.repetitions},
              {"--susceptibility", &options.medium.susceptibility},
              {"--tolerance", &options.tolerance}};
    }
  } // namespace

  SpeedOptions
  parse_speed_options(const std::vector<std::string> &arguments)
  {
    SpeedOptions options;
    const auto by_name             = numbers(options);
    std::vector<std::string> known = {"--csv", "--help", "--only"};
    for (const auto &entry : by_name)
      known.push_back(entry.first);

    for (std::size_t i = 0; i < arguments.size(); ++i)
      {
        const std::string &option = arguments[i];
        const auto number         = by_name.find(option);
        if (option == "--help")
          {
            options.help = true;
            continue;
          }
        if (std::find(known.begin(), known.end(), option) == known.end())
          throw InputError("unknown option '" + option + "'" + did_you_mean(option, known) +
                           " 'speed_against_error --help' lists all options.");
        if (++i == arguments.size())
          throw InputError("nothing follows " + option + ", but it takes a value.");
        const std::string &value = arguments[i];
        if (number != by_name.end())
          *number->second = positive(option, value);
        else if (option == "--csv")
          options.csv_file = value;
        else if (experiments_by_name.count(value) == 1)
          options.experiments = experiments_by_name.at(value);
        else
          throw InputError("'" + value + "' cannot follow --only. Write sphere, dipole or cube.");
      }
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
