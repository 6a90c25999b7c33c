#include <verification/mechanics/floating_body.h>
#include <verification/program/parameter_text.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr double dx = 0.01; // m

    Pool
    pool_of(const FloatingBody &body)
    {
      return {body.dim, body.dim == 2 ? 32. * dx : 20. * dx, 12. * dx, 1000., 5e4, 9.81};
    }

    /** The same along all axes but the last. */
    std::string
    point(const int dim, const double across, const double height)
    {
      std::string text;
      for (int d = 0; d + 1 < dim; ++d)
        text += as_text(across) + ", ";
      return text + as_text(height);
    }

    /** The lines of the body's shape, just above the fluid. */
    std::string
    shape_of(const FloatingBody &body)
    {
      const double middle = 0.5 * pool_of(body).width, radius = 4. * dx;
      const double lowest = 12. * dx + (body.kind == FloaterKind::rigid ? 0.1 * dx : 0.);
      if (body.is_round)
        return "set Shape = sphere\nset Radius = " + as_text(radius) +
               "\nset Centre = " + point(body.dim, middle, lowest + radius) + "\n";
      return "set Lower corner = " + point(body.dim, middle - radius, lowest) +
             "\nset Upper corner = " + point(body.dim, middle + radius, lowest + 2. * radius) +
             "\n";
    }

    std::string
    scene(const FloatingBody &body)
    {
      const Pool pool = pool_of(body);
      ParameterText text;
      text.dim      = body.dim;
      text.end_time = body.dim == 2 ? "3" : "2";
      text.gravity  = point(body.dim, 0., -pool.gravity);
      text.box      = point(body.dim, pool.width, 32. * dx);
      text.add_fluid("oil", as_text(pool.bulk_modulus), "3")
        .add_box("pool", "oil", point(body.dim, 0., 0.), point(body.dim, pool.width, pool.depth));
      text.rest = walls(body.dim, "slip") +
                  "subsection Rest\nset Damping rate = 2\nend\nsubsection Output\n"
                  "set Particle quantities = body\nset Rigid bodies = false\n"
                  "set Frame interval = 0.05\nend\n";
      if (body.kind == FloaterKind::elastic)
        text.add_solid("rubber", "2e5")
          .add_body("block",
                    "rubber",
                    as_text(body.density),
                    shape_of(body) + "set Contact group = " + std::to_string(body.group) + "\n");
      else
        text.rest += "subsection Rigid bodies\nset List of rigid bodies = float\nsubsection float\n"
                     "set Contact = slip\nset Density = " +
                     as_text(body.density) + "\n" + shape_of(body) + "end\nend\n";
      return text.text();
    }

    /** The height of the centre of the elastic block in each frame; its particles are all alike. */
    std::vector<double>
    heights_of_block(const std::string &folder, const int dim)
    {
      std::vector<double> heights;
      for (const ParticleFrame &frame : particle_frames(folder))
        {
          const auto &bodies = frame.quantities.at("body [-]");
          double sum         = 0.;
          int n              = 0;
          for (std::size_t p = 0; p < frame.size(); ++p)
            if (bodies[p][0] == 1.)
              {
                sum += frame.positions[p][dim - 1];
                ++n;
              }
          heights.push_back(sum / n);
        }
      return heights;
    }
  } // namespace

  FloatingErrors
  floating_errors(const FloatingBody &body)
  {
    const std::string name = std::string("floating-") + std::to_string(body.dim) +
                             (body.kind == FloaterKind::elastic ? "-elastic" : "") +
                             (body.is_round ? "-round-" : "-square-") + as_text(body.density) +
                             (body.group == 0 ? "" : "-group" + std::to_string(body.group));
    const std::string folder = run_scene(name, scene(body));
    std::vector<double> heights;
    double turn = 0.;
    if (body.kind == FloaterKind::elastic)
      heights = heights_of_block(folder, body.dim);
    else
      {
        const Statistics statistics(folder);
        heights = statistics[std::string("float: position ") + "xyz"[body.dim - 1] + " [m]"];
        for (const char *axis : {"x", "y", "z"})
          if (body.dim == 3 || *axis == 'z')
            turn = std::max(
              turn, std::abs(statistics.last(std::string("float: rotation ") + axis + " [rad]")));
      }
    const auto [lowest, highest] = std::minmax_element(heights.begin() + heights.size() * 3 / 4,
                                                       heights.end());
    const Floater floater        = {body.is_round, 4. * dx, body.density, turn};
    return {(late_mean(heights) - floating_height(pool_of(body), floater)) / dx,
            (*highest - *lowest) / dx,
            turn};
  }
} // namespace magmpm::verification
