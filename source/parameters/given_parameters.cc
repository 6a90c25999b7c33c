#include <magmpm/parameters/given_parameters.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace magmpm
{
  std::vector<std::string>
  given_of(const ParameterRegister &declarations,
           const std::string &section,
           const std::vector<std::string> &names)
  {
    std::vector<std::string> result;
    std::copy_if(names.begin(), names.end(), std::back_inserter(result), [&](const auto &name) {
      return declarations.given(section + "/" + name);
    });
    return result;
  }

  void
  check_given(const ParameterRegister &declarations,
              const std::string &section,
              const std::vector<std::string> &needed,
              const std::vector<std::string> &unused,
              const std::string &reason)
  {
    for (const std::string &name : needed)
      if (!declarations.given(section + "/" + name))
        throw declarations.error(section + "/" + name, reason + " needs it.");
    for (const std::string &name : given_of(declarations, section, unused))
      throw declarations.error(section + "/" + name,
                               reason + " does not use it; remove this line or change that.");
  }
} // namespace magmpm
