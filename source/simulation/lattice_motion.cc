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
    has_fluids(const Parameters<dim> &parameters)
    {
      return std::any_of(
        parameters.bodies.begin(), parameters.bodies.end(), [&](const BodyParameters<dim> &body) {
          return parameters.material_of(body).law == MechanicalLaw::viscoelastic_fluid;
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
  LatticeMotion<dim>::LatticeMotion(const Parameters<dim> &parameters)
    : lattice(parameters.lattice)
    , gravity(parameters.gravity)
    , damping_rate(parameters.rest.damping_rate)
    , particle_mass(typical_particle_mass(parameters))
    , is_filtered(wants_filter(parameters))
    , has_smoothed_bodies(wants_smoothing(parameters))
    , images(parameters.lattice, parameters.walls, has_fluids(parameters))
  {
  }

  template <int dim>
  void
  LatticeMotion<dim>::reinit(const int n_blocks)
  {
    motion.reinit(n_blocks);
    if (has_smoothed_bodies)
      strain.reinit(n_blocks);
    if (!is_filtered)
      return;
    unconstrained.reinit(n_blocks);
    filtered.reinit(n_blocks);
    taken.reinit(n_blocks);
  }

  template <int dim>
  void
  LatticeMotion<dim>::smooth_volume(const BlockPartition<dim> &partition,
                                    std::vector<Body<dim>> &bodies)
  {
    if (!has_smoothed_bodies)
      return;
    const BlockSet<dim> &blocks = partition.blocks();
    for (const LameModuli &moduli : smoothed_materials(bodies))
      {
        sum_strain(bodies, moduli, blocks, lattice, strain);
        partition.add_ghosts_to_owners(strain);
        divide_by_weight(blocks, strain);
        partition.update_ghosts(strain);
        find_volumetric_stress(strain, moduli, blocks, lattice, bodies);
      }
  }

  template <int dim>
  void
  LatticeMotion<dim>::sum_momentum(const BlockPartition<dim> &partition,
                                   const double time_step,
                                   std::vector<Body<dim>> &bodies)
  {
    smooth_volume(partition, bodies);
    particles_to_lattice(bodies, partition.blocks(), lattice, time_step, motion);
    images.fold_sticking(partition.blocks(), motion);
    partition.add_ghosts_to_owners(motion);
  }

  template <int dim>
  void
  LatticeMotion<dim>::update_velocity(const Clock &clock,
                                      const BlockPartition<dim> &partition,
                                      const LatticeBoundary<dim> &boundary,
                                      SolidContact<dim> &contact)
  {
    const Vector<dim> acceleration = gravity(clock.time);
    if (images.are_chosen())
      {
        partition.update_ghosts(motion);
        images.choose_and_fold(partition.blocks(), contact, clock.time_step * acceleration, motion);
      }
    update_lattice_momentum(partition.blocks(),
                            boundary,
                            contact,
                            acceleration,
                            clock.time_step,
                            damping_rate,
                            particle_mass,
                            motion,
                            unconstrained);
  }

  template <int dim>
  void
  LatticeMotion<dim>::finish(const BlockPartition<dim> &partition,
                             const double time_step,
                             std::vector<Body<dim>> &bodies)
  {
    copy(partition, motion);
    if (!is_filtered)
      return;
    const BlockSet<dim> &blocks = partition.blocks();
    filter_velocity(
      bodies, std::vector<double>(bodies.size(), 1.), blocks, lattice, motion, filtered);
    sum(partition, filtered);
    update_filtered_velocity(blocks, particle_mass, motion, unconstrained, filtered);
    copy(partition, filtered);

    std::vector<double> shares;
    for (const Body<dim> &body : bodies)
      shares.push_back(share_given_back(body, lattice.spacing, time_step));
    if (std::all_of(shares.begin(), shares.end(), [&](const double a) { return a == shares[0]; }))
      return give_back(blocks, shares[0], motion, filtered, taken);
    filter_velocity(bodies, shares, blocks, lattice, motion, taken);
    sum(partition, taken);
    give_back_by_particle(blocks, particle_mass, motion, unconstrained, taken);
    copy(partition, taken);
  }

  template <int dim>
  void
  LatticeMotion<dim>::sum(const BlockPartition<dim> &partition, NodeField<dim> &momentum) const
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
  LatticeMotion<dim>::copy(const BlockPartition<dim> &partition, NodeField<dim> &velocity) const
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
    return lattice_to_particles(
      {motion, filtered, taken}, partition.blocks(), lattice, time_step, bodies);
  }

  template class LatticeMotion<2>;
  template class LatticeMotion<3>;
} // namespace magmpm
