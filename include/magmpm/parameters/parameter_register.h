#pragma once

#include <magmpm/base/exceptions.h>
#include <magmpm/base/tensor.h>
#include <magmpm/parameters/number_range.h>
#include <magmpm/parameters/parameter_file.h>
#include <magmpm/parameters/parameter_table.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace magmpm
{
  /**
   * Binds parameters to variables, one line each with default, unit, text and range, and remembers
   * what it was told: the messages, the manual, parameters.prm and "did you mean" all come from this one
   * table.
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

    /** Any text that is read later, by value(). @param default_value  empty: there is none. */
    void
    add_text(const std::string &name,
             const std::string &default_value,
             const std::string &unit,
             const std::string &text);

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

    /** Gives a declared parameter another value than apply() did. */
    void
    set_value(const std::string &path, const std::string &value);

    bool
    is_declared(const std::string &path) const
    {
      return table.find(path) != nullptr;
    }

    /** The text of a declared parameter. */
    const std::string &
    value(const std::string &path) const
    {
      return declared(path).value;
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

    /** All that was declared, with its value. */
    const ParameterTable &
    parameters() const
    {
      return table;
    }

    const std::vector<DeclaredParameter> &
    declared_parameters() const
    {
      return table.all();
    }

  private:
    ParameterTable table;
    std::string current_section;
    std::string file_name;
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

    /** In the section entered. The default is read into the variable: what it says is what counts. */
    void
    declare(const std::string &name,
            const std::string &default_value,
            const std::string &range,
            const std::string &unit,
            const std::string &text,
            const Presence presence,
            const std::function<bool(const std::string &)> &read);

    /** The declared parameter of that path, which must be there. */
    const DeclaredParameter &
    declared(const std::string &path) const;

    /** Throws an InputError if @p file has a name that is not declared. */
    void
    check_names(const ParameterFile &file);

    /** Throws unless the subsection of @p entry may be left out, and warns in that case. */
    void
    leave_out(const ParameterEntry &entry);
  };
} // namespace magmpm
