#pragma once

#include <magmpm/parameters/parameter_table.h>

#include <string>

namespace magmpm
{
  /** All values in the language of parameter files, with texts and defaults as comments. */
  std::string
  listing_of(const ParameterTable &table);
} // namespace magmpm
