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
    if (!sources.solid_sources().empty())
      {
        const Vector<dim> position = lattice.node_position(node);
        for (const MagneticSource<dim> *source : sources.solid_sources())
          {
            const Pose<dim> &pose = source->pose();
            const SurfaceDistance<dim> surface =
              source->shape()->surface_distance(pose.to_own(position));
            if (surface.distance < 0.)
              {
                const Vector<dim> moved = source->motion().velocity_at(position - pose.position);
                velocity                = moved + contact(source->contact(),
                                           pose.rotation * surface.normal,
                                           velocity - moved);
              }
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
    for (const MagneticSource<dim> *source : sources.solid_sources())
      {
        const RigidMotion<dim> &motion = source->motion();
        const BoundingBox<dim> box     = source->shape()->bounding_box();
        Vector<dim> farthest;
        for (int d = 0; d < dim; ++d)
          farthest[d] = std::max(std::abs(box.lower[d]), std::abs(box.upper[d]));
        speed = std::max(speed,
                         norm(motion.velocity) + norm(motion.angular_velocity) * norm(farthest));
      }
    return speed;
  }

  template class LatticeBoundary<2>;
  template class LatticeBoundary<3>;
} // namespace magmpm
