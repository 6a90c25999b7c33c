#include <magmpm/base/constants.h>

#include <verification/mechanics/archimedes.h>
#include <verification/mechanics/damped_wave.h>
#include <verification/mechanics/standing_wave.h>
#include <verification/program/parameter_text.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    using constants::pi;

    constexpr double density = 1000.; // kg/m^3
    constexpr double settled = 3.; // s: until then damping takes what the start has set in motion
    constexpr double periods = 6.; // of the fit

    /** Of what is left at the surface by Y with Y' = 0 at the floor: g Y' - omega^2 Y, both times the same. */
    double
    mismatch(const WaveTank &tank, const double frequency)
    {
      const double k       = pi / tank.width;
      const double lean    = 0.5 * tank.gravity / (tank.sound * tank.sound);
      const double squares = lean * lean + k * k - std::pow(frequency / tank.sound, 2);
      const double q       = std::sqrt(squares);
      // Y = exp(lean y) (cosh(q y) - lean/q sinh(q y)).
      const double y     = tank.depth;
      const double value = std::cosh(q * y) - lean / q * std::sinh(q * y);
      const double slope = (q - lean * lean / q) * std::sinh(q * y);
      return tank.gravity * slope - frequency * frequency * value;
    }

    /**
     * Gravity that stands until the fluid has settled, then leans to either side with the frequency, for two
     * periods and as a square of a sine, so far that it raises a wave of the amplitude.
     */
    std::string
    leaning_gravity(const WaveTank &tank, const double frequency, const double amplitude)
    {
      const double strongest = 0.25 * pi * tank.gravity * amplitude / tank.width;
      const std::string w    = as_text(frequency);
      const std::string t    = "(t - " + as_text(settled) + ")";
      const std::string end  = as_text(settled + 4. * pi / frequency);
      return "if(t < " + as_text(settled) + ", 0, if(t > " + end + ", 0, " + as_text(strongest) +
             "*sin(" + w + "*" + t + ")*sin(0.25*" + w + "*" + t + ")^2)); " +
             as_text(-tank.gravity);
    }

    ParameterText
    scene(const WaveTank &tank,
          const int cells,
          const std::string &gravity,
          const double frame_interval)
    {
      ParameterText text;
      text.end_time  = as_text(settled);
      text.gravity   = gravity;
      text.box       = as_text(tank.width) + ", " + as_text(tank.width);
      text.cell_size = as_text(tank.width / cells);
      text.add_fluid("water", as_text(density * tank.sound * tank.sound), "1e-3");
      text.add_box("water", "water", "0, 0", as_text(tank.width) + ", " + as_text(tank.depth));
      text.rest = walls(2, "slip") + R"(subsection Rest
  set Damping rate = 5
end
subsection Output
  set Particle quantities = J
  set Statistics every    = 1000
  set Frame interval      = )" +
                  as_text(frame_interval) + "\nend\n";
      return text;
    }

    double
    amplitude_of(const WaveTank &tank, const ParticleFrame &frame)
    {
      double sum = 0.;
      for (const auto &position : frame.positions)
        sum += std::cos(pi / tank.width * position[0]);
      return 2. * tank.depth * sum / static_cast<double>(frame.size());
    }
  } // namespace

  double
  standing_wave_frequency(const WaveTank &tank, const double amplitude)
  {
    const double k  = pi / tank.width;
    const double w0 = std::sqrt(std::tanh(k * tank.depth));
    double below = 0.5 * w0 * std::sqrt(tank.gravity * k), above = 4. * below;
    for (int i = 0; i < 60; ++i)
      {
        const double middle                           = 0.5 * (below + above);
        (mismatch(tank, middle) > 0. ? below : above) = middle;
      }
    const double w2 =
      (9. * std::pow(w0, -7) - 12. * std::pow(w0, -3) - 3. * w0 - 2. * std::pow(w0, 5)) / 32.;
    return 0.5 * (below + above) * (1. + 0.5 * std::pow(k * amplitude, 2) * w2 / w0);
  }

  StandingWave
  standing_wave(const int cells)
  {
    WaveTank tank;
    const double height = 2. * tank.width / cells;
    const double period = 2. * pi / standing_wave_frequency(tank);
    const double start = settled + 2. * period, interval = period / 20.;
    const std::string name = "standing-wave-" + std::to_string(cells);
    const std::string text =
      scene(tank, cells, leaning_gravity(tank, 2. * pi / period, height), interval).text();
    const std::string folder = run_scene(name, text);
    const Outcome resumed    = run_magmpm("--resume " + name +
                                       ".prm --set \"Rest/Damping rate=0\" --set \"End time=" +
                                       as_text(start + periods * period) + "\"");
    if (resumed.exit_code != 0)
      throw std::runtime_error("The standing wave failed: " + resumed.errors);

    Course course;
    for (const ParticleFrame &frame : particle_frames(folder))
      if (frame.time > start - 0.5 * interval)
        course.emplace_back(frame.time - start, amplitude_of(tank, frame));
    const DampedWave wave = fit_damped_wave(course, 2. * pi / period);
    const double first    = wave.amplitude();
    WaveTank compressed   = tank;
    compressed.depth =
      Pool{2, tank.width, tank.depth, density, density * std::pow(tank.sound, 2), tank.gravity}
        .level();
    // Of the wave that is watched: half of its decay has happened by the middle of the time.
    const double mean = first * std::exp(-0.5 * wave.decay * periods * period);
    return {wave.frequency / standing_wave_frequency(compressed, mean) - 1.,
            1. - std::exp(-2. * pi * wave.decay / wave.frequency),
            misfit(course, wave) / first,
            first};
  }
} // namespace magmpm::verification
