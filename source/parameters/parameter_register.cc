#include <magmpm/parameters/parameter_names.h>
#include <magmpm/parameters/parameter_register.h>

#include <algorithm>
#include <stdexcept>

namespace magmpm
{
  ParameterRegister::Section::Section(ParameterRegister &parameters, const std::string &name)
    : parameters(parameters)
    , outer(parameters.current_section)
  {
    parameters.current_section = joined_path(outer, name);
  }

  ParameterRegister::Section::~Section()
  {
    parameters.current_section = outer;
  }

  void
  ParameterRegister::add(const std::string &name,
                         double &variable,
                         const std::string &unit,
                         const std::string &text,
                         const NumberRange &range,
                         const Presence presence)
  {
    add_numbers(name, &variable, 1, unit, text, range, presence);
  }

  void
  ParameterRegister::add(const std::string &name,
                         int &variable,
                         const std::string &unit,
                         const std::string &text,
                         const NumberRange &range)
  {
    declare(name,
            std::to_string(variable),
            range.in_words(1, true),
            unit,
            text,
            Presence::has_default,
            [&variable, range](const std::string &value) {
              double number = 0.;
              if (!read_numbers(value, range, 1, &number) || number != static_cast<int>(number))
                return false;
              variable = static_cast<int>(number);
              return true;
            });
  }

  void
  ParameterRegister::add_or_auto(const std::string &name,
                                 double &variable,
                                 const std::string &unit,
                                 const std::string &text,
                                 const NumberRange &range)
  {
    const std::string word = "auto";
    declare(name,
            word,
            word + ", or " + range.in_words(1, false),
            unit,
            text,
            Presence::has_default,
            [&variable, range, word](const std::string &value) {
              if (value != word)
                return read_numbers(value, range, 1, &variable);
              variable = 0.;
              return true;
            });
  }

  void
  ParameterRegister::add(const std::string &name, bool &variable, const std::string &text)
  {
    add(name, variable, {{"true", true}, {"false", false}}, text);
  }

  void
  ParameterRegister::add(const std::string &name,
                         std::string &variable,
                         const std::string &unit,
                         const std::string &text,
                         const Presence presence)
  {
    declare(name,
            presence == Presence::has_default ? variable : "",
            "a text",
            unit,
            text,
            presence,
            [&variable](const std::string &value) {
              variable = value;
              return true;
            });
  }

  void
  ParameterRegister::add_text(const std::string &name,
                              const std::string &default_value,
                              const std::string &unit,
                              const std::string &text)
  {
    declare(name,
            default_value,
            "a text",
            unit,
            text,
            default_value.empty() ? Presence::optional : Presence::has_default,
            [](const std::string &) { return true; });
  }

  void
  ParameterRegister::add(const std::string &name,
                         std::vector<std::string> &variable,
                         const std::vector<std::string> &choices,
                         const std::string &text)
  {
    declare(name,
            comma_separated(variable),
            choices.empty() ? "names, separated by commas" : "any of: " + comma_separated(choices),
            "-",
            text,
            Presence::has_default,
            [&variable, choices](const std::string &value) {
              const std::vector<std::string> names = split(value, ',');
              for (const std::string &given : names)
                if (!choices.empty() &&
                    std::find(choices.begin(), choices.end(), given) == choices.end())
                  return false;
              variable = names;
              return true;
            });
  }

  void
  ParameterRegister::add_numbers(const std::string &name,
                                 double *variable,
                                 const int n,
                                 const std::string &unit,
                                 const std::string &text,
                                 const NumberRange &range,
                                 const Presence presence)
  {
    std::string default_value;
    if (presence == Presence::has_default)
      for (int i = 0; i < n; ++i)
        default_value += (i == 0 ? "" : ", ") + exact_text(variable[i]);

    declare(name,
            default_value,
            range.in_words(n, false),
            unit,
            text,
            presence,
            [variable, n, range, presence](const std::string &value) {
              if (value.empty())
                return presence != Presence::has_default;
              return read_numbers(value, range, n, variable);
            });
  }

  void
  ParameterRegister::add_choice(const std::string &name,
                                const std::string &default_name,
                                const std::vector<std::string> &names,
                                const std::string &text,
                                const std::function<void(const std::string &)> &action)
  {
    declare(name,
            default_name,
            (names.size() > 1 ? "one of: " : "only: ") + comma_separated(names),
            "-",
            text,
            Presence::has_default,
            [names, action](const std::string &value) {
              if (std::find(names.begin(), names.end(), value) == names.end())
                return false;
              action(value);
              return true;
            });
  }

  void
  ParameterRegister::declare(const std::string &name,
                             const std::string &default_value,
                             const std::string &range,
                             const std::string &unit,
                             const std::string &text,
                             const Presence presence,
                             const std::function<bool(const std::string &)> &read)
  {
    if (!read(default_value))
      throw std::logic_error("the default of the parameter '" + name + "' is not allowed");
    table.add(
      {current_section, name, default_value, range, unit, text, presence, read, default_value, ""});
  }

  void
  ParameterRegister::refuse(const std::string &name, const std::string &reason)
  {
    table.refuse(joined_path(current_section, name), reason);
  }

  void
  ParameterRegister::apply(const ParameterFile &file)
  {
    // First the texts, which messages name.
    file_name = file.name;
    for (const ParameterEntry &entry : file.entries)
      if (DeclaredParameter *parameter = table.find(entry.path()))
        {
          parameter->value  = entry.value;
          parameter->origin = entry.origin;
        }
    check_names(file);
    for (const ParameterEntry &entry : file.entries)
      if (const DeclaredParameter *parameter = table.find(entry.path()))
        if (!parameter->read(entry.value))
          throw InputError(entry.origin + ": " + entry.path() + " = " + entry.value + ": " +
                           parameter->must_be());

    for (const DeclaredParameter &parameter : table.all())
      if (parameter.presence == Presence::required && !given(parameter.path()))
        throw InputError(where(parameter.path()) + " is not given; it " + parameter.must_be());
  }

  void
  ParameterRegister::check_names(const ParameterFile &file)
  {
    // First the parameters: a mistyped list makes its subsections unknown, but is the one at fault.
    for (const ParameterEntry &entry : file.entries)
      if (table.has_section(entry.section) && table.find(entry.path()) == nullptr)
        throw table.unknown_parameter(entry);
    for (const ParameterEntry &subsection : file.subsections)
      if (!table.has_section(subsection.section))
        leave_out(subsection);
    for (const ParameterEntry &entry : file.entries)
      if (!table.has_section(entry.section) && entry.from_command_line)
        throw table.unknown_subsection(entry);
  }

  void
  ParameterRegister::leave_out(const ParameterEntry &entry)
  {
    // A magnet, say, may be switched off in its list; but a name close to one that is listed is a
    // slip of the pen.
    const std::size_t slash       = entry.section.find_last_of('/');
    const std::string section     = entry.section.substr(0, slash);
    const DeclaredParameter *list = table.list_of_names(section);
    if (slash == std::string::npos || list == nullptr ||
        !closest_name(entry.section.substr(slash + 1), table.subsections_in(section)).empty())
      throw table.unknown_subsection(entry);
    all_warnings.push_back(entry.origin + ": the subsection " + entry.section +
                           " is not used, because it is not in '" + list->path() + "'.");
  }

  void
  ParameterRegister::set_value(const std::string &path, const std::string &value)
  {
    DeclaredParameter *parameter = table.find(path);
    if (parameter == nullptr || !parameter->read(value))
      throw std::logic_error("the parameter '" + path + "' cannot be '" + value + "'");
    parameter->value = value;
  }

  const DeclaredParameter &
  ParameterRegister::declared(const std::string &path) const
  {
    const DeclaredParameter *parameter = table.find(path);
    if (parameter == nullptr)
      throw std::logic_error("there is no parameter '" + path + "'");
    return *parameter;
  }

  bool
  ParameterRegister::given(const std::string &path) const
  {
    // What a scene of this dimension refuses was not given either.
    return !table.is_refused(path) && !declared(path).value.empty();
  }

  std::string
  ParameterRegister::where(const std::string &path) const
  {
    const DeclaredParameter *parameter = table.find(path);
    const bool is_in_file              = parameter != nullptr && !parameter->origin.empty();
    return (is_in_file ? parameter->origin : file_name) + ": " + path;
  }

  std::string
  ParameterRegister::folder() const
  {
    const std::size_t slash = file_name.find_last_of('/');
    return slash == std::string::npos ? "" : file_name.substr(0, slash + 1);
  }

  InputError
  ParameterRegister::error(const std::string &path, const std::string &explanation) const
  {
    const std::string &value = declared(path).value;
    return InputError(where(path) + (value.empty() ? " is not given: " : " = " + value + ": ") +
                      explanation);
  }
} // namespace magmpm
