#pragma once

#include <magmpm/parameters/parameter_register.h>

#include <string>

namespace magmpm
{
  /**
   * Where the file is that the parameter @p path names: a relative name is looked for in the folder
   * of the parameter file, then in the working directory.
   *
   * @param file        its value.
   * @throw InputError  if there is no such file; names both places.
   */
  std::string
  find_input_file(const ParameterRegister &declarations,
                  const std::string &path,
                  const std::string &file);
} // namespace magmpm
