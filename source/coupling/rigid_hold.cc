#include <magmpm/coupling/block_ball.h>
#include <magmpm/coupling/rigid_hold.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    template <int dim>
    Ball<dim>
    reach_of_shape(const Shape<dim> &shape, const Pose<dim> &pose)
    {
      const BoundingBox<dim> box = shape.bounding_box();
      return {pose.to_world(0.5 * (box.lower + box.upper)), 0.5 * norm(box.upper - box.lower)};
    }
  } // namespace

  template <int dim>
  RigidHold<dim>
  hold_outside(const BlockSet<dim> &blocks,
               const Lattice<dim> &lattice,
               const Shape<dim> &shape,
               const Pose<dim> &pose,
               const RigidMotion<dim> &motion,
               const double tolerated_depth,
               Body<dim> &body)
  {
    const ParticleArrays<dim> particles = body.particles.arrays();
    const Ball<dim> ball                = reach_of_shape(shape, pose);
    RigidHold<dim> result;
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      {
        if (!overlap(ball, reach_of_block<dim>(lattice, blocks.block(slot))))
          continue;
        for (std::size_t p = body.run_begin[slot]; p < body.run_begin[slot + 1]; ++p)
          {
            const Vector<dim> position = body.particles.position(p);
            if (!overlap<dim>(ball, {position, 0.}))
              continue;
            const SurfaceDistance<dim> nearest = shape.surface_distance(pose.to_own(position));
            if (nearest.distance >= 0.)
              continue;
            ++result.n_inside;
            result.deepest = std::max(result.deepest, -nearest.distance);
            if (-nearest.distance <= tolerated_depth)
              continue;
            ++result.n_held;
            const double way             = std::min(-nearest.distance - tolerated_depth,
                                        largest_push * lattice.spacing);
            const Vector<dim> normal     = pose.rotation * nearest.normal;
            const Vector<dim> from_frame = position - pose.position;
            Vector<dim> velocity;
            for (int d = 0; d < dim; ++d)
              {
                velocity[d] = particles.velocity[d][p];
                particles.position[d][p] += way * normal[d];
              }
            const double inward = std::min(0.,
                                           dot(velocity - motion.velocity_at(from_frame), normal));
            for (int d = 0; d < dim; ++d)
              particles.velocity[d][p] -= inward * normal[d];
            const Vector<dim> impulse = (particles.mass[p] * inward) * normal;
            result.impulse += impulse;
            result.angular_impulse += cross(from_frame, impulse);
          }
      }
    return result;
  }

#define INSTANTIATE(dim)                                         \
  template RigidHold<dim> hold_outside(const BlockSet<dim> &,    \
                                       const Lattice<dim> &,     \
                                       const Shape<dim> &,       \
                                       const Pose<dim> &,        \
                                       const RigidMotion<dim> &, \
                                       const double,             \
                                       Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
