#include <magmpm/parameters/parameter_names.h>
#include <magmpm/parameters/parameter_register.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <locale>
#include <sstream>

namespace magmpm
{
  namespace
  {
    std::string
    to_text(const double number)
    {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text.precision(15);
      text << number;
      return text.str();
    }

    std::vector<std::string>
    split_at_commas(const std::string &text)
    {
      return dealii::Utilities::split_string_list(text, ',');
    }

    /** All of @p text as a number; false if it is none. */
    bool
    read_number(const std::string &text, double &number)
    {
      std::istringstream stream(text);
      stream.imbue(std::locale::classic());
      return static_cast<bool>(stream >> number) && (stream >> std::ws).eof();
    }

    std::string
    join(const std::string &section, const std::string &name)
    {
      return section.empty() ? name : section + "/" + name;
    }

    /** What is allowed, and what it means: the end of a message. */
    std::string
    must_be(const DeclaredParameter &parameter)
    {
      return "must be " + parameter.range +
             (parameter.unit == "-" ? "" : " [" + parameter.unit + "]") + ". (" + parameter.text +
             ")";
    }

    /**
     * Numbers in a range, separated by commas; ParameterHandler has no excluded limits. In their
     * place may stand nothing, or a word.
     */
    class NumberPattern : public dealii::Patterns::PatternBase
    {
    public:
      NumberPattern(const NumberRange &range,
                    const int n,
                    const bool integer,
                    const bool may_be_empty,
                    const std::string &word = "")
        : range(range)
        , n(n)
        , integer(integer)
        , may_be_empty(may_be_empty)
        , word(word)
      {
      }

      bool
      match(const std::string &text) const override
      {
        if (text.empty() ? may_be_empty : text == word)
          return true;
        const std::vector<std::string> parts = split_at_commas(text);
        double number;
        return static_cast<int>(parts.size()) == n &&
               std::all_of(parts.begin(), parts.end(), [&](const std::string &part) {
                 return read_number(part, number) && range.contains(number) &&
                        (!integer || number == static_cast<int>(number));
               });
      }

      std::string
      description(const OutputStyle /*style*/ = Machine) const override
      {
        if (n > 1)
          return std::to_string(n) + " numbers, separated by commas";
        const std::string limits = range.description();
        return (word.empty() ? "" : word + ", or ") +
               std::string(integer ? "an integer" : "a number") +
               (limits.empty() ? "" : " " + limits);
      }

      std::unique_ptr<PatternBase>
      clone() const override
      {
        return std::make_unique<NumberPattern>(*this);
      }

    private:
      const NumberRange range;
      const int n;
      const bool integer;
      const bool may_be_empty;
      const std::string word;
    };
  } // namespace

  bool
  NumberRange::contains(const double number) const
  {
    return (minimum_excluded ? number > minimum : number >= minimum) &&
           (maximum_excluded ? number < maximum : number <= maximum);
  }

  std::string
  NumberRange::description() const
  {
    if (minimum == any_number.minimum)
      return "";
    if (maximum == any_number.maximum)
      return (minimum_excluded ? "> " : ">= ") + to_text(minimum);
    if (minimum_excluded || maximum_excluded)
      return "above " + to_text(minimum) + " and below " + to_text(maximum);
    return "from " + to_text(minimum) + " to " + to_text(maximum);
  }

  ParameterRegister::ParameterRegister()
    : handler(std::make_unique<dealii::ParameterHandler>())
  {
  }

  ParameterRegister::~ParameterRegister() = default;

  ParameterRegister::Section::Section(ParameterRegister &parameters, const std::string &name)
    : parameters(parameters)
    , outer(parameters.current_section)
  {
    parameters.handler->enter_subsection(name);
    parameters.current_section = join(outer, name);
  }

  ParameterRegister::Section::~Section()
  {
    parameters.handler->leave_subsection();
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
    const NumberPattern pattern(range, 1, true, false);
    declare({current_section,
             name,
             std::to_string(variable),
             pattern.description(),
             unit,
             text,
             Presence::has_default},
            pattern,
            [&variable](const std::string &value) {
              double number = 0.;
              read_number(value, number);
              variable = static_cast<int>(number);
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
    const NumberPattern pattern(range, 1, false, false, word);
    declare({current_section, name, word, pattern.description(), unit, text, Presence::has_default},
            pattern,
            [&variable, word](const std::string &value) {
              variable = 0.;
              if (value != word)
                read_number(value, variable);
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
    const std::string default_value = (presence == Presence::has_default) ? variable : "";
    declare({current_section, name, default_value, "a text", unit, text, presence},
            dealii::Patterns::Anything(),
            [&variable](const std::string &value) { variable = value; });
  }

  void
  ParameterRegister::add(const std::string &name,
                         std::vector<std::string> &variable,
                         const std::vector<std::string> &choices,
                         const std::string &text)
  {
    const std::string range = choices.empty() ? "names, separated by commas"
                                              : "any of: " + comma_separated(choices);
    const auto action       = [&variable](const std::string &value) {
      variable = split_at_commas(value);
    };
    const DeclaredParameter parameter{
      current_section, name, comma_separated(variable), range, "-", text, Presence::has_default};

    if (choices.empty())
      declare(parameter, dealii::Patterns::Anything(), action);
    else
      declare(parameter,
              dealii::Patterns::List(dealii::Patterns::Selection(
                dealii::Utilities::replace_in_string(comma_separated(choices), ", ", "|"))),
              action);
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
        default_value += (i == 0 ? "" : ", ") + to_text(variable[i]);

    const NumberPattern pattern(range, n, false, presence != Presence::has_default);
    declare({current_section, name, default_value, pattern.description(), unit, text, presence},
            pattern,
            [variable, n](const std::string &value) {
              const std::vector<std::string> parts = split_at_commas(value);
              if (!value.empty())
                for (int i = 0; i < n; ++i)
                  read_number(parts[i], variable[i]);
            });
  }

  void
  ParameterRegister::add_choice(const std::string &name,
                                const std::string &default_name,
                                const std::vector<std::string> &names,
                                const std::string &text,
                                const std::function<void(const std::string &)> &action)
  {
    const std::string list  = comma_separated(names);
    const std::string range = (names.size() > 1 ? "one of: " : "only: ") + list;
    declare({current_section, name, default_name, range, "-", text, Presence::has_default},
            dealii::Patterns::Selection(dealii::Utilities::replace_in_string(list, ", ", "|")),
            action);
  }

  void
  ParameterRegister::declare(const DeclaredParameter &parameter,
                             const dealii::Patterns::PatternBase &pattern,
                             const std::function<void(const std::string &)> &action)
  {
    const std::string unit = parameter.unit == "-" ? "" : " [" + parameter.unit + "]";
    handler->declare_entry(parameter.name, parameter.default_value, pattern, parameter.text + unit);
    handler->add_action(parameter.name, action);
    values[join(current_section, parameter.name)] = parameter.default_value;
    declared.push_back(parameter);
  }

  void
  ParameterRegister::refuse(const std::string &name, const std::string &reason)
  {
    refused[join(current_section, name)] = reason;
  }

  void
  ParameterRegister::apply(const ParameterFile &file)
  {
    file_name = file.name;
    for (const ParameterEntry &entry : file.entries)
      if (find(entry.path()) != nullptr)
        {
          values[entry.path()]  = entry.value;
          origins[entry.path()] = entry.origin;
        }
    check_names(file);
    for (const ParameterEntry &entry : file.entries)
      if (find(entry.path()) != nullptr)
        apply(entry);

    for (const DeclaredParameter &parameter : declared)
      {
        const std::string path = join(parameter.section, parameter.name);
        if (parameter.presence == Presence::required && !given(path))
          throw InputError(where(path) + " is not given; it " + must_be(parameter));
      }
  }

  void
  ParameterRegister::check_names(const ParameterFile &file)
  {
    // First the parameters: a mistyped list makes its subsections unknown, but is the one at fault.
    for (const ParameterEntry &entry : file.entries)
      if (has_section(entry.section) && find(entry.path()) == nullptr)
        throw unknown_parameter(entry);
    for (const ParameterEntry &subsection : file.subsections)
      if (!has_section(subsection.section))
        leave_out(subsection);
    for (const ParameterEntry &entry : file.entries)
      if (!has_section(entry.section) && entry.from_command_line)
        throw unknown_subsection(entry);
  }

  void
  ParameterRegister::leave_out(const ParameterEntry &entry)
  {
    // A magnet, say, may be switched off in its list; but a name close to one that is listed is a
    // slip of the pen.
    const std::size_t slash   = entry.section.find_last_of('/');
    const std::string section = entry.section.substr(0, slash);
    if (slash == std::string::npos || list_of_names(section).empty() ||
        !closest_name(entry.section.substr(slash + 1), subsections_in(section)).empty())
      throw unknown_subsection(entry);
    all_warnings.push_back(entry.origin + ": the subsection " + entry.section +
                           " is not used, because it is not in '" + list_of_names(section) + "'.");
  }

  void
  ParameterRegister::apply(const ParameterEntry &entry)
  {
    try
      {
        set_printed_value(entry.path(), entry.value);
      }
    catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
      {
        throw InputError(entry.origin + ": " + entry.path() + " = " + entry.value + ": " +
                         must_be(*find(entry.path())));
      }
  }

  void
  ParameterRegister::set_printed_value(const std::string &path, const std::string &value)
  {
    std::vector<std::string> names = dealii::Utilities::split_string_list(path, '/');
    const std::string name         = names.back();
    names.pop_back();

    const auto leave_subsections = [&]() {
      for (std::size_t i = 0; i < names.size(); ++i)
        handler->leave_subsection();
    };

    for (const std::string &section : names)
      handler->enter_subsection(section);
    try
      {
        handler->set(name, value);
      }
    catch (...)
      {
        leave_subsections();
        throw;
      }
    leave_subsections();
  }

  bool
  ParameterRegister::given(const std::string &path) const
  {
    return !values.at(path).empty();
  }

  std::string
  ParameterRegister::where(const std::string &path) const
  {
    const auto origin = origins.find(path);
    return (origin == origins.end() ? file_name : origin->second) + ": " + path;
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
    const std::string &value = values.at(path);
    return InputError(where(path) + (value.empty() ? " is not given: " : " = " + value + ": ") +
                      explanation);
  }

  std::string
  ParameterRegister::print() const
  {
    std::stringstream printed;
    handler->print_parameters(
      printed, dealii::ParameterHandler::PRM | dealii::ParameterHandler::KeepDeclarationOrder);
    // Where there is no default, no comment should say what it is.
    const std::string no_default = "# default: ";
    std::string line, text;
    while (std::getline(printed, line))
      {
        const std::size_t comment = line.rfind(no_default);
        if (comment != std::string::npos && comment + no_default.size() == line.size())
          line.erase(line.find_last_not_of(' ', comment - 1) + 1);
        text += line + "\n";
      }
    return text;
  }

  bool
  ParameterRegister::has_section(const std::string &section) const
  {
    return section.empty() ||
           std::any_of(declared.begin(), declared.end(), [&](const DeclaredParameter &parameter) {
             return (parameter.section + "/").rfind(section + "/", 0) == 0;
           });
  }

  const DeclaredParameter *
  ParameterRegister::find(const std::string &path) const
  {
    for (const DeclaredParameter &parameter : declared)
      if (join(parameter.section, parameter.name) == path)
        return &parameter;
    return nullptr;
  }

  std::vector<std::string>
  ParameterRegister::names_in(const std::string &section) const
  {
    std::vector<std::string> names;
    for (const DeclaredParameter &parameter : declared)
      if (parameter.section == section)
        names.push_back(parameter.name);
    return names;
  }

  std::vector<std::string>
  ParameterRegister::subsections_in(const std::string &section) const
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

  std::string
  ParameterRegister::list_of_names(const std::string &section) const
  {
    for (const std::string &name : names_in(section))
      if (name.rfind("List of ", 0) == 0)
        return join(section, name);
    return "";
  }

  InputError
  ParameterRegister::unknown_subsection(const ParameterEntry &entry) const
  {
    // The outermost name that is not known is the one to name.
    std::string section, unknown;
    for (const std::string &name : dealii::Utilities::split_string_list(entry.section, '/'))
      {
        unknown = name;
        if (!has_section(join(section, name)))
          break;
        section = join(section, name);
      }
    const std::string list = list_of_names(section);
    return InputError(entry.origin + ": there is no subsection '" + unknown + "'" +
                      (section.empty() ? "" : " in subsection " + section) +
                      (list.empty() ? "" : " ('" + list + "' is '" + values.at(list) + "')") +
                      did_you_mean(unknown, subsections_in(section)));
  }

  InputError
  ParameterRegister::unknown_parameter(const ParameterEntry &entry) const
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
        return InputError(start + "; did you mean '" + join(parameter.section, closest) + "'?");
    return InputError(start + "; 'magmpm --print-parameters' lists all.");
  }
} // namespace magmpm
