#pragma once

#include <magmpm/parameters/given_magnet.h>
#include <magmpm/parameters/parameters.h>

#include <memory>
#include <string>
#include <vector>

/** The subsections of the section Magnets. */
namespace magmpm
{
  template <int dim>
  void
  declare_magnet(ParameterRegister &declarations,
                 const std::string &name,
                 MagnetInput<dim> &magnet);

  /**
   * Checks all magnets, and makes the sources and the rigid bodies that they are of them.
   *
   * @param names        of the magnets, in the order of @p magnets.
   * @param body_shapes  of the bodies; a solid magnet must not overlap them.
   * @throw InputError   says which line is wrong.
   */
  template <int dim>
  void
  check_magnets(const ParameterRegister &declarations,
                const std::vector<std::string> &names,
                const std::vector<MagnetInput<dim>> &magnets,
                const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes,
                Parameters<dim> &parameters);
} // namespace magmpm
