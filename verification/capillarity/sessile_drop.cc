#include <magmpm/base/constants.h>

#include <verification/capillarity/drop_runs.h>
#include <verification/capillarity/gauss_rule.h>
#include <verification/capillarity/particle_file.h>
#include <verification/capillarity/sessile_drop.h>
#include <verification/program/parameter_text.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace magmpm::verification
{
  namespace
  {
    constexpr double degree = constants::pi / 180.;

    /** Faces through the middle are mirrors, and all others but the floor are open. */
    std::string
    wall_lines(const SessileRun &run)
    {
      std::string text = "subsection Walls\n";
      for (int d = 0; d < run.dim; ++d)
        {
          const std::string axis(1, "xyz"[d]);
          text += "set Lower " + axis + " = slip\nset Upper " + axis + " = open\n";
        }
      text += "set Particles leaving the box = remove\n";
      if (run.slab == 0.)
        text += std::string("set Lower ") + "xyz"[run.dim - 1] +
                " contact angle = " + as_text(run.angle) + "\n";
      return text + "end\n";
    }

    /** The slab, as wide as the box. */
    std::string
    slab_lines(const SessileRun &run, const std::array<double, 3> &box, const double height)
    {
      if (run.slab == 0.)
        return "";
      std::string lower, upper;
      for (int d = 0; d < run.dim; ++d)
        {
          lower += (d > 0 ? ", " : "") + as_text(0.);
          upper += (d > 0 ? ", " : "") + as_text(d == run.dim - 1 ? height : box[d]);
        }
      return "subsection Rigid bodies\nset List of rigid bodies = slab\nsubsection slab\n"
             "set Shape = box\nset Lower corner = " +
             lower + "\nset Upper corner = " + upper +
             "\nset Motion = scripted\nset Contact = slip\nset Contact angle = " +
             as_text(run.angle) + "\nend\nend\n";
    }

    /** The ball of which it is half. */
    DropRun
    round_drop(const SessileRun &run)
    {
      DropRun round;
      round.dim            = run.dim;
      round.laplace_number = run.laplace_number;
      return round;
    }

    std::string
    run_sessile(const SessileRun &run)
    {
      const std::string name = "sessile-" + std::to_string(run.dim) + "D-" + as_text(run.angle) +
                               (run.slab > 0. ? "-slab" : "");
      const Drop drop = round_drop(run).drop();
      const double dx = drop.radius / run.cells, speed = drop.capillary_speed();
      const double sound = run.sound * std::sqrt(static_cast<double>(run.cells)) * speed;
      ParticleGrid grid;
      grid.dim     = run.dim;
      grid.spacing = dx / run.particles_per_edge;
      // The flattest, of 30 degrees, is 2.1 R wide and swings; the steepest is 1.9 R high.
      std::string box;
      for (int d = 0; d < run.dim; ++d)
        {
          const double reach = (d == run.dim - 1 ? 2. * run.cells + run.slab : 3. * run.cells) + 4.;
          grid.upper[d]      = 4. * std::ceil(0.25 * reach) * dx;
          box += (d > 0 ? ", " : "") + as_text(grid.upper[d]);
        }
      ParameterText scene;
      scene.dim       = run.dim;
      scene.end_time  = as_text(run.duration * drop.radius / speed);
      scene.gravity   = run.dim == 2 ? "0, 0" : "0, 0, 0";
      scene.box       = box;
      scene.cell_size = as_text(dx);
      scene.add_fluid("liquid",
                      as_text(drop.density * sound * sound),
                      as_text(drop.density * drop.viscosity),
                      "set Surface tension = " + as_text(drop.surface_tension) + "\n");
      const std::string file = write_particles(name, grid, [&](std::array<double, 3> place) {
        place[run.dim - 1] -= run.slab * dx;
        return place[run.dim - 1] > 0. && std::hypot(place[0], place[1], place[2]) < drop.radius;
      });
      scene.add_body("drop",
                     "liquid",
                     as_text(drop.density),
                     "set Shape = points\nset File = " + file + "\nset Particles per edge = " +
                       std::to_string(run.particles_per_edge) + "\n");
      scene.rest = "set Checkpoint every = never\n" + wall_lines(run) +
                   slab_lines(run, grid.upper, run.slab * dx) +
                   "subsection Output\nset Particle quantities = J\nset Fields = false\n"
                   "set Statistics every = 1000\nset Frame interval = " +
                   as_text(0.01 * run.duration * drop.radius / speed) + "\nend\n";
      return run_scene(name, scene.text());
    }
  } // namespace

  double
  cap_ratio(const int dim, const double angle)
  {
    // Slices of the unit circle or ball from its wall, at cos(angle), to 1; their width is the sine of the angle t to the top.
    const GaussRule rule = gauss_rule(30);
    double volume = 0., height = 0., square = 0.;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
      {
        const double t = angle * rule.points[i], width = std::sin(t);
        const double slice = rule.weights[i] * width *
                             (dim == 2 ? 2. * width : constants::pi * width * width);
        volume += slice;
        height += slice * (std::cos(t) - std::cos(angle));
        square += slice * width * width / (dim == 2 ? 3. : 4.);
      }
    return height / std::sqrt(volume * square);
  }

  double
  cap_angle(const int dim, const double ratio)
  {
    double below = 0.01, above = constants::pi - 0.01;
    for (int i = 0; i < 50; ++i)
      {
        const double middle                              = 0.5 * (below + above);
        (cap_ratio(dim, middle) < ratio ? below : above) = middle;
      }
    return 0.5 * (below + above);
  }

  SessileDrop
  sessile_drop(const SessileRun &run)
  {
    const auto frames       = particle_frames(run_sessile(run));
    const double dx         = round_drop(run).drop().radius / run.cells;
    const std::size_t first = frames.size() * 2 / 3;
    SessileDrop drop        = {0., 180., 0., frames.front().size() - frames.back().size()};
    for (std::size_t i = first; i < frames.size(); ++i)
      {
        const double n = static_cast<double>(frames[i].size());
        double height = 0., square = 0.;
        for (const auto &place : frames[i].positions)
          {
            height += (place[run.dim - 1] - run.slab * dx) / n;
            for (int d = 0; d + 1 < run.dim; ++d)
              square += place[d] * place[d] / (n * (run.dim - 1));
          }
        const double angle = cap_angle(run.dim, height / std::sqrt(square)) / degree;
        drop.angle += angle / static_cast<double>(frames.size() - first);
        drop.least   = std::min(drop.least, angle);
        drop.largest = std::max(drop.largest, angle);
      }
    return drop;
  }
} // namespace magmpm::verification
