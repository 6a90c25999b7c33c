#include <verification/mechanics/hydrostatic_column.h>
#include <verification/program/parameter_text.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr double bulk_modulus = 1e6;  // Pa
    constexpr double density      = 1000; // kg/m^3
    constexpr double gravity      = 9.81; // m/s^2
    constexpr double depth        = 1.;   // m

    constexpr double slab = 0.25; // m

    // The wave that the start sends through the column decays by exp(-nu k^2 t), k = pi/(2 H): 2e-4. On a slab
    // the whole column bounces, too, which damping takes away.
    std::string
    scene(const int cells, const int dim, const ColumnFloor floor)
    {
      const double bottom = (floor == ColumnFloor::wall ? 0. : slab);
      const auto corner   = [&](const double width, const double height) {
        return as_text(width) +
               (dim == 3 ? ", " + as_text(width > 0. ? 4. * depth / cells : 0.) : "") + ", " +
               as_text(height);
      };
      ParameterText text;
      text.dim       = dim;
      text.end_time  = "3.5";
      text.gravity   = (dim == 3 ? "0, 0, " : "0, ") + as_text(-gravity);
      text.box       = corner(0.5, 1.5 + bottom * 2.);
      text.cell_size = as_text(depth / cells);
      text.add_fluid("oil", as_text(bulk_modulus), "1000")
        .add_box("fluid", "oil", corner(0., bottom), corner(0.5, bottom + depth));
      if (floor != ColumnFloor::wall)
        text.add_solid("rubber", "2e6")
          .add_box("slab",
                   "rubber",
                   corner(0., 0.),
                   corner(0.5, bottom),
                   floor == ColumnFloor::separate_slab ? "set Contact group = 1\n" : "")
          .rest = "subsection Rest\nset Damping rate = 3\nend\n";
      text.rest += walls(dim, "slip") +
                   "subsection Output\nset Particle quantities = J, body\n"
                   "set Frame interval = 3.5\nset Statistics every = 1000\nend\n";
      return text.text();
    }

    /** The particles of the fluid by height: what is above one is known without the deformation. */
    std::vector<std::size_t>
    fluid_by_height(const ParticleFrame &frame, const int dim)
    {
      const auto &bodies = frame.quantities.at("body [-]");
      std::vector<std::size_t> order;
      for (std::size_t p = 0; p < frame.size(); ++p)
        if (bodies[p][0] == 0.)
          order.push_back(p);
      std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
        return frame.positions[a][dim - 1] < frame.positions[b][dim - 1];
      });
      return order;
    }
  } // namespace

  HydrostaticErrors
  hydrostatic_errors(const int cells, const int dim, const ColumnFloor floor)
  {
    const std::string name = std::string("hydrostatic-") +
                             (floor == ColumnFloor::wall           ? "column-"
                              : floor == ColumnFloor::elastic_slab ? "slab-"
                                                                   : "separate-slab-") +
                             std::to_string(dim) + "-" + std::to_string(cells);
    const ParticleFrame frame = particle_frames(run_scene(name, scene(cells, dim, floor))).back();
    const auto &volume_ratios = frame.quantities.at("J [-]");
    const std::vector<std::size_t> order = fluid_by_height(frame, dim);
    const std::size_t per_layer          = order.size() / cells;
    HydrostaticErrors errors             = {};
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
