#pragma once

#include <magmpm/magnets/source_parameters.h>
#include <magmpm/parameters/given_magnet.h>

#include <string>
#include <vector>

namespace magmpm
{
  /** A kind of source in the language of parameter files; motion is common to all but the field. */
  template <int dim>
  struct KindOfSource
  {
    std::string name;
    std::vector<std::string> needed, allowed; ///< parameters
    bool is_magnetized;                       ///< by Magnetization or Remanence
    Interior interior;
    SourceKind<dim> (*read)(const GivenMagnet<dim> &);
  };

  /** All kinds, the default first. */
  template <int dim>
  const std::vector<KindOfSource<dim>> &
  kinds_of_source();

  /**
   * Checks that all that the kind of @p magnet needs is given, and nothing that only others have.
   *
   * @throw InputError  otherwise.
   */
  template <int dim>
  void
  check_given_for_kind(const GivenMagnet<dim> &magnet);

  /** Checks lengths and directions that were given. @throw InputError  if one makes no sense. */
  template <int dim>
  void
  check_sizes(const GivenMagnet<dim> &magnet);
} // namespace magmpm
