#include <magmpm/base/constants.h>

#include <verification/mechanics/surface_growth.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <fstream>
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

    /** Between particles, which are on a regular grid [m]. */
    double
    distance_of(const SurfaceWave &wave)
    {
      return depth / wave.cells_per_half_wave / wave.particles_per_edge;
    }

    /** A file with the particles of the layer, all of the same area: the surface has steps that P2G smooths. */
    std::string
    write_particles(const std::string &name, const SurfaceWave &wave)
    {
      const double distance  = distance_of(wave);
      const double amplitude = wave.steepness / k;
      std::ofstream file(name + ".csv");
      file.precision(15);
      const int n = static_cast<int>(std::lround(length / distance));
      for (int j = 0; (j + 0.5) * distance < depth + amplitude; ++j)
        for (int i = 0; i < n; ++i)
          {
            const double x = (i + 0.5) * distance, y = (j + 0.5) * distance;
            if (y - depth < amplitude * std::cos(k * x))
              file << x << ", " << y << '\n';
          }
      return name + ".csv";
    }

    std::string
    bodies(const std::string &name, const SurfaceWave &wave)
    {
      return "subsection Bodies\nset List of bodies = layer\nsubsection layer\n"
             "set Material = ferrofluid\nset Shape = points\nset File = " +
             write_particles(name, wave) + "\nset Density = " + as_text(density) +
             "\nset Particles per edge = " + std::to_string(wave.particles_per_edge) +
             "\nend\nend\n";
    }

    std::string
    scene(const std::string &name, const SurfaceWave &wave)
    {
      const double dx    = depth / wave.cells_per_half_wave;
      const double end   = wave.duration / std::sqrt(std::abs(exact_square(wave)));
      const double sound = wave.sound_ratio * std::sqrt(gravity / k);
      return "set Dimension = 2\nset End time = " + as_text(end) + "\nset Gravity = 0, " +
             as_text(-gravity) + "\nset Checkpoint every = never\n" +
             "subsection Box\nset Upper corner = " + as_text(length) + ", " + as_text(2. * depth) +
             "\nset Cell size = " + as_text(dx) + "\nend\n" + bodies(name, wave) +
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
      const double volume = std::pow(distance_of(wave), 2);
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
    for (const ParticleFrame &frame : particle_frames(run_scene(name, scene(name, wave))))
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
