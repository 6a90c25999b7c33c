#pragma once

#include <magmpm/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  /** What a surface does to the velocity of material that touches it. */
  enum class ContactCondition
  {
    none, ///< there is no surface
    stick,
    slip,
    separate
  };

  /** What a surface does to material that touches it. */
  struct SurfaceContact
  {
    ContactCondition condition = ContactCondition::none;
    double friction            = 0.; ///< Coulomb's coefficient [-], of slip and separate

    /** At which the free surface of a fluid meets it, within the fluid; of slip and separate [degrees]. */
    double contact_angle = 90.;

    /** Whether there is a line that moves along it. */
    bool
    lets_slide() const
    {
      return condition == ContactCondition::slip || condition == ContactCondition::separate;
    }
  };

  /**
   * The part of a velocity relative to a surface that contact takes away: of the normal component
   * (0 or 1), and of the tangential one (0 to 1).
   */
  struct ContactShare
  {
    double normal     = 0.;
    double tangential = 0.;
  };

  /**
   * stick: all; slip: the normal component; separate: the normal one if it goes into the surface.
   * Friction then takes away as much of the tangential velocity as Coulomb's law allows, the
   * coefficient times what was taken of the normal one.
   *
   * @param normal    outward, of length 1.
   * @param relative  velocity relative to the surface [m/s].
   */
  template <int dim>
  inline ContactShare
  contact_share(const SurfaceContact &contact,
                const Vector<dim> &normal,
                const Vector<dim> &relative)
  {
    if (contact.condition == ContactCondition::none)
      return {};
    if (contact.condition == ContactCondition::stick)
      return {1., 1.};
    const double normal_velocity = dot(relative, normal);
    if (contact.condition == ContactCondition::separate && normal_velocity >= 0.)
      return {};
    if (contact.friction == 0.)
      return {1., 0.};
    const double sliding = norm(relative - normal_velocity * normal);
    const double allowed = contact.friction * std::abs(normal_velocity);
    return {1., sliding > allowed ? allowed / sliding : 1.};
  }

  /** The part of @p relative that @p share takes away. */
  template <int dim>
  inline Vector<dim>
  taken_by(const ContactShare &share, const Vector<dim> &normal, const Vector<dim> &relative)
  {
    if (share.normal == 1. && share.tangential == 1.)
      return relative; // without rounding
    const Vector<dim> along_normal = dot(relative, normal) * normal;
    return share.normal * along_normal + share.tangential * (relative - along_normal);
  }
} // namespace magmpm
