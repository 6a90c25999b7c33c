#pragma once

#include <magmpm/boundary/wall_images.h>
#include <magmpm/lattice/node_field.h>

namespace magmpm
{
  /**
   * The lattice as one contact group of bodies sees it: momentum and velocity of their own at each node, so that
   * groups pass each other but for contact.
   */
  template <int dim>
  struct GroupMotion
  {
    int group;
    WallImages<dim> images;

    NodeField<dim> motion; ///< {momentum, later velocity; mass}
    NodeField<dim>
      unconstrained;         ///< velocities without walls and bodies; used if any material has FMPM
    NodeField<dim> filtered; ///< P v, likewise
    NodeField<dim> taken;    ///< v and what FMPM gives back, likewise
  };
} // namespace magmpm
