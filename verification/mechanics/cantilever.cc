
#include <verification/mechanics/cantilever.h>
#include <verification/mechanics/elastica.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double length         = 0.02;  // m
    constexpr double thickness      = 1e-3;  // m
    constexpr double density        = 1800.; // kg/m^3
    constexpr double youngs_modulus = 1e6;   // Pa
    constexpr double gravity        = 9.81;  // m/s^2
    constexpr double end_time       = 0.2;   // s: what is left of the swing is exp(-50/s t)

    /** Of the elastica's sag: what a clamp that holds the strip across leaves of it. */
    double
    factor_of_clamp(const Cantilever &cantilever)
    {
      const double nu = cantilever.poisson_ratio;
      if (cantilever.dim == 2)
        return nu == 0.49 ? 0.9946 : 1.;
      return nu == 0.45 ? 0.965 : nu == 0.49 ? 1. - 0.035 * std::pow(nu / 0.45, 2) : 1.;
    }

    Elastica
    reference(const Cantilever &cantilever)
    {
      const double nu      = cantilever.poisson_ratio;
      const double modulus = cantilever.dim == 2 ? youngs_modulus / (1. - nu * nu) : youngs_modulus;
      const double stiffness = modulus * std::pow(thickness, 3) / 12.; // per width
      const double load      = density * gravity * cantilever.weights * thickness;
      Elastica shape         = elastica(load * std::pow(length, 3) / stiffness, BeamLoad::weight);
      shape.mean_height *= factor_of_clamp(cantilever);
      return shape;
    }

    std::string
    scene(const Cantilever &cantilever)
    {
      const bool is_3d   = (cantilever.dim == 3);
      const double dx    = thickness / cantilever.cells;
      const double below = 4. * dx *
                           std::ceil((cantilever.weights > 2. ? 0.02 : 0.008) / (4. * dx));
      const double wall  = 4. * dx * std::ceil(length / (4. * dx) + 0.5);
      const double side  = 4. * dx * std::ceil(1.5e-3 / (4. * dx) + 0.5);
      const double start = -0.5 * thickness + cantilever.offset * dx;
      const auto point   = [is_3d](const double x, const double y, const double z) {
        return as_text(x) + (is_3d ? ", " + as_text(y) : "") + ", " + as_text(z);
      };
      return "set Dimension = " + std::to_string(cantilever.dim) +
             "\nset End time = " + as_text(end_time) +
             "\nset Gravity = " + point(0., 0., -cantilever.weights * gravity) +
             "\nsubsection Box\n  set Lower corner = " + point(0., -side, -below) +
             "\n  set Upper corner = " + point(wall, side, 4. * dx) +
             "\n  set Cell size = " + as_text(dx) +
             "\nend\nsubsection Bodies\n  set List of bodies = strip\n  subsection strip\n"
             "    set Material = elastomer\n    set Density = " +
             as_text(density) + "\n    set Lower corner = " + point(0., -1.5e-3, start) +
             "\n    set Upper corner = " + point(length, 1.5e-3, start + thickness) +
             "\n  end\nend\nsubsection Materials\n  set List of materials = elastomer\n"
             "  subsection elastomer\n    set Young's modulus = " +
             as_text(youngs_modulus) +
             "\n    set Poisson ratio = " + as_text(cantilever.poisson_ratio) +
             "\n    set Transfer = " + cantilever.transfer +
             "\n  end\nend\nsubsection Rest\n  set Damping rate = 100\nend\n"
             "subsection Output\n  set Frame interval = 1\n  set Particles = false\n"
             "  set Statistics every = 50\nend\n";
    }
  } // namespace

  CantileverErrors
  cantilever_errors(const Cantilever &cantilever)
  {
    const std::string height = (cantilever.dim == 3 ? "z" : "y");
    const Statistics statistics(run_scene("cantilever", scene(cantilever)));
    const std::vector<double> &times   = statistics["time [s]"];
    const std::vector<double> &heights = statistics["centre of mass " + height + " [m]"];
    const auto at = std::lower_bound(times.begin(), times.end(), 0.8 * end_time) - times.begin();
    const Elastica exact = reference(cantilever);
    const double sag     = (heights.front() - heights.back()) / length;
    return {sag / exact.mean_height - 1.,
            statistics.last("centre of mass x [m]") / length / exact.mean_reach - 1.,
            (heights[at] - heights.back()) / length / exact.mean_height};
  }
} // namespace magmpm::verification
