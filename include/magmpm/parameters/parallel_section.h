#pragma once

#include <magmpm/parameters/parameter_register.h>

/** The section Parallel: how ranks share the work. */
namespace magmpm
{
  /** @param imbalance_threshold  see MeshParameters. */
  void
  declare_ranks(ParameterRegister &declarations, double &imbalance_threshold);
} // namespace magmpm
