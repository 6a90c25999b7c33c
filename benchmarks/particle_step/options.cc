#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_names.h>

#include <particle_step/options.h>

#include <algorithm>
#include <sstream>

namespace magmpm::benchmarks
{
  namespace
  {
    /** Numbers of at least one with commas between them. */
    std::vector<double>
    counts(const std::string &option, const std::string &text)
    {
      std::vector<double> values;
      std::istringstream list(text);
      for (std::string item; std::getline(list, item, ',');)
        {
          std::istringstream stream(item);
          double value = 0.;
          if (!(stream >> value) || !stream.eof() || !(value >= 1.))
            throw InputError("'" + item + "' cannot follow " + option +
                             ". Write a number of at least 1.");
          values.push_back(value);
        }
      if (values.empty())
        throw InputError("nothing follows " + option + ", but it takes a value.");
      return values;
    }
  } // namespace

  StepOptions
  parse_step_options(const std::vector<std::string> &arguments)
  {
    const std::vector<std::string> known = {"--help", "--particles", "--repeats", "--steps"};
    StepOptions options;
    for (std::size_t i = 0; i < arguments.size(); ++i)
      {
        const std::string &option = arguments[i];
        if (option == "--help")
          {
            options.help = true;
            continue;
          }
        if (std::find(known.begin(), known.end(), option) == known.end())
          throw InputError("unknown option '" + option + "'" + did_you_mean(option, known) +
                           " 'particle_step --help' lists all options.");
        const std::vector<double> values = counts(option,
                                                  ++i < arguments.size() ? arguments[i] : "");
        if (option == "--particles")
          options.particles = values;
        else
          (option == "--steps" ? options.steps : options.repeats) = static_cast<int>(values[0]);
      }
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
