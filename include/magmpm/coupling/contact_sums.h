#pragma once

#include <magmpm/boundary/solid_contact.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /**
   * Whether particles of a solid on this rank may be so near to a surface that contact needs sums, or come
   * so near in the next step.
   */
  template <int dim>
  bool
  is_contact_near(const std::vector<Body<dim>> &bodies,
                  const BlockSet<dim> &blocks,
                  const Lattice<dim> &lattice,
                  const SolidContact<dim> &contact);

  /**
   * The sums of ContactSums over the particles of solids near surfaces. The gap of a particle to a surface at
   * the distance d from its place, with the normal n, is
   *   s = d - sum_k |n . F H e_k|,
   * with its half-extent H: zero where material fills its cell up to the surface. Its weight is
   * e^(-s/eps), eps = 0.03 dx: a mean over what lies next to the surface, not an extreme, since the
   * force at a node must not depend on one particle that the node hardly moves.
   *
   * @param group  the contact group whose particles count.
   * @param sums   on return those of this rank's particles, also on ghosts.
   */
  template <int dim>
  void
  sum_contact(const std::vector<Body<dim>> &bodies,
              const int group,
              const BlockSet<dim> &blocks,
              const Lattice<dim> &lattice,
              const SolidContact<dim> &contact,
              NodeField<dim, ContactSums> &sums);
} // namespace magmpm
