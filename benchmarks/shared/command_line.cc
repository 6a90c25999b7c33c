#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_names.h>

#include <shared/command_line.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace magmpm::benchmarks
{
  namespace
  {
    /** NaN if the text is more or less than a number. */
    double
    number_in(const std::string &text)
    {
      std::istringstream stream(text);
      double value = 0.;
      return stream >> value && stream.eof() ? value : std::numeric_limits<double>::quiet_NaN();
    }

    [[noreturn]] void
    refuse(const std::string &option, const std::string &value, const std::string &allowed)
    {
      throw InputError("'" + value + "' cannot follow " + option + ". Write " + allowed + ".");
    }
  } // namespace

  CommandLine::CommandLine(const std::string &program)
    : program(program)
  {
  }

  void
  CommandLine::add_switch(const std::string &option, bool &is_on)
  {
    switches[option] = &is_on;
  }

  void
  CommandLine::add(const std::string &option, const Action &action)
  {
    actions[option] = action;
  }

  void
  CommandLine::add_number(const std::string &option, double &number)
  {
    actions[option] = [option, &number](const std::string &value) {
      number = positive_number(option, value);
    };
  }

  std::vector<std::string>
  CommandLine::known() const
  {
    std::vector<std::string> options;
    for (const auto &entry : actions)
      options.push_back(entry.first);
    for (const auto &entry : switches)
      options.push_back(entry.first);
    return options;
  }

  void
  CommandLine::read(const std::vector<std::string> &arguments) const
  {
    for (std::size_t i = 0; i < arguments.size(); ++i)
      {
        const std::string &option = arguments[i];
        const auto is_on          = switches.find(option);
        const auto action         = actions.find(option);
        if (is_on != switches.end())
          *is_on->second = true;
        else if (action == actions.end())
          throw InputError("unknown option '" + option + "'" + did_you_mean(option, known()) + " " +
                           program + " has the options " + joined(known()) + ".");
        else if (++i == arguments.size())
          throw InputError("nothing follows " + option + ", but it takes a value.");
        else
          action->second(arguments[i]);
      }
  }

  std::vector<std::string>
  split(const std::string &list)
  {
    std::vector<std::string> items;
    std::istringstream stream(list);
    for (std::string item; std::getline(stream, item, ',');)
      items.push_back(item);
    return items;
  }

  std::string
  joined(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "" : ", ") + name;
    return text;
  }

  const std::string &
  one_of(const std::string &option,
         const std::string &value,
         const std::vector<std::string> &allowed)
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
    const double number = number_in(value);
    if (!(number > 0.))
      refuse(option, value, "a number greater than zero");
    return number;
  }

  double
  number_from_one(const std::string &option, const std::string &value)
  {
    const double number = number_in(value);
    if (!(number >= 1.))
      refuse(option, value, "a number of at least 1");
    return number;
  }
} // namespace magmpm::benchmarks
