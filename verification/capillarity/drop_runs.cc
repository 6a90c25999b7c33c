#include <magmpm/base/constants.h>

#include <verification/capillarity/drop_runs.h>
#include <verification/capillarity/particle_file.h>
#include <verification/mechanics/damped_wave.h>
#include <verification/program/parameter_text.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi    = constants::pi;
    constexpr int n_frames = 80;

    /** What all of a run need to know. */
    struct Scales
    {
      Drop drop;
      double dx, speed, time; ///< U and T
      double bulk_modulus;
      double mass; ///< of the particles [kg]; in 2D per metre
    };

    int
    particles_per_edge(const DropRun &run)
    {
      return run.particles_per_edge > 0 ? run.particles_per_edge : run.dim == 2 ? 4 : 2;
    }

    Scales
    scales(const DropRun &run)
    {
      Scales s;
      s.drop             = run.drop();
      s.dx               = s.drop.radius / run.cells;
      s.speed            = s.drop.capillary_speed();
      s.time             = s.drop.radius / s.speed;
      const double sound = run.sound * std::sqrt(static_cast<double>(run.cells)) * s.speed;
      s.bulk_modulus     = s.drop.density * sound * sound;
      return s;
    }

    /** Cells from the centre to a face, a multiple of 2; along x there is also the way that it flies. */
    int
    half_box(const DropRun &run, const int axis)
    {
      const double reach = run.cells * (1. + 2. * run.amplitude) + 7.;
      const double way   = axis == 0 ? 0.5 * run.velocity * run.duration * run.cells : 0.;
      return 2 * static_cast<int>(std::ceil(0.5 * (reach + way)));
    }

    /** r/R of the drop at the start, its volume that of R up to eps^3. @param cosine  of the angle to the last axis. */
    double
    outline(const DropRun &run, const double cosine)
    {
      const double eps = run.amplitude;
      return run.dim == 2 ? 1. + eps * (2. * cosine * cosine - 1.) - 0.25 * eps * eps
                          : 1. + eps * (1.5 * cosine * cosine - 0.5) - 0.2 * eps * eps;
    }

    std::string
    name_of(const DropRun &run)
    {
      return "drop-" + std::to_string(run.dim) + "D-" + std::to_string(run.cells) + "-La" +
             as_text(run.laplace_number) + "-" + as_text(run.offset[0]) + "-" +
             as_text(run.amplitude) + "-" + as_text(run.velocity);
    }

    /** Runs it; its output folder. Mass and radius become those of the particles. */
    std::string
    run_drop(const DropRun &run, Scales &s)
    {
      const std::string name = name_of(run);
      ParticleGrid grid;
      grid.dim                     = run.dim;
      grid.spacing                 = s.dx / particles_per_edge(run);
      grid.seed                    = run.seed;
      std::array<double, 3> centre = {};
      std::string box;
      for (int d = 0; d < run.dim; ++d)
        {
          grid.upper[d]    = 2. * half_box(run, d) * s.dx;
          const double way = d == 0 ? 0.5 * run.velocity * run.duration * s.drop.radius : 0.;
          centre[d]        = 0.5 * grid.upper[d] + run.offset[d] * s.dx - way;
          box += (d > 0 ? ", " : "") + as_text(grid.upper[d]);
        }
      std::size_t n_particles = 0;
      const std::string file = write_particles(name, grid, [&](const std::array<double, 3> &place) {
        double square = 0.;
        for (int d = 0; d < run.dim; ++d)
          square += std::pow(place[d] - centre[d], 2);
        const double r     = std::sqrt(square);
        const bool is_drop = r < s.drop.radius *
                                   outline(run, (place[run.dim - 1] - centre[run.dim - 1]) / r);
        n_particles += is_drop;
        return is_drop;
      });
      const double volume    = static_cast<double>(n_particles) * std::pow(grid.spacing, run.dim);
      s.mass                 = s.drop.density * volume;

      ParameterText scene;
      scene.dim       = run.dim;
      scene.end_time  = as_text(run.duration * s.time);
      scene.gravity   = run.dim == 2 ? "0, 0" : "0, 0, 0";
      scene.box       = box;
      scene.cell_size = as_text(s.dx);
      scene.add_fluid("liquid",
                      as_text(s.bulk_modulus),
                      as_text(s.drop.density * s.drop.viscosity),
                      "set Surface tension = " + as_text(s.drop.surface_tension) + "\n");
      scene.add_body("drop",
                     "liquid",
                     as_text(s.drop.density),
                     "set Shape = points\nset File = " + file +
                       "\nset Particles per edge = " + std::to_string(particles_per_edge(run)) +
                       "\nset Velocity = " + as_text(run.velocity * s.speed) +
                       (run.dim == 2 ? ", 0" : ", 0, 0") + "\n");
      scene.rest = "set Checkpoint every = never\n" + walls(run.dim, "open") +
                   "subsection Output\nset Particle quantities = J\nset Fields = false\n"
                   "set Statistics every = 20\nset Frame interval = " +
                   as_text(run.duration * s.time / n_frames) + "\nend\n";
      const std::string folder = run_scene(name, scene.text());
      // Particles are counted, so that the drop that is watched has a radius of its own.
      s.drop.radius = run.dim == 2 ? std::sqrt(volume / pi) : std::cbrt(0.75 * volume / pi);
      return folder;
    }

    /** Second moments about the centre of mass along each axis [m^2]. */
    std::array<double, 3>
    moments(const ParticleFrame &frame, std::array<double, 3> &centre)
    {
      centre                       = {};
      std::array<double, 3> result = {};
      const double n               = static_cast<double>(frame.size());
      for (const auto &place : frame.positions)
        for (int d = 0; d < 3; ++d)
          centre[d] += place[d] / n;
      for (const auto &place : frame.positions)
        for (int d = 0; d < 3; ++d)
          result[d] += std::pow(place[d] - centre[d], 2) / n;
      return result;
    }

    /** Mean K (1 - J) of the particles within half the radius [Pa]. */
    double
    inner_pressure(const ParticleFrame &frame, const Scales &s)
    {
      std::array<double, 3> centre;
      moments(frame, centre);
      const auto &volume_ratios = frame.quantities.at("J [-]");
      double sum = 0., n = 0.;
      for (std::size_t p = 0; p < frame.size(); ++p)
        {
          double square = 0.;
          for (int d = 0; d < 3; ++d)
            square += std::pow(frame.positions[p][d] - centre[d], 2);
          if (square < 0.25 * s.drop.radius * s.drop.radius)
            {
              sum += s.bulk_modulus * (1. - volume_ratios[p][0]);
              n += 1.;
            }
        }
      return sum / n;
    }

    /** Of the columns of a vector, the largest distance from what it is at first. */
    double
    largest_change(const Statistics &statistics,
                   const std::string &quantity,
                   const std::string &unit)
    {
      double largest = 0.;
      for (const char axis : {'x', 'y', 'z'})
        {
          const std::string heading = quantity + " " + axis + " [" + unit + "]";
          if (std::find(statistics.headings.begin(), statistics.headings.end(), heading) ==
              statistics.headings.end())
            continue;
          for (const double now : statistics[heading])
            largest = std::max(largest, std::abs(now - statistics[heading].front()));
        }
      return largest;
    }

    std::string
    heading(const Statistics &statistics, const std::string &beginning)
    {
      for (const std::string &heading : statistics.headings)
        if (heading.compare(0, beginning.size(), beginning) == 0)
          return heading;
      return beginning;
    }

    /** The mean over the later half of the rows. */
    double
    later_mean(const std::vector<double> &values)
    {
      double sum              = 0.;
      const std::size_t first = values.size() / 2;
      for (std::size_t i = first; i < values.size(); ++i)
        sum += values[i];
      return sum / static_cast<double>(values.size() - first);
    }

    RestingDrop
    measure(const DropRun &run,
            const Scales &s,
            const std::string &folder,
            const std::vector<ParticleFrame> &frames)
    {
      const Statistics statistics(folder);
      const double flight = 0.5 * s.mass * std::pow(run.velocity * s.speed, 2);
      std::vector<double> rms, pressure, largest;
      for (const double energy : statistics[heading(statistics, "kinetic energy")])
        rms.push_back(std::sqrt(2. * std::max(energy - flight, 0.) / s.mass) / s.speed);
      for (const double v : statistics[heading(statistics, "max |v|")])
        largest.push_back(v / s.speed - run.velocity);
      for (std::size_t i = frames.size() / 2; i < frames.size(); i += 2)
        pressure.push_back(inner_pressure(frames[i], s) * s.drop.radius /
                           ((run.dim - 1) * s.drop.surface_tension));
      const bool is_flat         = run.dim == 2;
      const double sphere        = is_flat ? 2. * pi * s.drop.radius
                                           : 4. * pi * std::pow(s.drop.radius, 2);
      const std::string momentum = is_flat ? "kg/s" : "kg m/s",
                        angular  = is_flat ? "kg m/s" : "kg m^2/s";
      double mean                = 0.;
      for (const double p : pressure)
        mean += p / static_cast<double>(pressure.size());
      return {mean - 1.,
              later_mean(rms),
              later_mean(largest),
              largest_change(statistics, "momentum", momentum) / (s.mass * s.speed),
              largest_change(statistics, "angular momentum", angular) /
                (s.mass * s.speed * s.drop.radius),
              later_mean(statistics[heading(statistics, "surface energy")]) /
                  (s.drop.surface_tension * sphere) -
                1.};
    }
  } // namespace

  Drop
  DropRun::drop() const
  {
    Drop drop;
    drop.dim = dim;
    drop.viscosity =
      std::sqrt(drop.density * drop.surface_tension * 2. * drop.radius / laplace_number) /
      drop.density;
    return drop;
  }

  RestingDrop
  resting_drop(const DropRun &run)
  {
    Scales s                 = scales(run);
    const std::string folder = run_drop(run, s);
    return measure(run, s, folder, particle_frames(folder));
  }

  MovedDrop
  moved_drop(const DropRun &run)
  {
    Scales s                 = scales(run);
    const std::string folder = run_drop(run, s);
    const auto frames        = particle_frames(folder);
    std::array<double, 3> first, last;
    moments(frames.front(), first);
    const std::array<double, 3> shape = moments(frames.back(), last);
    const double way = run.velocity * s.speed * (frames.back().time - frames.front().time);
    return {measure(run, s, folder, frames),
            (last[0] - first[0]) / way - 1.,
            std::sqrt(shape[0] / shape[1]) - 1.};
  }

  OscillatingDrop
  oscillating_drop(const DropRun &run)
  {
    Scales s                 = scales(run);
    const std::string folder = run_drop(run, s);
    Course course;
    for (const ParticleFrame &frame : particle_frames(folder))
      {
        std::array<double, 3> centre;
        const std::array<double, 3> m = moments(frame, centre);
        const double sum              = m[0] + m[1] + m[2];
        course.emplace_back(frame.time,
                            run.dim == 2 ? (m[1] - m[0]) / sum : (2. * m[2] - m[0] - m[1]) / sum);
      }
    const std::complex<double> exact = drop_rate(s.drop, 2);
    const DampedWave wave            = fit_damped_wave(course, exact.imag(), true);
    const Statistics statistics(folder);
    return {wave.frequency / exact.imag() - 1.,
            wave.decay / -exact.real() - 1.,
            misfit(course, wave) / wave.amplitude(),
            largest_change(statistics, "momentum", run.dim == 2 ? "kg/s" : "kg m/s") /
              (s.mass * s.speed)};
  }
} // namespace magmpm::verification
