#include <magmpm/base/constants.h>

#include <verification/capillarity/drop_runs.h>
#include <verification/capillarity/magnetic_drop_run.h>
#include <verification/capillarity/particle_file.h>
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
    /** Lower x, in 3D Lower y too, are mirrors; all else is open. */
    std::string
    face_lines(const int dim, const std::string &mirror)
    {
      std::string text;
      for (int d = 0; d < dim; ++d)
        {
          const std::string axis(1, "xyz"[d]);
          text += "set Lower " + axis + " = " + (d + 1 < dim ? mirror : "open") + "\nset Upper " +
                  axis + " = open\n";
        }
      return text;
    }

    std::string
    magnetic_lines(const MagneticDropRun &run, const Drop &drop)
    {
      const double field = std::sqrt(run.bond_number * drop.surface_tension /
                                     (constants::vacuum_permeability * drop.radius));
      return "subsection Magnets\nset List of magnets = coil\nsubsection coil\nset Field = " +
             std::string(run.drop.dim == 2 ? "0; " : "0; 0; ") + as_text(field) +
             "\nend\nend\nsubsection Magnetics\nset Magnetization law = linear\n"
             "set Newton tolerance = 1e-6\nsubsection Potential box\n" +
             face_lines(run.drop.dim, "shielded") + "end\nend\n";
    }

    /** Runs it; its output folder. @param drop  of magmpm's units. @param middle  of the box along the field [m]. */
    std::string
    run_magnetic_drop(const MagneticDropRun &run, const Drop &drop, double &middle)
    {
      const int dim          = run.drop.dim;
      const std::string name = "magnetic-drop-" + std::to_string(dim) + "D-" +
                               as_text(run.drop.susceptibility) + "-" + as_text(run.bond_number) +
                               "-" + as_text(run.start_aspect);
      const double dx = drop.radius / run.cells, speed = drop.capillary_speed();
      const double sound = run.sound * std::sqrt(static_cast<double>(run.cells)) * speed;
      const int per_edge = dim == 2 ? 4 : 2;
      ParticleGrid grid;
      grid.dim     = dim;
      grid.spacing = dx / per_edge;
      std::string box;
      for (int d = 0; d < dim; ++d)
        {
          const bool is_along = d == dim - 1;
          const double reach  = is_along ? 2. * (run.room * run.cells + 6.) : 1.2 * run.cells + 6.;
          grid.upper[d]       = 4. * std::ceil(0.25 * reach) * dx;
          box += (d > 0 ? ", " : "") + as_text(grid.upper[d]);
        }
      middle                 = 0.5 * grid.upper[dim - 1] + 0.2 * dx;
      const double b         = drop.radius * std::pow(run.start_aspect, -1. / dim),
                   a         = b * run.start_aspect;
      const std::string file = write_particles(name, grid, [&](const std::array<double, 3> &place) {
        const double across = dim == 2 ? place[0] : std::hypot(place[0], place[1]);
        return std::hypot(across / b, (place[dim - 1] - middle) / a) < 1.;
      });
      ParameterText scene;
      scene.dim       = dim;
      scene.end_time  = as_text(run.duration * drop.radius / speed);
      scene.gravity   = dim == 2 ? "0, 0" : "0, 0, 0";
      scene.box       = box;
      scene.cell_size = as_text(dx);
      scene.add_fluid("ferrofluid",
                      as_text(drop.density * sound * sound),
                      as_text(drop.density * drop.viscosity),
                      "set Surface tension = " + as_text(drop.surface_tension) +
                        "\nset Initial susceptibility = " + as_text(run.drop.susceptibility) +
                        "\n");
      scene.add_body("drop",
                     "ferrofluid",
                     as_text(drop.density),
                     "set Shape = points\nset File = " + file +
                       "\nset Particles per edge = " + std::to_string(per_edge) + "\n");
      scene.rest = "set Checkpoint every = never\nsubsection Walls\n" + face_lines(dim, "slip") +
                   "set Particles leaving the box = remove\n"
                   "end\n" +
                   magnetic_lines(run, drop) + "subsection Rest\nset Damping rate = " +
                   as_text(run.damping * speed / drop.radius) +
                   "\nend\nsubsection Output\nset Particle quantities = J\nset Fields = false\n"
                   "set Statistics every = 1000\nset Frame interval = " +
                   as_text(0.02 * run.duration * drop.radius / speed) + "\nend\n";
      return run_scene(name, scene.text());
    }
  } // namespace

  MagneticDropAspect
  magnetic_drop_aspect(const MagneticDropRun &run)
  {
    DropRun round;
    round.dim                 = run.drop.dim;
    round.laplace_number      = 120.;
    const Drop drop           = round.drop();
    const int axis            = run.drop.dim - 1;
    double middle             = 0.;
    const auto frames         = particle_frames(run_magnetic_drop(run, drop, middle));
    const std::size_t first   = frames.size() * 4 / 5;
    MagneticDropAspect result = {0., 0., 0., 0};
    double least = 1e300, largest = 0.;
    for (std::size_t i = first; i < frames.size(); ++i)
      {
        const double n = static_cast<double>(frames[i].size());
        double centre = 0., along = 0., across = 0.;
        for (const auto &place : frames[i].positions)
          centre += place[axis] / n;
        for (const auto &place : frames[i].positions)
          {
            along += std::pow(place[axis] - centre, 2);
            for (int d = 0; d < axis; ++d)
              across += place[d] * place[d] / axis;
            result.highest = std::max(result.highest, std::abs(place[axis] - centre) / drop.radius);
          }
        const double aspect = std::sqrt(along / across);
        result.measured += aspect / static_cast<double>(frames.size() - first);
        least   = std::min(least, aspect);
        largest = std::max(largest, aspect);
      }
    result.change = largest - least;
    result.n_lost = frames.front().size() - frames.back().size();
    return result;
  }
} // namespace magmpm::verification
