#include <magmpm/base/constants.h>

#include <verification/capillarity/layer_runs.h>
#include <verification/capillarity/spike_equilibrium.h>
#include <verification/capillarity/surface_waves.h>
#include <verification/mechanics/damped_wave.h>
#include <verification/program/parameter_text.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi = constants::pi;

    std::string
    name_of(const std::string &what, const LayerRun &run)
    {
      return what + "-" + as_text(run.wave_number) + "-" + as_text(run.magnetization) + "-" +
             std::to_string(run.cells) + "-" + as_text(run.steepness);
    }

    Course
    course_of(const LayerRun &run, const std::vector<ParticleFrame> &frames, const double start)
    {
      Course course;
      for (const ParticleFrame &frame : frames)
        if (frame.time > start)
          course.emplace_back(frame.time - start, mode_amplitude(run, frame, run.k()));
      return course;
    }

    /**
     * Gravity leans towards the crest with the strength s until the end: uniform acceleration drives the first mode,
     * a'' = -omega^2 a + 4/pi tanh(k d) s, as x = width/2 - 4 width/pi^2 (cos k x + cos(3 k x)/9 + ..) does.
     */
    std::string
    push(const LayerRun &run, const double velocity, const double end)
    {
      const double strength = 0.25 * pi / std::tanh(run.k() * run.boxed_layer().depth) * velocity /
                              end;
      // A square of a sine, twice as strong in the middle.
      return "if(t < " + as_text(end) + ", " + as_text(-2. * strength) + "*sin(" +
             as_text(pi / end) + "*t)^2, 0)";
    }

    /** The part that is even or odd in time: cosh(s t) or cos(omega t), sinh(s t)/s or sin(omega t)/omega. */
    double
    even(const double square, const double time)
    {
      return square > 0. ? std::cosh(std::sqrt(square) * time)
                         : std::cos(std::sqrt(-square) * time);
    }

    double
    odd(const double square, const double time)
    {
      const double root = std::sqrt(std::abs(square));
      if (root * time < 1e-6)
        return time;
      return (square > 0. ? std::sinh(root * time) : std::sin(root * time)) / root;
    }

    /** Squares that are left by the best a even + b odd. */
    double
    left_by(const Course &course, const double square)
    {
      double ee = 0., eo = 0., oo = 0., ea = 0., oa = 0., aa = 0.;
      for (const auto &[time, amplitude] : course)
        {
          const double e = even(square, time), o = odd(square, time);
          ee += e * e;
          eo += e * o;
          oo += o * o;
          ea += e * amplitude;
          oa += o * amplitude;
          aa += amplitude * amplitude;
        }
      const double determinant = ee * oo - eo * eo;
      return aa - (oo * ea * ea - 2. * eo * ea * oa + ee * oa * oa) / determinant;
    }

    double
    sign_square(const std::complex<double> rate)
    {
      return std::abs(rate.imag()) > 0. ? -rate.imag() * rate.imag() : rate.real() * rate.real();
    }
  } // namespace

  LayerWave
  layer_wave(const LayerRun &run)
  {
    const LayerField state       = run.magnetization > 0. ? run.state() : LayerField{0., 0., 0.};
    const std::complex<double> s = wave_rate(run.boxed_layer(), state, run.k());
    const double omega = s.imag(), period = 2. * pi / omega;
    // For two periods, as the square of a sine: a_1 = 4/omega^2 of the strength at the end.
    const double strongest = 0.25 * omega * omega * run.steepness / run.k();
    const std::string lean = "if(t > " + as_text(2. * period) + ", 0, " + as_text(strongest) +
                             "*sin(" + as_text(omega) + "*t)*sin(" + as_text(0.25 * omega) +
                             "*t)^2)";
    const std::string folder = run_scene(name_of("layer-wave", run),
                                         layer_scene(run, lean, 6. * period, 120));
    const Course course      = course_of(run, particle_frames(folder), 2. * period);
    const DampedWave wave    = fit_damped_wave(course, omega, true);
    return {wave.frequency / omega - 1.,
            1. - std::exp(-wave.decay * period),
            1. - std::exp(s.real() * period),
            misfit(course, wave) / wave.amplitude(),
            wave.amplitude() * run.k()};
  }

  double
  LayerGrowth::error() const
  {
    return exact * rate_square <= 0. ? -1. : std::sqrt(rate_square / exact) - 1.;
  }

  LayerGrowth
  layer_growth(const LayerRun &run)
  {
    LayerGrowth growth;
    growth.exact      = sign_square(wave_rate(run.boxed_layer(), run.state(), run.k()));
    const double rate = std::sqrt(std::abs(growth.exact));
    // The push gives a velocity with which sinh(s t) reaches the steepness at s t = 2, and a swing reaches it at once.
    const double pushed = 0.3 / rate, aim = run.steepness / run.k();
    const double velocity = growth.exact > 0. ? rate * aim / std::sinh(1.9) : rate * aim;
    const double end      = run.duration > 0. ? run.duration : (growth.exact > 0. ? 2. : 6.) / rate;
    const auto frames     = particle_frames(run_scene(
      name_of("layer-growth", run), layer_scene(run, push(run, velocity, pushed), end, 80)));
    const Course course   = course_of(run, frames, pushed);
    double least          = 1e300;
    if (growth.exact < 0.)
      {
        const DampedWave wave = fit_damped_wave(course, rate, true);
        growth.rate_square    = -wave.frequency * wave.frequency;
        least = std::pow(misfit(course, wave), 2) * static_cast<double>(course.size());
      }
    for (int i = -3000; growth.exact > 0. && i <= 3000; ++i)
      {
        const double square = 1e-3 * (i + 0.5) * std::abs(growth.exact);
        const double left   = left_by(course, square);
        if (left < least)
          {
            least              = left;
            growth.rate_square = square;
          }
      }
    double largest = 0., early = 0., late = 0.;
    for (const auto &[time, amplitude] : course)
      {
        largest = std::max(largest, std::abs(amplitude));
        if (3. * time < end)
          early = std::max(early, std::abs(amplitude));
        if (3. * time > 2. * end)
          late = std::max(late, std::abs(amplitude));
      }
    growth.late_over_early = late / early;
    growth.misfit = std::sqrt(std::max(least, 0.) / static_cast<double>(course.size())) / largest;
    growth.steepness = largest * run.k();
    return growth;
  }

  LayerSpikes
  layer_spikes(const LayerRun &run)
  {
    const FerrofluidLayer boxed = run.boxed_layer();
    const SpikeShape shape      = spike_equilibrium(boxed, run.state(), run.k());
    LayerSpikes spikes          = {0., shape.modes[0], 0., shape.height(0.), 0., 0.};
    const double rate      = std::sqrt(std::abs(inviscid_rate_square(boxed, run.state(), run.k())));
    const double end       = run.duration > 0. ? run.duration : 0.3;
    const double aim       = run.steepness / run.k();
    const auto frames      = particle_frames(run_scene(
      name_of("layer-spikes", run), layer_scene(run, push(run, rate * aim, 0.3 / rate), end, 100)));
    const Course course    = course_of(run, frames, 0.);
    const std::size_t half = course.size() / 2, last = course.size() * 4 / 5;
    double lowest = 1e300, largest = 0.;
    for (std::size_t i = half; i < course.size(); ++i)
      {
        const double a = course[i].second;
        spikes.first_mode += a / static_cast<double>(course.size() - half);
        if (i >= last)
          {
            lowest  = std::min(lowest, a);
            largest = std::max(largest, a);
          }
      }
    spikes.change = (largest - lowest) / spikes.first_mode;
    for (const ParticleFrame &frame : frames)
      {
        double n_flying = 0.;
        for (const auto &place : frame.positions)
          {
            const double height = place[1] - boxed.depth;
            spikes.highest      = std::max(spikes.highest, height);
            n_flying += (height > spikes.crest + 1e-3);
          }
        spikes.n_flying = std::max(spikes.n_flying, n_flying);
      }
    return spikes;
  }
} // namespace magmpm::verification
