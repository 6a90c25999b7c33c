#pragma once

#include <magmpm/coupling/attraction.h>
#include <magmpm/parameters/parameter_register.h>

#include <string>
#include <vector>

/** The section Attraction. */
namespace magmpm
{
  template <int dim>
  void
  declare_attraction(ParameterRegister &declarations, PointAttraction<dim> &attraction);

  /** What an attraction may depend on. */
  struct AttractionSetting
  {
    std::vector<std::string> body_names;
    double spacing;     ///< dx [m]
    bool has_magnets;   ///< any at all
    bool has_potential; ///< whether any body is magnetic
  };

  template <int dim>
  void
  convert_attraction(const ParameterRegister &declarations,
                     const AttractionSetting &setting,
                     PointAttraction<dim> &attraction);
} // namespace magmpm
