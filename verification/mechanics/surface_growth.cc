#include <magmpm/base/constants.h>

#include <verification/mechanics/surface_growth.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace magmpm::verification
{
  namespace
  {
    constexpr double gravity        = 9.81; // m/s^2
    constexpr double density        = 1000.;
    constexpr double susceptibility = 1.;
    constexpr double wave_length    = 0.1; // m
    constexpr double k              = 2. * constants::pi / wave_length;
    constexpr double depth          = 0.5 * wave_length;
    constexpr double length         = 2. * wave_length; // of the layer
    constexpr int n_frames          = 40;

    /** 1 + mu_0/mu */
    constexpr double factor = 1. + 1. / (1. + susceptibility);

    /** M of the layer [A/m], such that k is over_cutoff times k_c. */
    double
    magnetization(const SurfaceWave &wave)
    {
      return std::sqrt(density * gravity * factor * wave.over_cutoff /
                       (k * constants::vacuum_permeability));
    }

    double
    exact_square(const SurfaceWave &wave)
    {
      const double m = magnetization(wave);
      return constants::vacuum_permeability * m * m * k * k / (density * factor) -
             gravity * k * std::tanh(k * depth);
    }

    /** cosh(s t), or cos(omega t) if the square of s is negative. */
    double
    course(const double square, const double time)
    {
      return square > 0. ? std::cosh(std::sqrt(square) * time)
                         : std::cos(std::sqrt(-square) * time);
    }

    /** A box-shaped part of the layer. */
    struct Part
    {
      double left, right, lower, upper; // m
    };

    /**
     * The layer as a box below the troughs and, above it, slabs as thick as particles are apart, as long as
     * the wave is higher than their middle: the surface has steps that P2G smooths.
     */
    std::vector<Part>
    parts_of_layer(const double amplitude, const double distance)
    {
      const int n             = static_cast<int>(std::ceil(amplitude / distance));
      std::vector<Part> parts = {{0., length, 0., depth - n * distance}};
      for (int j = -n; j < n; ++j)
        {
          const double height = (j + 0.5) * distance / amplitude;
          const double lower = depth + j * distance, upper = lower + distance;
          if (height <= -1.)
            parts.push_back({0., length, lower, upper});
          else if (height < 1.)
            for (double crest = 0.; crest < 1.01 * length; crest += wave_length)
              {
                const double half = std::acos(height) / k;
                parts.push_back(
                  {std::max(0., crest - half), std::min(length, crest + half), lower, upper});
              }
        }
      return parts;
    }

    std::string
    bodies(const SurfaceWave &wave)
    {
      const double distance         = depth / wave.cells_per_half_wave / wave.particles_per_edge;
      const std::vector<Part> parts = parts_of_layer(wave.steepness / k, distance);
      std::string names, text;
      for (std::size_t i = 0; i < parts.size(); ++i)
        {
          const std::string name = "part" + std::to_string(i);
          names += (i > 0 ? ", " : "") + name;
          text +=
            "subsection " + name +
            "\nset Material = ferrofluid\nset Lower corner = " + as_text(parts[i].left) + ", " +
            as_text(parts[i].lower) + "\nset Upper corner = " + as_text(parts[i].right) + ", " +
            as_text(parts[i].upper) + "\nset Density = " + as_text(density) +
            "\nset Particles per edge = " + std::to_string(wave.particles_per_edge) + "\nend\n";
        }
      return "subsection Bodies\nset List of bodies = " + names + "\n" + text + "end\n";
    }

    std::string
    scene(const SurfaceWave &wave)
    {
      const double dx    = depth / wave.cells_per_half_wave;
      const double end   = wave.duration / std::sqrt(std::abs(exact_square(wave)));
      const double sound = wave.sound_ratio * std::sqrt(gravity / k);
      return "set Dimension = 2\nset End time = " + as_text(end) + "\nset Gravity = 0, " +
             as_text(-gravity) + "\nset Checkpoint every = never\n" +
             "subsection Box\nset Upper corner = " + as_text(length) + ", " + as_text(2. * depth) +
             "\nset Cell size = " + as_text(dx) + "\nend\n" + bodies(wave) +
             "subsection Materials\nset List of materials = ferrofluid\nsubsection ferrofluid\n"
             "set Mechanical law = viscoelastic fluid\nset Viscosity = 1e-6\nset Bulk modulus = " +
             as_text(density * sound * sound) +
             "\nset Initial susceptibility = " + as_text(susceptibility) + "\nend\nend\n" +
             "subsection Magnets\nset List of magnets = coil\nsubsection coil\nset Field = 0; " +
             as_text((1. + susceptibility) / susceptibility * magnetization(wave)) +
             "\nend\nend\n" + R"(
subsection Walls
  set Lower x = slip
  set Upper x = slip
  set Lower y = slip
  set Upper y = slip
end
subsection Magnetics
  set Magnetization law = linear
  set Newton tolerance  = 1e-6
  subsection Potential box
    set Lower x = shielded
    set Upper x = shielded
    set Lower y = shielded
    set Upper y = shielded
  end
end
subsection Output
  set Particle quantities = J
  set Fields              = false
  set Statistics every    = 1000
  set Frame interval      = )" +
             as_text(end / n_frames) + "\nend\n";
    }

    double
    amplitude(const ParticleFrame &frame, const SurfaceWave &wave)
    {
      const double volume = std::pow(depth / wave.cells_per_half_wave / wave.particles_per_edge, 2);
      double sum          = 0.;
      for (const auto &position : frame.positions)
        if (std::abs(position[0] - 0.5 * length) <= 0.5 * wave_length)
          sum += volume * std::cos(k * position[0]);
      return 2. / wave_length * sum;
    }

    /** Least squares of c course(square, t): c, and the sum of the squares that are left. */
    std::pair<double, double>
    fit(const std::vector<std::pair<double, double>> &amplitudes, const double square)
    {
      double ff = 0., af = 0., aa = 0.;
      for (const auto &[time, a] : amplitudes)
        {
          const double f = course(square, time);
          ff += f * f;
          af += a * f;
          aa += a * a;
        }
      return {af / ff, aa - af * af / ff};
    }
  } // namespace

  double
  SurfaceGrowth::relative_error() const
  {
    if (exact_square * measured_square <= 0.)
      return -1.;
    return std::sqrt(measured_square / exact_square) - 1.;
  }

  SurfaceGrowth
  surface_growth(const SurfaceWave &wave)
  {
    const std::string name = "surface-growth-" + as_text(wave.over_cutoff) + "-" +
                             std::to_string(wave.cells_per_half_wave) + "-" +
                             std::to_string(wave.particles_per_edge);
    std::vector<std::pair<double, double>> amplitudes;
    for (const ParticleFrame &frame : particle_frames(run_scene(name, scene(wave))))
      amplitudes.emplace_back(frame.time, amplitude(frame, wave));

    SurfaceGrowth growth;
    growth.exact_square = exact_square(wave);
    double least        = 1e300;
    for (int i = -4000; i <= 4000; ++i)
      {
        const double square = 1e-3 * i * std::abs(growth.exact_square);
        const double left   = fit(amplitudes, square).second;
        if (left < least)
          {
            least                  = left;
            growth.measured_square = square;
          }
      }
    const auto &[end, last] = amplitudes.back();
    const double first      = amplitudes.front().second;
    growth.final_amplitude  = last / first;
    growth.exact_amplitude  = course(growth.exact_square, end);
    growth.fit_error        = std::sqrt(least / amplitudes.size()) / first;
    growth.final_steepness  = k * last;
    return growth;
  }
} // namespace magmpm::verification
