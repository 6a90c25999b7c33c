#include <magmpm/boundary/fluid_contact.h>
#include <magmpm/boundary/momentum_update.h>
#include <magmpm/coupling/contact_sums.h>
#include <magmpm/coupling/density_relaxation.h>
#include <magmpm/coupling/magnet_bodies.h>
#include <magmpm/coupling/rigid_body_coupling.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /**
     * How deep particles may lie in a rigid body, in dx. Solids are pressed out by contact the harder the deeper
     * they are; fluids end at the surface.
     */
    template <int dim>
    double
    tolerated_depth(const Body<dim> &body)
    {
      return body.particles.n_components(ParticleProperty::half_extent) > 0 ? 1. : 0.;
    }

    /** Points of the bodies' surfaces where they touch each other. */
    constexpr double spacing_of_points = 1.; // dx

    /** Magnets first, then the others. */
    template <int dim>
    std::vector<MovedBody<dim>>
    all_bodies(const RigidBodyCouplingParameters<dim> &parameters,
               const ExternalField<dim> &external_field)
    {
      auto result =
        make_magnet_bodies(parameters.sources, parameters.magnet_bodies, external_field);
      for (MovedBody<dim> &body : make_rigid_bodies(parameters.rigid_bodies))
        result.push_back(std::move(body));
      return result;
    }
  } // namespace

  template <int dim>
  RigidBodyCoupling<dim>::RigidBodyCoupling(const RigidBodyCouplingParameters<dim> &parameters,
                                            ExternalField<dim> &external_field,
                                            const CarriedReactions<dim> &reactions,
                                            const MPI_Comm communicator)
    : parameters(parameters)
    , external_field(external_field)
    , reactions(reactions)
    , communicator(communicator)
    , rigid_bodies(all_bodies(parameters, external_field))
    , boundary(parameters.lattice, parameters.walls)
    , collision(parameters.lattice,
                parameters.walls,
                rigid_bodies.all(),
                spacing_of_points * parameters.lattice.spacing)
    , magnet_forces(external_field)
    , forces_of_row(external_field.sources().size())
  {
    for (std::size_t g = 0; g < parameters.contact_groups.size(); ++g)
      solid_contacts.emplace_back(parameters.lattice, parameters.walls, rigid_bodies.all());
    move_free_sources(rigid_bodies, external_field);
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::set_time(const double time)
  {
    external_field.set_time(time);
    rigid_bodies.set_time(time);
    move_free_sources(rigid_bodies, external_field);
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::find_contact(const BlockPartition<dim> &partition,
                                       const std::vector<Body<dim>> &bodies)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    for (std::size_t g = 0; g < solid_contacts.size(); ++g)
      {
        SolidContact<dim> &contact = solid_contacts[g];
        contact.reinit(now.contact_is_near ? blocks.size() : 0);
        if (!now.contact_is_near)
          continue;
        sum_contact(bodies,
                    parameters.contact_groups[g],
                    blocks,
                    parameters.lattice,
                    contact,
                    contact.sums());
        partition.add_ghosts_to_owners(contact.sums());
        // Images behind walls are chosen on ghosts too, see WallImages.
        if (has_fluid(bodies))
          partition.update_ghosts(contact.sums());
      }
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::collide(const Clock &clock,
                                  const BlockPartition<dim> &partition,
                                  const bool has_fluids,
                                  const double typical_particle_mass,
                                  std::vector<GroupMotion<dim>> &groups)
  {
    const bool meets_fluids = has_fluids && solid_contacts.front().has_bodies();
    if (!rigid_bodies.any_is_free() && !meets_fluids)
      return;
    accelerate(clock);
    if (meets_fluids)
      {
        GroupMotion<dim> &of_fluids = groups.front(); // group 0
        partition.update_ghosts(of_fluids.motion);
        FluidContact<dim> fluid(find_fluid_constraints(rigid_bodies.all(),
                                                       solid_contacts.front(),
                                                       parameters.walls,
                                                       partition.blocks(),
                                                       parameters.lattice,
                                                       negligible_mass(typical_particle_mass),
                                                       of_fluids.motion,
                                                       communicator));
        fluid.solve(rigid_bodies.all());
        fluid.apply(partition.blocks(), boundary, of_fluids.motion, of_fluids.unconstrained);
      }
    std::vector<CollidingGroup<dim>> colliding;
    for (std::size_t g = 0; g < groups.size(); ++g)
      colliding.push_back({solid_contacts[g], groups[g].motion, groups[g].unconstrained});
    collision.collide(
      partition.blocks(), boundary, clock.time_step, communicator, colliding, rigid_bodies.all());
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::accelerate(const Clock &clock)
  {
    const Vector<dim> gravity                     = parameters.gravity(clock.time);
    const std::vector<ForceAndTorque<dim>> forces = forces_on_free_magnets();
    for (std::size_t b = 0; b < rigid_bodies.all().size(); ++b)
      {
        RigidBody<dim> &body = rigid_bodies.all()[b];
        if (!body.is_free())
          continue;
        const ForceAndTorque<dim> magnetic = magnetic_force(b, forces);
        body.add_impulse(clock.time_step * (magnetic.force + body.mass() * gravity),
                         clock.time_step * magnetic.torque);
      }
  }

  template <int dim>
  std::vector<ForceAndTorque<dim>>
  RigidBodyCoupling<dim>::forces_on_free_magnets() const
  {
    if (!rigid_bodies.any_magnet_is_free())
      return {};
    return magnet_forces.total(reactions);
  }

  template <int dim>
  ForceAndTorque<dim>
  RigidBodyCoupling<dim>::magnetic_force(const std::size_t body,
                                         const std::vector<ForceAndTorque<dim>> &forces) const
  {
    const auto source = rigid_bodies.source_of(body);
    if (!source || forces.empty())
      return {};
    ForceAndTorque<dim> result       = forces[*source];
    const RigidBody<dim> &rigid_body = rigid_bodies.all()[body];
    result.torque += cross(rigid_body.pose_of_shape().position - rigid_body.pose().position,
                           result.force);
    return result;
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::advance(const Clock &clock)
  {
    for (RigidBody<dim> &body : rigid_bodies.all())
      if (body.is_free())
        body.advance(clock.time_step);
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::hold_particles(const BlockSet<dim> &blocks,
                                         const OpenFaces<dim> &open,
                                         std::vector<Body<dim>> &bodies)
  {
    now.holds.clear();
    for (const RigidBody<dim> &rigid_body : rigid_bodies.all())
      {
        if (rigid_body.contact().condition == ContactCondition::none)
          continue;
        RigidHold<dim> all;
        for (Body<dim> &body : bodies)
          all += hold_outside(blocks,
                              parameters.lattice,
                              rigid_body.shape(),
                              rigid_body.pose_of_shape(),
                              rigid_body.motion_of_shape(),
                              tolerated_depth(body) * parameters.lattice.spacing,
                              body);
        now.holds.push_back(all);
      }
    now.held = 0;
    for (Body<dim> &body : bodies)
      now.held += hold_at_walls(blocks, parameters.lattice, open, body);
    now.contact_energy = now.contact_depth = 0.;
    for (const SolidContact<dim> &contact : solid_contacts)
      {
        now.contact_energy += contact.energy();
        now.contact_depth = std::max(now.contact_depth, contact.depth());
      }
    now.contact_is_near =
      is_contact_near(bodies, blocks, parameters.lattice, solid_contacts.front());
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::note_contact(const double energy, const double depth)
  {
    now.contact_energy += energy;
    now.contact_depth = std::max(now.contact_depth, depth);
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::reduce(parallel::Reduction &reduction)
  {
    now.reduce(reduction);
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::take_reduced()
  {
    counts.held += now.held;
    counts.energy = now.contact_energy;
    counts.depth  = std::max(counts.depth, now.contact_depth);
    counts.inside = 0;
    auto hold     = now.holds.begin();
    for (RigidBody<dim> &body : rigid_bodies.all())
      {
        if (body.contact().condition == ContactCondition::none)
          continue;
        counts.inside += hold->n_inside;
        counts.pushed += hold->n_held;
        counts.deepest = std::max(counts.deepest, hold->deepest);
        if (body.is_free())
          body.add_impulse(hold->impulse,
                           hold->angular_impulse +
                             cross(body.pose_of_shape().position - body.pose().position,
                                   hold->impulse));
        ++hold;
      }
  }

  template <int dim>
  double
  RigidBodyCoupling<dim>::longest_push() const
  {
    const bool any_pushed = std::any_of(now.holds.begin(), now.holds.end(), [](const auto &hold) {
      return hold.n_held > 0;
    });
    return any_pushed ? largest_push * parameters.lattice.spacing : 0.;
  }

  template class RigidBodyCoupling<2>;
  template class RigidBodyCoupling<3>;
} // namespace magmpm
