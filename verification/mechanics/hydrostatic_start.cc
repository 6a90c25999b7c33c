#include <verification/mechanics/hydrostatic_start.h>
#include <verification/program/parameter_text.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace magmpm::verification
{
  namespace
  {
    constexpr double density = 1000.; // kg/m^3
    constexpr double gravity = 9.81;  // m/s^2
    constexpr double depth   = 1.;    // m

    double
    bulk_modulus(const HydrostaticPool &pool)
    {
      return density * gravity * depth / pool.compression;
    }

    double
    speed_of_sound(const HydrostaticPool &pool)
    {
      return std::sqrt(bulk_modulus(pool) / density);
    }

    std::string
    scene(const HydrostaticPool &pool, const int n_steps)
    {
      const double spacing = depth / pool.cells;
      const double step    = 0.3 * spacing / speed_of_sound(pool); // about that of the program
      const auto corner    = [&](const double width, const double height) {
        return as_text(width) +
               (pool.dim == 3 ? ", " + as_text(width > 0. ? 4. * spacing : 0.) : "") + ", " +
               as_text(height);
      };
      const std::string hydrostatic = "set Initial state = hydrostatic\n";
      ParameterText text;
      text.dim       = pool.dim;
      text.end_time  = as_text(n_steps * step);
      text.gravity   = (pool.dim == 3 ? "0, 0, " : "0, ") + as_text(-gravity);
      text.box       = corner(0.5, 1.5 * depth);
      text.cell_size = as_text(spacing);
      text.add_fluid("water", as_text(bulk_modulus(pool)), "0.001");
      const double surface = pool.is_under_oil ? 0.5 * depth : depth;
      text.add_box("water", "water", corner(0., 0.), corner(0.5, surface), hydrostatic);
      if (pool.is_under_oil)
        text.add_fluid("oil", as_text(0.5 * bulk_modulus(pool)), "0.001")
          .add_body("oil",
                    "oil",
                    as_text(0.8 * density),
                    hydrostatic + "set Lower corner = " + corner(0., surface) +
                      "\nset Upper corner = " + corner(0.5, depth) + "\n");
      text.rest =
        walls(pool.dim, pool.walls) + "subsection Time step\nset Time step = " + as_text(step) +
        "\nend\nsubsection Output\nset Particles = false\nset Frame interval = " + text.end_time +
        "\nend\n";
      return text.text();
    }
  } // namespace

  double
  hydrostatic_unrest(const HydrostaticPool &pool, const int n_steps)
  {
    const std::string name = "hydrostatic-start-" + std::to_string(pool.dim) + "-" +
                             std::to_string(pool.cells) + "-" + as_text(pool.compression) + "-" +
                             pool.walls + (pool.is_under_oil ? "-oil" : "");
    const Statistics statistics(run_scene(name, scene(pool, n_steps)));
    const std::string per_depth = pool.dim == 2 ? "/m" : "";
    const auto &energy          = statistics["kinetic energy [J" + per_depth + "]"];
    const double width          = pool.dim == 2 ? 0.5 : 0.5 * 4. * depth / pool.cells;
    const double mass = density * width * depth * (pool.is_under_oil ? 0.9 : 1.); // at least
    return std::sqrt(2. * *std::max_element(energy.begin(), energy.end()) / mass) /
           speed_of_sound(pool);
  }
} // namespace magmpm::verification
