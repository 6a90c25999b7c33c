#include <magmpm/boundary/momentum_update.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_sort.h>
#include <magmpm/particles/smoothed_volume.h>
#include <magmpm/particles/velocity_filter.h>

#include <verification/particles/random_bodies.h>

#include <baselines/plain_particles/plain_particles.h>
#include <particle_step/timed_step.h>
#include <shared/stopwatch.h>

#include <algorithm>
#include <numeric>

namespace magmpm::benchmarks
{
  using baselines::PlainParticles;

  namespace
  {
    class PlainStep : public TimedStep
    {
    public:
      explicit PlainStep(const FallingBlock &block)
        : particles(block.lattice, block.bodies)
        , time_step(block.time_step)
      {
      }

      void
      run(const Phase phase) override
      {
        switch (phase)
          {
            case Phase::sort:
              return particles.sort();
            case Phase::p2g:
              return particles.particles_to_lattice(time_step);
            case Phase::lattice:
              return particles.update_lattice(time_step, gravity, 0);
            case Phase::g2p:
              return particles.lattice_to_particles(time_step);
          }
      }

    private:
      PlainParticles<3> particles;
      double time_step;
    };

    class KernelStep : public TimedStep
    {
    public:
      KernelStep(const FallingBlock &block, const Transfer transfer)
        : lattice(block.lattice)
        , bodies(block.bodies)
        , time_step(block.time_step)
        , boundary(lattice, walls())
        , no_contact(lattice, walls(), no_rigid_bodies)
        , particle_mass(bodies[0].particles.component(ParticleProperty::mass, 0)[0])
      {
        for (Body<3> &body : bodies)
          body.transfer = transfer;
      }

      void
      run(const Phase phase) override
      {
        switch (phase)
          {
            case Phase::sort:
              blocks = verification::active_blocks(bodies, lattice);
              verification::sort_all(blocks, lattice, bodies);
              if (bodies[0].transfer == Transfer::fmpm)
                for (NodeField<3> *wanted : {&unconstrained, &filtered, &taken})
                  wanted->reinit(blocks.size());
              if (!smoothed_materials(bodies).empty())
                strain.reinit(blocks.size());
              return field.reinit(blocks.size());
            case Phase::p2g:
              smooth_volume();
              return particles_to_lattice(bodies, blocks, lattice, time_step, field);
            case Phase::lattice:
              return update_lattice();
            case Phase::g2p:
              lattice_to_particles({field, filtered, taken}, blocks, lattice, time_step, bodies);
          }
      }

    private:
      void
      smooth_volume()
      {
        for (const SmoothedMaterial &material : smoothed_materials(bodies))
          {
            sum_strain(bodies, material, blocks, lattice, strain);
            divide_by_weight(blocks, strain);
            find_volumetric_stress(strain, material, blocks, lattice, bodies);
          }
      }

      void
      update_lattice()
      {
        update_lattice_momentum(blocks,
                                boundary,
                                no_contact,
                                {{0., 0., gravity}},
                                time_step,
                                0.,
                                particle_mass,
                                field,
                                unconstrained);
        if (bodies[0].transfer != Transfer::fmpm)
          return;
        filter_velocity(bodies, {1.}, blocks, lattice, field, filtered);
        update_filtered_velocity(blocks, particle_mass, field, unconstrained, filtered);
        give_back(
          blocks, share_given_back(bodies[0], lattice.spacing, time_step), field, filtered, taken);
      }

      static WallParameters<3>
      walls()
      {
        WallParameters<3> walls;
        walls.condition.fill(WallCondition::separate);
        return walls;
      }

      Lattice<3> lattice;
      std::vector<Body<3>> bodies;
      double time_step;
      const std::vector<RigidBody<3>> no_rigid_bodies;
      LatticeBoundary<3> boundary;
      SolidContact<3> no_contact; // with the walls: none is near
      double particle_mass;
      BlockSet<3> blocks;
      NodeField<3> field;
      NodeField<3> unconstrained, filtered, taken; // without blocks for APIC
      NodeField<3, NodeStrain> strain;             // without blocks unless nearly incompressible
    };
  } // namespace

  double
  PhaseTimes::total() const
  {
    return std::accumulate(seconds.begin(), seconds.end(), 0.);
  }

  std::unique_ptr<TimedStep>
  make_plain_step(const FallingBlock &block)
  {
    return std::make_unique<PlainStep>(block);
  }

  std::unique_ptr<TimedStep>
  make_kernel_step(const FallingBlock &block, const Transfer transfer)
  {
    return std::make_unique<KernelStep>(block, transfer);
  }

  PhaseTimes
  time_of_steps(TimedStep &step, const int n_steps)
  {
    PhaseTimes times;
    const auto timed = [&](const Phase phase) {
      const Stopwatch watch;
      step.run(phase);
      times.seconds[static_cast<int>(phase)] += watch.seconds();
    };
    timed(Phase::sort);
    for (int n = 0; n < n_steps; ++n)
      for (const Phase phase : {Phase::p2g, Phase::lattice, Phase::g2p})
        timed(phase);
    return times;
  }

  Spread
  spread(std::vector<double> values)
  {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return {values.front(),
            values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half])};
  }
} // namespace magmpm::benchmarks
