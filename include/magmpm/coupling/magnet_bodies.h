#pragma once

#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/magnets/external_field.h>

#include <vector>

namespace magmpm
{
  /**
   * The rigid bodies that the magnets are which are solid or free. One that is not free goes where its
   * source goes, by the same script.
   *
   * @param properties  of each source as a rigid body; without contact and not free: it is none.
   * @param field       made of @p sources; it owns the shapes and must outlive the bodies.
   */
  template <int dim>
  std::vector<MovedBody<dim>>
  make_magnet_bodies(const std::vector<SourceParameters<dim>> &sources,
                     const std::vector<RigidBodyProperties<dim>> &properties,
                     const ExternalField<dim> &field);

  /** Brings the sources that are free magnets to where their bodies are, which own the poses. */
  template <int dim>
  void
  move_free_sources(const RigidBodies<dim> &bodies, ExternalField<dim> &field);
} // namespace magmpm
