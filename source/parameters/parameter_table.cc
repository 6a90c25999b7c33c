#include <magmpm/parameters/parameter_names.h>
#include <magmpm/parameters/parameter_table.h>

#include <algorithm>
#include <utility>

namespace magmpm
{
  std::string
  joined_path(const std::string &section, const std::string &name)
  {
    return section.empty() ? name : section + "/" + name;
  }

  const DeclaredParameter *
  ParameterTable::find(const std::string &path) const
  {
    const auto found =
      std::find_if(declared.begin(), declared.end(), [&](const DeclaredParameter &parameter) {
        return parameter.path() == path;
      });
    return found == declared.end() ? nullptr : &*found;
  }

  DeclaredParameter *
  ParameterTable::find(const std::string &path)
  {
    return const_cast<DeclaredParameter *>(std::as_const(*this).find(path));
  }

  bool
  ParameterTable::has_section(const std::string &section) const
  {
    return section.empty() ||
           std::any_of(declared.begin(), declared.end(), [&](const DeclaredParameter &parameter) {
             return (parameter.section + "/").rfind(section + "/", 0) == 0;
           });
  }

  std::vector<const DeclaredParameter *>
  ParameterTable::parameters_in(const std::string &section) const
  {
    std::vector<const DeclaredParameter *> parameters;
    for (const DeclaredParameter &parameter : declared)
      if (parameter.section == section)
        parameters.push_back(&parameter);
    return parameters;
  }

  std::vector<std::string>
  ParameterTable::names_in(const std::string &section) const
  {
    std::vector<std::string> names;
    for (const DeclaredParameter *parameter : parameters_in(section))
      names.push_back(parameter->name);
    return names;
  }

  std::vector<std::string>
  ParameterTable::subsections_in(const std::string &section) const
  {
    const std::string prefix = section.empty() ? "" : section + "/";
    std::vector<std::string> names;
    for (const DeclaredParameter &parameter : declared)
      if (parameter.section.size() > prefix.size() && parameter.section.rfind(prefix, 0) == 0)
        {
          const std::string rest = parameter.section.substr(prefix.size());
          const std::string name = rest.substr(0, rest.find('/'));
          if (std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
        }
    return names;
  }

  const DeclaredParameter *
  ParameterTable::list_of_names(const std::string &section) const
  {
    for (const DeclaredParameter *parameter : parameters_in(section))
      if (parameter->name.rfind("List of ", 0) == 0)
        return parameter;
    return nullptr;
  }

  InputError
  ParameterTable::unknown_subsection(const ParameterEntry &entry) const
  {
    // The outermost name that is not known is the one to name.
    std::string section, unknown;
    for (const std::string &name : split(entry.section, '/'))
      {
        unknown = name;
        if (!has_section(joined_path(section, name)))
          break;
        section = joined_path(section, name);
      }
    const DeclaredParameter *list = list_of_names(section);
    return InputError(
      entry.origin + ": there is no subsection '" + unknown + "'" +
      (section.empty() ? "" : " in subsection " + section) +
      (list == nullptr ? "" : " ('" + list->path() + "' is '" + list->value + "')") +
      did_you_mean(unknown, subsections_in(section)));
  }

  InputError
  ParameterTable::unknown_parameter(const ParameterEntry &entry) const
  {
    const std::string start = entry.origin + ": there is no parameter '" + entry.name + "' " +
                              (entry.section.empty() ? "outside of all subsections"
                                                     : "in subsection " + entry.section);
    const auto reason = refused.find(entry.path());
    if (reason != refused.end())
      return InputError(start + ": " + reason->second);

    const std::vector<std::string> here = names_in(entry.section);
    if (!closest_name(entry.name, here).empty())
      return InputError(start + did_you_mean(entry.name, here));

    // Perhaps it is a name of another place.
    std::vector<std::string> everywhere;
    for (const DeclaredParameter &parameter : declared)
      everywhere.push_back(parameter.name);
    const std::string closest = closest_name(entry.name, everywhere);
    for (const DeclaredParameter &parameter : declared)
      if (parameter.name == closest)
        return InputError(start + "; did you mean '" + parameter.path() + "'?");
    return InputError(start + "; 'magmpm --print-parameters' lists all.");
  }
} // namespace magmpm
