#include <magmpm/boundary/lattice_boundary.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    ContactCondition
    as_contact(const WallCondition condition)
    {
      switch (condition)
        {
          case WallCondition::stick:
            return ContactCondition::stick;
          case WallCondition::slip:
            return ContactCondition::slip;
          case WallCondition::open:
            return ContactCondition::none;
          case WallCondition::separate:
          default:
            return ContactCondition::separate;
        }
    }
  } // namespace

  template <int dim>
  LatticeBoundary<dim>::LatticeBoundary(const Lattice<dim> &lattice,
                                        const WallParameters<dim> &walls,
                                        const std::vector<RigidBody<dim>> &bodies)
    : lattice(lattice)
    , walls(walls)
    , bodies(bodies)
  {
  }

  template <int dim>
  Vector<dim>
  LatticeBoundary<dim>::constrained(const Index<dim> &node, Vector<dim> velocity) const
  {
    if (!bodies.empty())
      {
        const Vector<dim> position = lattice.node_position(node);
        for (const RigidBody<dim> &body : bodies)
          {
            if (body.is_free() || !body.is_near(position, 0.))
              continue;
            const SurfaceDistance<dim> surface = body.surface_distance(position);
            if (surface.distance >= 0.)
              continue;
            const Vector<dim> relative = velocity - body.velocity_at(position);
            velocity -= taken_by(
              contact_share(body.contact(), surface.normal, relative), surface.normal, relative);
          }
      }
    // Walls last: a node in a corner of a wall and a magnet must not leave the box.
    for (int face = 0; face < 2 * dim; ++face)
      if (is_at_wall(node, face))
        {
          Vector<dim> normal;
          normal[face / 2] = (face % 2 == 0 ? 1. : -1.);
          velocity -=
            taken_by(contact_share(
                       {as_contact(walls.condition[face]), walls.friction[face]}, normal, velocity),
                     normal,
                     velocity);
        }
    return velocity;
  }

  template <int dim>
  Vector<dim>
  LatticeBoundary<dim>::at_sticking_walls(const Index<dim> &node, const Vector<dim> &velocity) const
  {
    for (int face = 0; face < 2 * dim; ++face)
      if (walls.condition[face] == WallCondition::stick && is_at_wall(node, face))
        return {};
    return velocity;
  }

  template <int dim>
  double
  LatticeBoundary<dim>::max_speed() const
  {
    double speed = 0.;
    for (const RigidBody<dim> &body : bodies)
      speed = std::max(speed, body.max_speed());
    return speed;
  }

  template class LatticeBoundary<2>;
  template class LatticeBoundary<3>;
} // namespace magmpm
