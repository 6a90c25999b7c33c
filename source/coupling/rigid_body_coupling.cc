#include <magmpm/boundary/momentum_update.h>
#include <magmpm/coupling/rigid_body_coupling.h>
#include <magmpm/coupling/rigid_hold.h>
#include <magmpm/parallel/reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace magmpm
{
  namespace
  {
    /** How deep particles may lie in a rigid body: those pressed against it do, by less than this. */
    constexpr double tolerated_depth = 0.5; // of dx

    /** Points of the bodies' surfaces where they touch each other. */
    constexpr double spacing_of_points = 1.; // dx

    template <int n>
    double
    smallest_diagonal(const Matrix<n> &matrix)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (int i = 0; i < n; ++i)
        smallest = std::min(smallest, matrix(i, i));
      return smallest;
    }
  } // namespace

  template <int dim>
  RigidBodyCoupling<dim>::RigidBodyCoupling(const Parameters<dim> &parameters,
                                            ExternalField<dim> &external_field,
                                            const MPI_Comm communicator)
    : parameters(parameters)
    , external_field(external_field)
    , communicator(communicator)
    , rigid_bodies(parameters.sources, parameters.rigid_bodies, external_field)
    , boundary(parameters.lattice, parameters.walls, rigid_bodies.all())
    , collision(parameters.lattice,
                parameters.walls,
                rigid_bodies.all(),
                spacing_of_points * parameters.lattice.spacing)
    , magnet_forces(external_field)
  {
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::set_time(const double time)
  {
    external_field.set_time(time);
    rigid_bodies.set_time(time);
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::update_lattice(const BlockSet<dim> &blocks,
                                         const double typical_particle_mass,
                                         const RunState &state,
                                         NodeField<dim> &field)
  {
    update_lattice_momentum(blocks,
                            boundary,
                            parameters.gravity,
                            state.time_step,
                            parameters.rest.damping_rate,
                            typical_particle_mass,
                            field);
    if (!rigid_bodies.any_is_free())
      return;
    accelerate(state);
    collision.collide(blocks,
                      boundary,
                      state.time_step,
                      typical_particle_mass,
                      communicator,
                      rigid_bodies.all(),
                      field);
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::accelerate(const RunState &state)
  {
    std::vector<ForceAndTorque<dim>> forces;
    if (rigid_bodies.any_magnet_is_free())
      forces = magnet_forces.total(state.reactions);
    for (std::size_t b = 0; b < rigid_bodies.all().size(); ++b)
      {
        RigidBody<dim> &body = rigid_bodies.all()[b];
        if (!body.is_free())
          continue;
        const ForceAndTorque<dim> magnetic = magnetic_force(b, forces);
        body.add_impulse(state.time_step * (magnetic.force + body.mass() * parameters.gravity),
                         state.time_step * magnetic.torque);
      }
  }

  template <int dim>
  ForceAndTorque<dim>
  RigidBodyCoupling<dim>::magnetic_force(const std::size_t body,
                                         const std::vector<ForceAndTorque<dim>> &forces) const
  {
    const auto source = rigid_bodies.source_of(body);
    if (!source)
      return {};
    ForceAndTorque<dim> result       = forces[*source];
    const RigidBody<dim> &rigid_body = rigid_bodies.all()[body];
    result.torque += cross(rigid_body.pose_of_shape().position - rigid_body.pose().position,
                           result.force);
    return result;
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::advance(RunState &state)
  {
    for (RigidBody<dim> &body : rigid_bodies.all())
      if (body.is_free())
        body.advance(state.time_step);
    state.rigid_bodies = rigid_bodies.record();
  }

  template <int dim>
  double
  RigidBodyCoupling<dim>::hold_particles(const BlockSet<dim> &blocks,
                                         const OpenFaces<dim> &open,
                                         std::vector<Body<dim>> &bodies,
                                         RunState &state)
  {
    std::vector<RigidHold<dim>> pushed = push_out(blocks, bodies);
    std::size_t n_held                 = 0;
    for (Body<dim> &body : bodies)
      n_held += hold_at_walls(blocks, parameters.lattice, open, body);
    parallel::Reduction reduction;
    for (RigidHold<dim> &hold : pushed)
      {
        reduction.sum(hold);
        reduction.max(hold.deepest);
      }
    reduction.sum(n_held);
    reduction.carry_out(communicator);
    state.held_particles += n_held;

    const std::size_t pushed_before = state.particles_pushed_out;
    take_pushed(pushed, state);
    const bool any_pushed = state.particles_pushed_out > pushed_before;
    return any_pushed ? largest_push * parameters.lattice.spacing : 0.;
  }

  template <int dim>
  std::vector<RigidHold<dim>>
  RigidBodyCoupling<dim>::push_out(const BlockSet<dim> &blocks,
                                   std::vector<Body<dim>> &bodies) const
  {
    std::vector<RigidHold<dim>> pushed;
    for (const RigidBody<dim> &rigid_body : rigid_bodies.all())
      {
        pushed.emplace_back();
        if (rigid_body.contact().condition == ContactCondition::none)
          continue;
        for (Body<dim> &body : bodies)
          pushed.back() += hold_outside(blocks,
                                        parameters.lattice,
                                        rigid_body.shape(),
                                        rigid_body.pose_of_shape(),
                                        rigid_body.motion_of_shape(),
                                        tolerated_depth * parameters.lattice.spacing,
                                        body);
      }
    return pushed;
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::take_pushed(const std::vector<RigidHold<dim>> &pushed, RunState &state)
  {
    state.particles_inside = 0;
    for (std::size_t b = 0; b < pushed.size(); ++b)
      {
        RigidBody<dim> &body       = rigid_bodies.all()[b];
        const RigidHold<dim> &hold = pushed[b];
        state.particles_inside += hold.n_inside;
        state.particles_pushed_out += hold.n_held;
        state.deepest_penetration = std::max(state.deepest_penetration, hold.deepest);
        if (body.is_free())
          body.add_impulse(hold.impulse,
                           hold.angular_impulse +
                             cross(body.pose_of_shape().position - body.pose().position,
                                   hold.impulse));
      }
    state.rigid_bodies = rigid_bodies.record();
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::update_step_conditions(const RunState &state, StepConditions &conditions)
  {
    conditions.collider_speed     = boundary.max_speed();
    conditions.rotation_rate      = 0.;
    conditions.rigid_acceleration = 0.;
    if (!rigid_bodies.any_is_free())
      return;
    std::vector<ForceAndTorque<dim>> forces;
    if (rigid_bodies.any_magnet_is_free())
      forces = magnet_forces.total(state.reactions);
    for (std::size_t b = 0; b < rigid_bodies.all().size(); ++b)
      {
        const RigidBody<dim> &body = rigid_bodies.all()[b];
        if (!body.is_free())
          continue;
        const ForceAndTorque<dim> magnetic = magnetic_force(b, forces);
        const double inertia               = smallest_diagonal(body.inertia());
        conditions.rigid_acceleration =
          std::max(conditions.rigid_acceleration,
                   norm(parameters.gravity) + norm(magnetic.force) / body.mass() +
                     body.bounding_radius() * norm(magnetic.torque) / inertia);
        conditions.rotation_rate = std::max(
          {conditions.rotation_rate,
           norm(body.motion().angular_velocity),
           std::sqrt(norm(magnetic.torque) / inertia),
           rigid_bodies.source_of(b) ? magnet_forces.swing_rate(*rigid_bodies.source_of(b), inertia)
                                     : 0.});
      }
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::restore(const std::vector<double> &record)
  {
    rigid_bodies.restore(record);
  }

  template class RigidBodyCoupling<2>;
  template class RigidBodyCoupling<3>;
} // namespace magmpm
