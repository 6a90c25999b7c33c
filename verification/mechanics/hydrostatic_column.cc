#include <verification/mechanics/hydrostatic_column.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double bulk_modulus = 1e6;  // Pa
    constexpr double density      = 1000; // kg/m^3
    constexpr double gravity      = 9.81; // m/s^2
    constexpr double depth        = 1.;   // m

    // The wave that the start sends through the column decays by exp(-nu k^2 t), k = pi/(2 H): 2e-4.
    std::string
    scene(const int cells)
    {
      return R"(
set Dimension = 2
set End time  = 3.5
set Gravity   = 0, -9.81
subsection Box
  set Upper corner = 0.5, 1.5
  set Cell size    = )" +
             as_text(depth / cells) + R"(
end
subsection Bodies
  set List of bodies = fluid
  subsection fluid
    set Material     = oil
    set Lower corner = 0, 0
    set Upper corner = 0.5, 1
    set Density      = 1000
  end
end
subsection Materials
  set List of materials = oil
  subsection oil
    set Mechanical law = viscoelastic fluid
    set Bulk modulus   = 1e6
    set Viscosity      = 1000
  end
end
subsection Walls
  set Lower x = slip
  set Upper x = slip
  set Lower y = slip
end
subsection Output
  set Frame interval  = 3.5
  set Statistics every = 1000
end
)";
    }
  } // namespace

  HydrostaticErrors
  hydrostatic_errors(const int cells)
  {
    const ParticleFrame frame =
      particle_frames(run_scene("hydrostatic-column-" + std::to_string(cells), scene(cells)))
        .back();
    const auto &volume_ratios = frame.quantities.at("J [-]");

    // By height of the particles: what is above one is known without the deformation.
    std::vector<std::size_t> order(frame.size());
    for (std::size_t p = 0; p < order.size(); ++p)
      order[p] = p;
    std::sort(order.begin(), order.end(), [&frame](const std::size_t a, const std::size_t b) {
      return frame.positions[a][1] < frame.positions[b][1];
    });
    const std::size_t per_layer = frame.size() / cells;
    HydrostaticErrors errors    = {};
    for (int layer = 0; layer < cells; ++layer)
      {
        double pressure = 0.;
        for (std::size_t i = 0; i < per_layer; ++i)
          pressure += bulk_modulus * (1. - volume_ratios[order[layer * per_layer + i]][0]) /
                      per_layer;
        const double above = 1. - (layer + 0.5) / cells;
        const double error = pressure / (density * gravity * depth) - above;
        if (layer == 0)
          errors.floor_cell = error;
        else
          errors.inside = std::max(errors.inside, std::abs(error));
      }
    return errors;
  }
} // namespace magmpm::verification
