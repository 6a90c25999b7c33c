#include <magmpm/parameters/parameter_file.h>
#include <magmpm/simulation/scene.h>

#include <verification/mechanics/lifted_block.h>
#include <verification/program/program_run.h>

#include <cmath>
#include <string>

namespace magmpm::verification
{
  namespace
  {
    constexpr double dx = 1e-3; // m

    Parameters<2>
    parameters_of(const LiftedBlock &block, const std::string &strength)
    {
      const std::string text = R"(
set Dimension = 2
set End time = 0.12
set Gravity = 0, -9.81
subsection Box
  set Upper corner = 0.064, 0.064
  set Cell size = 0.001
end
subsection Bodies
  set List of bodies = lower, upper
  subsection lower
    set Material = plain
    set Lower corner = 0.022, 0
    set Upper corner = 0.042, 0.008
    set Density = 1000
  end
  subsection upper
    set Material = magnetic
    set Lower corner = 0.026, 0.008
    set Upper corner = 0.038, 0.014
    set Density = 1000
    set Contact group = )" + std::to_string(block.n_groups - 1) +
                               R"(
  end
end
subsection Materials
  set List of materials = plain, magnetic
  subsection plain
    set Young's modulus = 2e4
    set Poisson ratio = 0.3
  end
  subsection magnetic
    set Young's modulus = 2e4
    set Poisson ratio = 0.3
    set Saturation magnetization = 1e5
    set Initial susceptibility = 1
  end
end
subsection Magnets
  set List of magnets = rod
  subsection rod
    set Type = magnetized sphere
    set Position = 0.032; 0.045
    set Radius = 0.010
    set Magnetization = 0; 1.6e6
    set Strength = )" + strength +
                               R"(
    set Contact = separate
  end
end
)";
      return read_parameters<2>(parse_parameter_text(text, "lifted_block.prm"));
    }

    /** The force on the block where it lies, over its weight. */
    double
    pull_at(const LiftedBlock &block, const double strength)
    {
      Scene<2> scene(parameters_of(block, as_text(strength)), MPI_COMM_SELF);
      scene.begin();
      constexpr double weight = 1000. * 9.81 * 12. * 6. * dx * dx; // N/m
      return scene.total().magnetic_force[1] / weight;
    }

    double
    height_of_upper(const Scene<2> &scene)
    {
      const ParticleSet<2> &particles = scene.bodies()[1].particles;
      double sum = 0., mass = 0.;
      for (std::size_t p = 0; p < particles.size(); ++p)
        {
          const double m = particles.component(ParticleProperty::mass, 0)[p];
          sum += m * particles.position(p)[1];
          mass += m;
        }
      return sum / mass;
    }
  } // namespace

  double
  rise_of_block(const LiftedBlock &block)
  {
    // The force grows with the square of the magnet's strength until the block saturates.
    double strength = 0.3;
    for (int i = 0; i < 8; ++i)
      strength *= std::sqrt(block.pull / pull_at(block, strength));

    Scene<2> scene(parameters_of(block, as_text(strength) + "*min(t/0.02, 1)"), MPI_COMM_SELF);
    scene.begin();
    const double start = height_of_upper(scene);
    while (scene.time() < 0.12)
      scene.step({0.12, false, {}});
    return (height_of_upper(scene) - start) / dx;
  }
} // namespace magmpm::verification
