#pragma once

#include <magmpm/boundary/contact_law.h>

#include <array>

namespace magmpm
{
  /** The material of one of two contact groups around a node that they share. */
  template <int dim>
  struct SharedMaterial
  {
    double mass;                 ///< [kg]
    double volume;               ///< V = sum_p J V_0 N_i [m^dim]
    double modulus;              ///< M = lambda + 2 mu; of a fluid K [Pa]
    Vector<dim> volume_gradient; ///< g = sum_p J V_0 grad N_i, outward [m^(dim-1)]
  };

  /** Directions that two groups may touch along at a node. */
  inline constexpr int n_contact_normals = 3;

  /**
   * From a to b: out of a, into b, and along V_b g_a - V_a g_b, the gradient of a's part of all material. At edges some
   * of them are wrong, since a surface that ends tilts its gradient: beside the edge of a block on a wider one that of
   * the wider is right, where the sides of both are in one plane the third, in which these cancel. The bodies do not
   * overlap if there is a direction along which they do not, so that with the largest gap is the right one. Zero where
   * there is no gradient.
   */
  template <int dim>
  inline std::array<Vector<dim>, n_contact_normals>
  contact_normals(const SharedMaterial<dim> &a, const SharedMaterial<dim> &b)
  {
    std::array<Vector<dim>, n_contact_normals> normals = {a.volume_gradient,
                                                          -1. * b.volume_gradient,
                                                          b.volume * a.volume_gradient -
                                                            a.volume * b.volume_gradient};
    for (Vector<dim> &normal : normals)
      {
        const double length = norm(normal);
        normal              = (length > 0. ? 1. / length : 0.) * normal;
      }
    return normals;
  }

  /**
   * The area of contact that a node stands for [m^(dim-1)], A = n.(m_b g_a - m_a g_b)/(m_a + m_b): mostly the
   * gradient of the lighter one, which is the one that must balance; see contact_area().
   *
   * @param normal  from a to b.
   */
  template <int dim>
  inline double
  shared_area(const SharedMaterial<dim> &a, const SharedMaterial<dim> &b, const Vector<dim> &normal)
  {
    return std::max(
      0., dot(normal, b.mass * a.volume_gradient - a.mass * b.volume_gradient) / (a.mass + b.mass));
  }

  /** That of the layers of both, one cell thick, one behind the other: 1/M = 1/M_a + 1/M_b. */
  inline double
  modulus_in_series(const double a, const double b)
  {
    return a * b / (a + b);
  }

  /** Where two groups touch at a node. */
  template <int dim>
  struct SharedSurface
  {
    Vector<dim> normal;  ///< from a to b
    double gap;          ///< negative if they overlap [m]
    double area;         ///< [m^(dim-1)]
    double modulus;      ///< of both in series [Pa]
    double reduced_mass; ///< m_a m_b/(m_a + m_b) of the node [kg]
    SurfaceContact contact;
  };

  /** Bodies that stick or slip are held where they are as near as this [dx]. */
  inline constexpr double reach_of_hold = 0.25;

  /**
   * The impulse of a step on b at a node, of which a gets the opposite: pressure M pen/(dx - pen) at the depth
   * pen = -gap unless a gap will be open, friction up to Coulomb's bound; what sticks or slips does not part.
   *
   * @param relative  v_b - v_a after all other forces [m/s].
   */
  template <int dim>
  inline Vector<dim>
  impulse_between(const SharedSurface<dim> &surface,
                  const double spacing,
                  const double time_step,
                  const Vector<dim> &relative)
  {
    const double approach = dot(relative, surface.normal);
    double pressing       = 0.;
    if (surface.gap < 0. && surface.gap + time_step * approach < 0.)
      pressing = time_step * surface.area * surface.modulus *
                 contact_pressure(-surface.gap / spacing);
    const ContactShare share =
      friction_share(surface.contact, surface.reduced_mass, pressing, surface.normal, relative);
    Vector<dim> impulse = pressing * surface.normal -
                          surface.reduced_mass * taken_by(share, surface.normal, relative);

    if (surface.contact.condition == ContactCondition::separate ||
        surface.gap > reach_of_hold * spacing)
      return impulse;
    const double allowed   = std::max(0., -surface.gap) / time_step;
    const Vector<dim> left = relative + (1. / surface.reduced_mass) * impulse -
                             allowed * surface.normal;
    if (dot(left, surface.normal) > 0.)
      impulse -=
        surface.reduced_mass *
        taken_by(contact_share(surface.contact, surface.normal, left), surface.normal, left);
    return impulse;
  }
} // namespace magmpm
