#pragma once

#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_file.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace magmpm
{
  /** What it means if the user does not give a parameter. */
  enum class Presence
  {
    has_default, ///< the value that the variable has when it is bound
    optional,    ///< the variable stays as it is, and given() says so
    required     ///< an error
  };

  /** A parameter as the manual describes it, and its value. */
  struct DeclaredParameter
  {
    std::string section; ///< "Bodies/cube"; empty at the top
    std::string name;
    std::string default_value;
    std::string range; ///< in words: "a number > 0"
    std::string unit;  ///< "kg/m^3"; "-" if it has none
    std::string text;
    Presence presence;

    /** Reads a value into the variable; false if it is not allowed. */
    std::function<bool(const std::string &)> read;

    std::string value = default_value;
    std::string origin; ///< of the value: "cube.prm, line 12"; empty if it is not in the file

    /** "Bodies/cube/Density" */
    std::string
    path() const
    {
      return section.empty() ? name : section + "/" + name;
    }

    /** " [m]", or nothing. */
    std::string
    unit_in_brackets() const
    {
      return unit == "-" ? "" : " [" + unit + "]";
    }

    /** What is allowed, and what it means: the end of a message. */
    std::string
    must_be() const
    {
      return "must be " + range + unit_in_brackets() + ". (" + text + ")";
    }
  };

  /** All parameters in the order of their declaration: which names there are, and which a user may have meant. */
  class ParameterTable
  {
  public:
    void
    add(const DeclaredParameter &parameter)
    {
      declared.push_back(parameter);
    }

    /** Says why the parameter @p path does not exist. */
    void
    refuse(const std::string &path, const std::string &reason)
    {
      refused[path] = reason;
    }

    bool
    is_refused(const std::string &path) const
    {
      return refused.count(path) > 0;
    }

    const std::vector<DeclaredParameter> &
    all() const
    {
      return declared;
    }

    /** The parameter of that path, or a null pointer. */
    DeclaredParameter *
    find(const std::string &path);

    const DeclaredParameter *
    find(const std::string &path) const;

    bool
    has_section(const std::string &section) const;

    /** The parameters directly in @p section. */
    std::vector<const DeclaredParameter *>
    parameters_in(const std::string &section) const;

    /** Names of the subsections directly in @p section. */
    std::vector<std::string>
    subsections_in(const std::string &section) const;

    /** The parameter "List of ..." in @p section, or a null pointer. */
    const DeclaredParameter *
    list_of_names(const std::string &section) const;

    /** The error of an entry in a section that does not exist. */
    InputError
    unknown_subsection(const ParameterEntry &entry) const;

    /** The error of an entry in a section that has no such parameter. */
    InputError
    unknown_parameter(const ParameterEntry &entry) const;

  private:
    std::vector<DeclaredParameter> declared;
    std::map<std::string, std::string> refused; ///< reasons by path

    std::vector<std::string>
    names_in(const std::string &section) const;
  };

  /** "Bodies/cube" of "Bodies" and "cube". */
  std::string
  joined_path(const std::string &section, const std::string &name);
} // namespace magmpm
