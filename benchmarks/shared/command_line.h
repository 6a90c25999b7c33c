#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** The options of a program, what each does, and how they are read. */
  class CommandLine
  {
  public:
    using Action = std::function<void(const std::string &value)>;

    /** @param program  its name. */
    explicit CommandLine(const std::string &program);

    /** An option without a value. */
    void
    add_switch(const std::string &option, bool &is_on);

    /** An option that is followed by a value, with which @p action is called. */
    void
    add(const std::string &option, const Action &action);

    /** An option that is followed by a number greater than zero. */
    void
    add_number(const std::string &option, double &number);

    /** @throw InputError  an unknown option, or a value that is none. */
    void
    read(const std::vector<std::string> &arguments) const;

  private:
    const std::string program;
    std::map<std::string, bool *> switches;
    std::map<std::string, Action> actions;

    std::vector<std::string>
    known() const;
  };

  /** What stands between commas. */
  std::vector<std::string>
  split(const std::string &list);

  /** All of them with commas between. */
  std::string
  joined(const std::vector<std::string> &names);

  /** @throw InputError  @p value is none of those allowed. */
  const std::string &
  one_of(const std::string &option,
         const std::string &value,
         const std::vector<std::string> &allowed);

  /** @throw InputError  @p value is no number greater than zero. */
  double
  positive_number(const std::string &option, const std::string &value);

  /** @throw InputError  @p value is no number of at least 1. */
  double
  number_from_one(const std::string &option, const std::string &value);
} // namespace magmpm::benchmarks
