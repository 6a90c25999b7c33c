#pragma once

#include <magmpm/base/number_text.h>
#include <magmpm/parameters/parameter_register.h>

#include <string>
#include <vector>

/** What checks of relations between parameters have in common. */
namespace magmpm
{
  inline constexpr const char *axis_names = "xyz";

  /** The parameters of @p names in @p section that were given. */
  std::vector<std::string>
  given_of(const ParameterRegister &declarations,
           const std::string &section,
           const std::vector<std::string> &names);

  /**
   * All of @p needed must be given, none of @p unused.
   *
   * @param reason      names what says so: "Shape = box".
   * @throw InputError  otherwise.
   */
  void
  check_given(const ParameterRegister &declarations,
              const std::string &section,
              const std::vector<std::string> &needed,
              const std::vector<std::string> &unused,
              const std::string &reason);
} // namespace magmpm
