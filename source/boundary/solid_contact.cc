#include <magmpm/boundary/solid_contact.h>

#include <limits>

namespace magmpm
{
  namespace
  {
    /** Surfaces that stick or slip hold what is as near as this. */
    constexpr double holding_reach = 0.25; // of dx

    SurfaceContact
    contact_of_wall(const WallCondition condition, const double friction)
    {
      return {condition == WallCondition::slip ? ContactCondition::slip
                                               : ContactCondition::separate,
              friction};
    }
  } // namespace

  template <int dim>
  SolidContact<dim>::SolidContact(const Lattice<dim> &lattice,
                                  const WallParameters<dim> &walls,
                                  const std::vector<RigidBody<dim>> &bodies)
    : lattice(lattice)
    , walls(walls)
    , bodies(bodies)
    , impulses_on_bodies(bodies.size())
  {
  }

  template <int dim>
  bool
  SolidContact<dim>::has_bodies() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const auto &body) {
      return body.contact().condition != ContactCondition::none;
    });
  }

  template <int dim>
  void
  SolidContact<dim>::reinit(const int n_blocks)
  {
    if (n_blocks != the_sums.n_blocks())
      the_sums.reinit(n_blocks);
    the_energy = the_depth = 0.;
    touched.clear();
    std::fill(impulses_on_bodies.begin(), impulses_on_bodies.end(), RigidVector<dim>());
  }

  template <int dim>
  int
  SolidContact<dim>::find_nearest_body(const Vector<dim> &position) const
  {
    int result     = none;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        if (bodies[b].contact().condition == ContactCondition::none ||
            !bodies[b].is_near(position, reach_of_contact(lattice)))
          continue;
        const double distance = bodies[b].surface_distance(position).distance;
        if (distance >= nearest)
          continue;
        nearest = distance;
        result  = static_cast<int>(b);
      }
    return result;
  }

  template <int dim>
  template <typename Function>
  void
  SolidContact<dim>::for_surfaces(const int slot,
                                  const int n,
                                  const Index<dim> &node,
                                  const Function &f) const
  {
    const auto gap = [&](const int surface) {
      return the_sums.get(ContactSums::weighted_gap(surface), slot, n) /
             the_sums.get(ContactSums::weight(surface), slot, n);
    };
    const auto is_known = [&](const int surface) {
      return the_sums.get(ContactSums::weight(surface), slot, n) > 0.;
    };
    if (is_known(ContactSums::nearest_body))
      {
        const Vector<dim> position = lattice.node_position(node);
        const int b                = find_nearest_body(position);
        const Vector<dim> normal   = the_sums.get(ContactSums::normal, slot, n);
        const double weight = the_sums.get(ContactSums::weight(ContactSums::nearest_body), slot, n);
        const double length = norm(normal);
        if (b != none && length > 0.5 * weight)
          f(Surface{{the_sums.get(ContactSums::plane, slot, n) / weight +
                       dot(normal, position - lattice.lower_corner) / weight,
                     (1. / length) * normal,
                     gap(ContactSums::nearest_body),
                     bodies[b].velocity_at(position),
                     bodies[b].contact()},
                    b});
      }
    // Walls last: what a body presses against a wall must not leave the box.
    for (int d = 0; d < dim; ++d)
      {
        const int side = (2 * node[d] < lattice.n_cells[d] ? 0 : 1), face = 2 * d + side;
        if (!has_wall(face) || !is_known(d))
          continue;
        Vector<dim> normal;
        normal[d] = (side == 0 ? 1. : -1.);
        f(Surface{{(side == 0 ? node[d] : lattice.n_cells[d] - node[d]) * lattice.spacing,
                   normal,
                   gap(d),
                   {},
                   contact_of_wall(walls.condition[face], walls.friction[face])},
                  none});
      }
  }

  template <int dim>
  Vector<dim>
  SolidContact<dim>::pressed(const int slot,
                             const int n,
                             const Index<dim> &node,
                             const double time_step,
                             const double mass,
                             Vector<dim> velocity)
  {
    const double volume        = the_sums.get(ContactSums::volume, slot, n);
    const NodeSolid<dim> solid = {mass,
                                  the_sums.get(ContactSums::mass, slot, n) / volume,
                                  the_sums.get(ContactSums::stiffness, slot, n) / volume,
                                  the_sums.get(ContactSums::volume_gradient, slot, n)};
    for_surfaces(slot, n, node, [&](const Surface &surface) {
      const NodeSurface<dim> &at = surface.at_node;
      const Vector<dim> relative = velocity - at.velocity;
      const double pressing =
        pressing_impulse(solid, at, lattice.spacing, time_step, dot(relative, at.normal));
      velocity += (pressing / mass) * at.normal;
      note_energy(solid, at, 0.5 * time_step * dot(velocity - at.velocity, at.normal));
      if (is_free(surface))
        {
          add_reaction(surface.body, lattice.node_position(node), pressing * at.normal);
          if (pressing > 0. || holds(at))
            touched.push_back({slot, n, surface.body, at.normal, pressing, holds(at)});
        }
      else
        velocity -= taken_by(
          friction_share(at.contact, mass, pressing, at.normal, relative), at.normal, relative);
    });
    return velocity;
  }

  template <int dim>
  void
  SolidContact<dim>::note_energy(const NodeSolid<dim> &solid,
                                 const NodeSurface<dim> &surface,
                                 const double way)
  {
    const double area = contact_area(solid, surface, lattice.spacing);
    if (area == 0.)
      return;
    the_energy += area * solid.modulus * lattice.spacing *
                  contact_energy(std::max(0., -surface.gap - way) / lattice.spacing);
    the_depth = std::max(the_depth, -surface.gap);
  }

  template <int dim>
  Vector<dim>
  SolidContact<dim>::held(const int slot,
                          const int n,
                          const Index<dim> &node,
                          const double time_step,
                          Vector<dim> velocity) const
  {
    for_surfaces(slot, n, node, [&](const Surface &surface) {
      const NodeSurface<dim> &at = surface.at_node;
      if (!holds(at) || is_free(surface))
        return;
      const double allowed       = std::max(0., -at.gap) / time_step;
      const Vector<dim> relative = velocity - at.velocity - allowed * at.normal;
      if (dot(relative, at.normal) > 0.)
        velocity -= taken_by(contact_share(at.contact, at.normal, relative), at.normal, relative);
    });
    return velocity;
  }

  template <int dim>
  bool
  SolidContact<dim>::holds(const NodeSurface<dim> &surface) const
  {
    return surface.contact.condition != ContactCondition::separate && surface.distance <= 0. &&
           surface.gap <= holding_reach * lattice.spacing;
  }

  template <int dim>
  void
  SolidContact<dim>::add_reaction(const int body,
                                  const Vector<dim> &position,
                                  const Vector<dim> &impulse)
  {
    impulses_on_bodies[body] -= momentum_of(impulse, position - bodies[body].pose().position);
  }

  template class SolidContact<2>;
  template class SolidContact<3>;
} // namespace magmpm
