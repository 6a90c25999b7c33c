#include <magnetic_accuracy/options.h>

#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_names.h>

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>

namespace magmpm::benchmarks
{
  namespace
  {
    using Names = std::vector<std::string>;

    std::string
    joined(const Names &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
      return text;
    }

    Names
    split(const std::string &text)
    {
      Names names;
      std::istringstream stream(text);
      for (std::string name; std::getline(stream, name, ',');)
        names.push_back(name);
      return names;
    }

    const std::string &
    one_of(const std::string &option, const std::string &value, const Names &allowed)
    {
      const auto found = std::find(allowed.begin(), allowed.end(), value);
      if (found == allowed.end())
        throw InputError("'" + value + "' cannot follow " + option + did_you_mean(value, allowed) +
                         " Write one of: " + joined(allowed) + ".");
      return *found;
    }

    double
    positive_number(const std::string &option, const std::string &value)
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

    using Setter = std::function<void(Options &, const std::string &)>;

    std::map<std::string, Setter>
    options_with_value(const Names &groups)
    {
      return {
        {"--only",
         [groups](Options &options, const std::string &value) {
           for (const std::string &name : split(value))
             options.groups.push_back(one_of("--only", name, groups));
         }},
        {"--dimension",
         [](Options &options, const std::string &value) {
           options.dimensions = {std::stoi(one_of("--dimension", value, {"2", "3"}))};
         }},
        {"--max-resolution",
         [](Options &options, const std::string &value) {
           options.max_resolution = positive_number("--max-resolution", value);
         }},
        {"--offsets",
         [](Options &options, const std::string &value) {
           options.max_offsets =
             static_cast<unsigned int>(std::max(1., positive_number("--offsets", value)));
         }},
        {"--indicator",
         [](Options &options, const std::string &value) {
           const bool sharp  = one_of("--indicator", value, {"sharp", "smeared"}) == "sharp";
           options.indicator = (sharp ? MaterialIndicator::sharp : MaterialIndicator::smeared);
         }},
        {"--cell-edge",
         [](Options &options, const std::string &value) {
           options.cell_edge = std::stoi(one_of("--cell-edge", value, {"1", "2"}));
         }},
      };
    }

    const std::map<std::string, bool Options::*> switches = {{"--csv", &Options::csv},
                                                             {"--check", &Options::check},
                                                             {"--help", &Options::help}};
  } // namespace

  bool
  Options::wants(const std::string &group) const
  {
    return groups.empty() || std::find(groups.begin(), groups.end(), group) != groups.end();
  }

  Options
  parse_options(const std::vector<std::string> &arguments, const std::vector<std::string> &groups)
  {
    const std::map<std::string, Setter> setters = options_with_value(groups);
    Names known;
    for (const auto &setter : setters)
      known.push_back(setter.first);
    for (const auto &entry : switches)
      known.push_back(entry.first);

    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i)
      {
        const std::string &option = arguments[i];
        const auto setter         = setters.find(option);
        const auto entry          = switches.find(option);
        if (entry != switches.end())
          options.*(entry->second) = true;
        else if (setter == setters.end())
          throw InputError("unknown option '" + option + "'" + did_you_mean(option, known) +
                           " 'magnetic_accuracy --help' lists all options.");
        else if (++i == arguments.size())
          throw InputError("nothing follows " + option + ", but it takes a value.");
        else
          setter->second(options, arguments[i]);
      }
    return options;
  }

  std::string
  usage(const std::vector<std::string> &groups)
  {
    return R"(magnetic_accuracy [option]...

Compares the magnetic part of magmpm with exact solutions, and prints the relative errors: rms and
largest over random places of the body on the lattice.

  --only GROUP,...             of )" +
           joined(groups) + R"(
  --dimension 2|3              otherwise both
  --max-resolution R/dx        leaves finer cases away; default 16
  --offsets N                  places on the lattice at most; default 8
  --indicator sharp|smeared    how material is told from vacuum; default sharp
  --cell-edge 2|1              of the mesh at material, in dx; default 2
  --csv                        prints lines "name,value,limit" (value: rms) instead of a table
  --check                      exit code 1 if a limit is missed
  --help                       prints this

On several processor cores: mpirun -np 2 magnetic_accuracy
)";
  }
} // namespace magmpm::benchmarks
