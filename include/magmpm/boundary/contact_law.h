#pragma once

#include <magmpm/boundary/surface_contact.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  /** A surface as a node sees it, and the gap between it and the material of the node. */
  template <int dim>
  struct NodeSurface
  {
    double distance;      ///< of the node, negative inside [m]
    Vector<dim> normal;   ///< out of the surface
    double gap;           ///< negative if material is in the surface [m]
    Vector<dim> velocity; ///< of the surface at the node [m/s]
    SurfaceContact contact;
  };

  /** The solid around a node. */
  template <int dim>
  struct NodeSolid
  {
    double mass;                 ///< [kg]
    double density;              ///< [kg/m^3]
    double modulus;              ///< M = lambda + 2 mu [Pa]
    Vector<dim> volume_gradient; ///< g = sum_p J V_0 grad N_i, outward [m^(dim-1)]
  };

  /** The B-spline of a node, q = distance/dx from it. */
  inline double
  spline_of_distance(double q)
  {
    q = std::abs(q);
    return q < 0.5 ? 0.75 - q * q : q < 1.5 ? 0.5 * (1.5 - q) * (1.5 - q) : 0.;
  }

  /** Its integral from minus infinity to q. */
  inline double
  spline_integral(const double q)
  {
    if (q < -1.5)
      return 0.;
    if (q < -0.5)
      return (q + 1.5) * (q + 1.5) * (q + 1.5) / 6.;
    if (q < 0.5)
      return 0.5 + 0.75 * q - q * q * q / 3.;
    if (q < 1.5)
      return 1. - (1.5 - q) * (1.5 - q) * (1.5 - q) / 6.;
    return 1.;
  }

  /**
   * The area of contact that a node stands for [m^(dim-1)]:
   *   A = n.(m_a g_b - m_b g_a)/(m_a + m_b),
   * where a is the material and b a half space of the same density behind the surface. The pressure of
   * contact so acts with the same weights as the stress behind it, and both balance node by node; by
   * mass they would not where a row of particles just enters the B-spline of a node. The sum over a
   * face is its area wherever it lies on the lattice.
   */
  template <int dim>
  inline double
  contact_area(const NodeSolid<dim> &solid, const NodeSurface<dim> &surface, const double spacing)
  {
    const double q     = surface.distance / spacing;
    const double face  = std::pow(spacing, dim - 1);
    const double other = solid.density * face * spacing * spline_integral(-q);
    return std::max(0.,
                    (solid.mass * face * spline_of_distance(q) -
                     other * dot(surface.normal, solid.volume_gradient)) /
                      (solid.mass + other));
  }

  /** The pressure of contact grows no further than at this depth [dx]. */
  inline constexpr double deepest_contact = 0.9;

  /** Pressure of contact over M at a depth in dx: that of a layer one cell thick, which lets nothing through. */
  inline double
  contact_pressure(const double depth)
  {
    return depth / (1. - std::min(depth, deepest_contact));
  }

  /** What this pressure stores, per area and over M dx. */
  inline double
  contact_energy(const double depth)
  {
    const double harder = std::min(depth, deepest_contact);
    return -harder - std::log1p(-harder) +
           0.5 * (depth * depth - harder * harder) / (1. - deepest_contact);
  }

  /**
   * The normal impulse of a step on the material of a node, along the normal: of the pressure
   * M pen/(dx - pen) at the depth pen = -gap; none if there is a gap, or one will be open after the step.
   *
   * @param approach  normal velocity of the node relative to the surface, positive away from it [m/s].
   */
  template <int dim>
  inline double
  pressing_impulse(const NodeSolid<dim> &solid,
                   const NodeSurface<dim> &surface,
                   const double spacing,
                   const double time_step,
                   const double approach)
  {
    if (surface.gap >= 0. || surface.gap + time_step * approach >= 0.)
      return 0.;
    return time_step * contact_area(solid, surface, spacing) * solid.modulus *
           contact_pressure(-surface.gap / spacing);
  }

  /**
   * The part of a relative velocity that friction takes away from a node which is pressed: Coulomb's bound is
   * on its impulse; stick takes all.
   *
   * @param mass      of the node [kg].
   * @param pressing  normal impulse of the step [N s].
   * @param relative  velocity after all other forces, relative to the surface [m/s].
   */
  template <int dim>
  inline ContactShare
  friction_share(const SurfaceContact &contact,
                 const double mass,
                 const double pressing,
                 const Vector<dim> &normal,
                 const Vector<dim> &relative)
  {
    if (contact.condition == ContactCondition::stick)
      return {0., pressing > 0. ? 1. : 0.};
    const double allowed = contact.friction * pressing;
    const double sliding = mass * norm(relative - dot(relative, normal) * normal);
    return {0., sliding > allowed ? allowed / sliding : allowed > 0. ? 1. : 0.};
  }
} // namespace magmpm
