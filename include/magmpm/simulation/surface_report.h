#pragma once

#include <magmpm/parameters/parameters.h>

#include <string>

namespace magmpm
{
  /**
   * Lines on each fluid with surface tension, for the log: its capillary length, how fast sound is beside what the
   * lattice needs, the Laplace number of the capillary length, and, if it is magnetic, the critical magnetization
   * and induction of a deep layer. Empty without such fluids.
   */
  template <int dim>
  std::string
  surface_report(const Parameters<dim> &parameters);
} // namespace magmpm
