#include <magmpm/boundary/lattice_boundary.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** What a contact leaves of the velocity relative to a surface with outward normal @p normal. */
    template <int dim>
    Vector<dim>
    contact(const ContactCondition condition,
            const Vector<dim> &normal,
            const Vector<dim> &relative)
    {
      const double normal_velocity = dot(relative, normal);
      switch (condition)
        {
          case ContactCondition::stick:
            return {};
          case ContactCondition::slip:
            return relative - normal_velocity * normal;
          case ContactCondition::separate:
            return relative - std::min(normal_velocity, 0.) * normal;
          case ContactCondition::none:
          default:
            return relative;
        }
    }

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
                                        const ExternalField<dim> &sources)
    : lattice(lattice)
    , walls(walls)
    , sources(sources)
  {
  }

  template <int dim>
  Vector<dim>
  LatticeBoundary<dim>::constrained(const Index<dim> &node, Vector<dim> velocity) const
  {
    if (!sources.solid_spheres().empty())
      {
        const Vector<dim> position = lattice.node_position(node);
        for (const MagnetizedSphere<dim> *sphere : sources.solid_spheres())
          {
            const Vector<dim> r   = position - sphere->centre();
            const double distance = norm(r);
            // In the very centre no direction is outward, and the node just follows.
            if (distance < sphere->radius())
              velocity = sphere->velocity() +
                         contact(distance > 0. ? sphere->contact() : ContactCondition::stick,
                                 (1. / std::max(distance, 1e-300)) * r,
                                 velocity - sphere->velocity());
          }
      }
    // Walls last: a node in a corner of a wall and a magnet must not leave the box.
    for (int d = 0; d < dim; ++d)
      for (int side = 0; side < 2; ++side)
        if (side == 0 ? node[d] <= 0 : node[d] >= lattice.n_cells[d])
          {
            Vector<dim> normal;
            normal[d] = (side == 0 ? 1. : -1.);
            velocity  = contact(as_contact(walls.condition[2 * d + side]), normal, velocity);
          }
    return velocity;
  }

  template <int dim>
  double
  LatticeBoundary<dim>::max_speed() const
  {
    double speed = 0.;
    for (const MagnetizedSphere<dim> *sphere : sources.solid_spheres())
      speed = std::max(speed, norm(sphere->velocity()));
    return speed;
  }

  template class LatticeBoundary<2>;
  template class LatticeBoundary<3>;
} // namespace magmpm
