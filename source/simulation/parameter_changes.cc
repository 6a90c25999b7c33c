#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_file.h>
#include <magmpm/simulation/parameter_changes.h>

#include <map>
#include <set>

namespace magmpm
{
  namespace
  {
    std::map<std::string, std::string>
    values_by_path(const std::string &text)
    {
      std::map<std::string, std::string> values;
      for (const ParameterEntry &entry : parse_parameter_text(text, "parameters.prm").entries)
        values[entry.path()] = entry.value;
      return values;
    }

    bool
    is_critical(const std::string &path)
    {
      const auto begins_with = [&path](const std::string &start) {
        return path.compare(0, start.size(), start) == 0;
      };
      return path == "Dimension" || begins_with("Box/") || begins_with("Bodies/") ||
             begins_with("Materials/") || path == "Magnetics/Magnetization law" ||
             path == "Magnetics/Magnetization curve";
    }

    std::string
    listed(const std::vector<std::string> &lines)
    {
      std::string text;
      for (const std::string &line : lines)
        text += "\n  " + line;
      return text;
    }
  } // namespace

  ParameterChanges
  parameter_changes(const std::string &now, const std::string &then)
  {
    const auto values_now = values_by_path(now), values_then = values_by_path(then);
    std::set<std::string> paths;
    for (const auto &values : {values_now, values_then})
      for (const auto &[path, value] : values)
        paths.insert(path);

    ParameterChanges changes;
    for (const std::string &path : paths)
      {
        const auto value_in = [&path](const std::map<std::string, std::string> &values) {
          const auto found = values.find(path);
          return found == values.end() ? std::string("(not there)") : found->second;
        };
        if (value_in(values_now) != value_in(values_then))
          (is_critical(path) ? changes.critical : changes.allowed)
            .push_back(path + " = " + value_in(values_now) + ", was " + value_in(values_then));
      }
    return changes;
  }

  std::string
  check_resumable(const std::string &now, const std::string &then)
  {
    const ParameterChanges changes = parameter_changes(now, then);
    if (!changes.critical.empty())
      throw InputError(
        "this run cannot be resumed with other parameters of what its particles are:" +
        listed(changes.critical) + "\nPut these back, or start the run anew, without --resume.");
    return listed(changes.allowed);
  }
} // namespace magmpm
