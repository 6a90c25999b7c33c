#pragma once

#include <magmpm/base/exceptions.h>
#include <magmpm/base/tensor.h>
#include <magmpm/parameters/parameter_file.h>

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;

  namespace Patterns
  {
    class PatternBase;
  }
} // namespace dealii

namespace magmpm
{
  /** Which numbers a parameter allows. */
  struct NumberRange
  {
    double minimum        = -std::numeric_limits<double>::infinity();
    double maximum        = std::numeric_limits<double>::infinity();
    bool minimum_excluded = false;
    bool maximum_excluded = false;

    bool
    contains(const double number) const;

    /** "> 0", "from 0 to 1", or nothing if every number is allowed. */
    std::string
    description() const;
  };

  inline const NumberRange any_number   = {};
  inline const NumberRange positive     = {0., any_number.maximum, true, false};
  inline const NumberRange not_negative = {0., any_number.maximum, false, false};

  /** What it means if the user does not give a parameter. */
  enum class Presence
  {
    has_default, ///< the value that the variable has when it is bound
    optional,    ///< the variable stays as it is, and given() says so
    required     ///< an error
  };

  /** A parameter as the manual describes it. */
  struct DeclaredParameter
  {
    std::string section; ///< "Bodies/cube"; empty at the top
    std::string name;
    std::string default_value;
    std::string range; ///< in words: "a number > 0"
    std::string unit;  ///< "kg/m^3"; "-" if it has none
    std::string text;
    Presence presence;
  };

  /**
   * Binds parameters to variables, one line each with default, unit, text and range, on top of
   * deal.II's ParameterHandler, and remembers what it was told: the messages, the manual and "did you
   * mean" all come from this one list.
   *
   *   {
   *     const auto section = parameters.enter("Time step");
   *     parameters.add("Maximum", maximum, "s", "No time step is longer.", positive);
   *   }
   *
   * The bound variables must stay where they are until apply() has been called.
   */
  class ParameterRegister
  {
  public:
    ParameterRegister();
    ~ParameterRegister();

    /** Leaves the subsection when it goes out of scope. */
    class Section
    {
    public:
      Section(ParameterRegister &parameters, const std::string &name);
      ~Section();
      Section(const Section &) = delete;

    private:
      ParameterRegister &parameters;
      const std::string outer;
    };

    [[nodiscard]] Section
    enter(const std::string &name)
    {
      return Section(*this, name);
    }

    void
    add(const std::string &name,
        double &variable,
        const std::string &unit,
        const std::string &text,
        const NumberRange &range = any_number,
        const Presence presence  = Presence::has_default);

    void
    add(const std::string &name,
        int &variable,
        const std::string &unit,
        const std::string &text,
        const NumberRange &range);

    template <int n>
    void
    add(const std::string &name,
        Vector<n> &variable,
        const std::string &unit,
        const std::string &text,
        const Presence presence = Presence::has_default)
    {
      add_numbers(name, variable.values, n, unit, text, any_number, presence);
    }

    /** A number, or, by default, the word auto, which makes @p variable 0. */
    void
    add_or_auto(const std::string &name,
                double &variable,
                const std::string &unit,
                const std::string &text,
                const NumberRange &range);

    void
    add(const std::string &name, bool &variable, const std::string &text);

    /** Any text. @param unit  of numbers in it. */
    void
    add(const std::string &name,
        std::string &variable,
        const std::string &unit,
        const std::string &text,
        const Presence presence = Presence::has_default);

    /** One of several names, each of which stands for a value. */
    template <typename Value>
    void
    add(const std::string &name,
        Value &variable,
        const std::vector<std::pair<std::string, Value>> &choices,
        const std::string &text)
    {
      std::vector<std::string> names;
      std::string default_name;
      for (const auto &choice : choices)
        {
          names.push_back(choice.first);
          if (choice.second == variable)
            default_name = choice.first;
        }
      add_choice(name, default_name, names, text, [&variable, choices](const std::string &value) {
        for (const auto &choice : choices)
          if (choice.first == value)
            variable = choice.second;
      });
    }

    /** A list of names, separated by commas. @param choices  those allowed; empty: all. */
    void
    add(const std::string &name,
        std::vector<std::string> &variable,
        const std::vector<std::string> &choices,
        const std::string &text);

    /** Says why the parameter @p name, not declared in this case, does not exist. */
    void
    refuse(const std::string &name, const std::string &reason);

    /**
     * Gives all variables the values of @p file. A subsection of a body, material or magnet that is
     * not in its list is left out, with a warning.
     *
     * @throw InputError  if the file knows a name that is not declared, or a value is not allowed, or
     *                    a required one is missing. The message says where, and what to write.
     */
    void
    apply(const ParameterFile &file);

    /** What apply() left out. */
    const std::vector<std::string> &
    warnings() const
    {
      return all_warnings;
    }

    /** Changes the value as print() shows it, not the variable. */
    void
    set_printed_value(const std::string &path, const std::string &value);

    bool
    is_declared(const std::string &path) const
    {
      return find(path) != nullptr;
    }

    /** Whether a parameter without default was given. */
    bool
    given(const std::string &path) const;

    /**
     * An error about the value of a declared parameter, to be thrown:
     * "cube.prm, line 12: Bodies/cube/Density = 0: <explanation>".
     */
    InputError
    error(const std::string &path, const std::string &explanation) const;

    /** The folder of the parameter file, with a slash at the end; empty: the working directory. */
    std::string
    folder() const;

    /** Where the value of a declared parameter comes from: "cube.prm, line 12: Bodies/cube/Density". */
    std::string
    where(const std::string &path) const;

    /** All values in the language of parameter files, with texts and defaults as comments. */
    std::string
    print() const;

    const std::vector<DeclaredParameter> &
    declared_parameters() const
    {
      return declared;
    }

  private:
    std::unique_ptr<dealii::ParameterHandler> handler;
    std::vector<DeclaredParameter> declared;
    std::map<std::string, std::string> refused; ///< reasons by path
    std::string current_section;

    std::string file_name;
    std::map<std::string, std::string> values;  ///< by path
    std::map<std::string, std::string> origins; ///< by path, of those in the file
    std::vector<std::string> all_warnings;

    void
    add_numbers(const std::string &name,
                double *variable,
                const int n,
                const std::string &unit,
                const std::string &text,
                const NumberRange &range,
                const Presence presence);

    void
    add_choice(const std::string &name,
               const std::string &default_name,
               const std::vector<std::string> &names,
               const std::string &text,
               const std::function<void(const std::string &)> &action);

    void
    declare(const DeclaredParameter &parameter,
            const dealii::Patterns::PatternBase &pattern,
            const std::function<void(const std::string &)> &action);

    /** Throws an InputError if @p file has a name that is not declared. */
    void
    check_names(const ParameterFile &file);

    /** Throws unless the subsection of @p entry may be left out, and warns in that case. */
    void
    leave_out(const ParameterEntry &entry);

    void
    apply(const ParameterEntry &entry);

    bool
    has_section(const std::string &section) const;

    /** The declared parameter of that path, or a null pointer. */
    const DeclaredParameter *
    find(const std::string &path) const;

    /** Names of the parameters directly in @p section. */
    std::vector<std::string>
    names_in(const std::string &section) const;

    /** Names of the subsections directly in @p section. */
    std::vector<std::string>
    subsections_in(const std::string &section) const;

    /** The path of the parameter "List of ..." in @p section, or nothing. */
    std::string
    list_of_names(const std::string &section) const;

    InputError
    unknown_subsection(const ParameterEntry &entry) const;

    InputError
    unknown_parameter(const ParameterEntry &entry) const;
  };
} // namespace magmpm
