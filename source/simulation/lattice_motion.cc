#include <magmpm/boundary/momentum_update.h>
#include <magmpm/particles/make_material.h>
#include <magmpm/particles/velocity_filter.h>
#include <magmpm/simulation/lattice_motion.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** The largest mass of an undeformed particle [kg]. */
    template <int dim>
    double
    typical_particle_mass(const Parameters<dim> &parameters)
    {
      double mass = 0.;
      for (const BodyParameters<dim> &body : parameters.bodies)
        mass = std::max(mass, body.density * body.particle_volume(parameters.lattice));
      return mass;
    }

    template <int dim>
    bool
    wants_filter(const Parameters<dim> &parameters)
    {
      return std::any_of(
        parameters.bodies.begin(), parameters.bodies.end(), [&](const BodyParameters<dim> &body) {
          return parameters.material_of(body).transfer == Transfer::fmpm;
        });
    }

    template <int dim>
    bool
    has_fluids(const Parameters<dim> &parameters, const int group)
    {
      return std::any_of(
        parameters.bodies.begin(), parameters.bodies.end(), [&](const BodyParameters<dim> &body) {
          return body.contact_group == group &&
                 parameters.material_of(body).law == MechanicalLaw::viscoelastic_fluid;
        });
    }

    template <int dim>
    bool
    wants_smoothing(const Parameters<dim> &parameters)
    {
      return std::any_of(
        parameters.bodies.begin(), parameters.bodies.end(), [&](const BodyParameters<dim> &body) {
          return smoothed_modulus(make_material<dim>(parameters.material_of(body), body.density)) >
                 0.;
        });
    }
  } // namespace

  template <int dim>
  LatticeMotion<dim>::LatticeMotion(const Parameters<dim> &parameters, const MPI_Comm communicator)
    : lattice(parameters.lattice)
    , gravity(parameters.gravity)
    , damping_rate(parameters.rest.damping_rate)
    , particle_mass(typical_particle_mass(parameters))
    , is_filtered(wants_filter(parameters))
    , has_smoothed_bodies(wants_smoothing(parameters))
    , group_contact(parameters.lattice,
                    parameters.contact_groups(),
                    parameters.contacts,
                    communicator)
    , welds(parameters.lattice, communicator)
  {
    for (const int group : parameters.contact_groups())
      groups.push_back(
        {group,
         WallImages<dim>(parameters.lattice, parameters.walls, has_fluids(parameters, group)),
         {},
         {},
         {},
         {}});
  }

  template <int dim>
  void
  LatticeMotion<dim>::reinit(const int n_blocks)
  {
    if (has_smoothed_bodies)
      strain.reinit(n_blocks);
    for (GroupMotion<dim> &group : groups)
      {
        group.motion.reinit(n_blocks);
        if (!is_filtered)
          continue;
        group.unconstrained.reinit(n_blocks);
        group.filtered.reinit(n_blocks);
        group.taken.reinit(n_blocks);
      }
  }

  template <int dim>
  void
  LatticeMotion<dim>::smooth_volume(const BlockPartition<dim> &partition,
                                    std::vector<Body<dim>> &bodies)
  {
    if (!has_smoothed_bodies)
      return;
    const BlockSet<dim> &blocks = partition.blocks();
    for (const SmoothedMaterial &material : smoothed_materials(bodies))
      {
        sum_strain(bodies, material, blocks, lattice, strain);
        partition.add_ghosts_to_owners(strain);
        divide_by_weight(blocks, strain);
        partition.update_ghosts(strain);
        find_volumetric_stress(strain, material, blocks, lattice, bodies);
      }
  }

  template <int dim>
  void
  LatticeMotion<dim>::sum_momentum(const BlockPartition<dim> &partition,
                                   const double time_step,
                                   std::vector<Body<dim>> &bodies)
  {
    smooth_volume(partition, bodies);
    for (GroupMotion<dim> &group : groups)
      {
        particles_to_lattice(
          bodies, partition.blocks(), lattice, time_step, group.motion, group.group);
        group.images.fold_sticking(partition.blocks(), group.motion);
        partition.add_ghosts_to_owners(group.motion);
      }
  }

  template <int dim>
  void
  LatticeMotion<dim>::update_velocity(const Clock &clock,
                                      const BlockPartition<dim> &partition,
                                      const LatticeBoundary<dim> &boundary,
                                      const std::vector<Body<dim>> &bodies,
                                      std::vector<SolidContact<dim>> &contacts)
  {
    group_contact.act(partition, bodies, clock.time_step, negligible_mass(particle_mass), groups);
    const Vector<dim> acceleration = gravity(clock.time);
    for (std::size_t g = 0; g < groups.size(); ++g)
      {
        GroupMotion<dim> &group = groups[g];
        if (group.images.are_chosen())
          {
            partition.update_ghosts(group.motion);
            group.images.choose_and_fold(
              partition.blocks(), contacts[g], clock.time_step * acceleration, group.motion);
          }
        update_lattice_momentum(partition.blocks(),
                                boundary,
                                contacts[g],
                                acceleration,
                                clock.time_step,
                                damping_rate,
                                particle_mass,
                                group.motion,
                                group.unconstrained);
      }
  }

  template <int dim>
  void
  LatticeMotion<dim>::finish(const BlockPartition<dim> &partition,
                             const double time_step,
                             std::vector<Body<dim>> &bodies)
  {
    for (GroupMotion<dim> &group : groups)
      {
        copy(partition, group.images, group.motion);
        if (is_filtered)
          filter(partition, time_step, bodies, group);
      }
  }

  template <int dim>
  void
  LatticeMotion<dim>::filter(const BlockPartition<dim> &partition,
                             const double time_step,
                             std::vector<Body<dim>> &bodies,
                             GroupMotion<dim> &group) const
  {
    const BlockSet<dim> &blocks   = partition.blocks();
    const auto filter_with_shares = [&](const std::vector<double> &factors, NodeField<dim> &sums) {
      filter_velocity(bodies, factors, blocks, lattice, group.motion, sums, group.group);
      sum(partition, group.images, sums);
    };
    filter_with_shares(std::vector<double>(bodies.size(), 1.), group.filtered);
    update_filtered_velocity(
      blocks, particle_mass, group.motion, group.unconstrained, group.filtered);
    copy(partition, group.images, group.filtered);

    std::vector<double> shares, of_group;
    for (const Body<dim> &body : bodies)
      {
        shares.push_back(share_given_back(body, lattice.spacing, time_step));
        if (is_in_group(body, group.group))
          of_group.push_back(shares.back());
      }
    if (std::all_of(of_group.begin(), of_group.end(), [&](const double a) {
          return a == of_group[0];
        }))
      return give_back(blocks, of_group[0], group.motion, group.filtered, group.taken);
    filter_with_shares(shares, group.taken);
    give_back_by_particle(blocks, particle_mass, group.motion, group.unconstrained, group.taken);
    copy(partition, group.images, group.taken);
  }

  template <int dim>
  void
  LatticeMotion<dim>::sum(const BlockPartition<dim> &partition,
                          const WallImages<dim> &images,
                          NodeField<dim> &momentum) const
  {
    images.fold_sticking(partition.blocks(), momentum);
    partition.add_ghosts_to_owners(momentum);
    if (!images.are_chosen())
      return;
    partition.update_ghosts(momentum);
    images.fold_chosen(momentum);
  }

  template <int dim>
  void
  LatticeMotion<dim>::copy(const BlockPartition<dim> &partition,
                           const WallImages<dim> &images,
                           NodeField<dim> &velocity) const
  {
    partition.update_ghosts(velocity);
    images.unfold(partition.blocks(), velocity);
  }

  template <int dim>
  std::vector<ParticleExtremes>
  LatticeMotion<dim>::move_particles(const BlockPartition<dim> &partition,
                                     const double time_step,
                                     std::vector<Body<dim>> &bodies) const
  {
    std::vector<ParticleExtremes> extremes(bodies.size());
    for (const GroupMotion<dim> &group : groups)
      {
        const auto moved = lattice_to_particles({group.motion, group.filtered, group.taken},
                                                partition.blocks(),
                                                lattice,
                                                time_step,
                                                bodies,
                                                group.group);
        for (std::size_t b = 0; b < bodies.size(); ++b)
          if (is_in_group(bodies[b], group.group))
            extremes[b] = moved[b];
      }
    return extremes;
  }

  template class LatticeMotion<2>;
  template class LatticeMotion<3>;
} // namespace magmpm
