#include <verification/mechanics/channel_flow.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    // H = 1 m, rho = 1 kg/m^3, nu = 1 m^2/s, largest velocity 1 m/s: the Reynolds number is 1, the
    // Mach number 0.02. The moving wall is the lowest part of a cylinder of 10 km radius, which
    // bends away by half a millimetre over half of the layer.
    std::string
    scene(const ChannelFlow flow, const int cells)
    {
      const bool is_couette = (flow == ChannelFlow::couette);
      return R"(
set Dimension = 2
set End time  = 1
set Gravity   = )" +
             std::string(is_couette ? "0, 0" : "8, 0") + R"(
subsection Box
  set Upper corner = 9, )" +
             std::string(is_couette ? "2" : "1") + R"(
  set Cell size    = )" +
             as_text(1. / cells) + R"(
end
subsection Bodies
  set List of bodies = layer
  subsection layer
    set Material     = oil
    set Lower corner = 1, 0
    set Upper corner = 7, 0.998
    set Density      = 1
  end
end
subsection Materials
  set List of materials = oil
  subsection oil
    set Mechanical law = viscoelastic fluid
    set Bulk modulus   = 2500
    set Viscosity      = 1
  end
end
)" +
             (is_couette ? R"(
subsection Magnets
  set List of magnets = lid
  subsection lid
    set Type          = magnetized sphere
    set Position      = 4 + t; 10000.999
    set Radius        = 10000
    set Magnetization = 0; 0
    set Contact       = stick
  end
end
)"
                         : "") +
             R"(
subsection Output
  set Frame interval   = 1
  set Statistics every = 1000
end
)";
    }

    double
    exact_velocity(const ChannelFlow flow, const double y)
    {
      return flow == ChannelFlow::couette ? y : 4. * y * (1. - y);
    }
  } // namespace

  double
  velocity_error(const ChannelFlow flow, const int cells)
  {
    const std::string name = (flow == ChannelFlow::couette ? "couette-" : "poiseuille-");
    const ParticleFrame frame =
      particle_frames(run_scene(name + std::to_string(cells), scene(flow, cells))).back();
    const auto &velocities = frame.quantities.at("velocity [m/s]");

    double middle = 0.;
    for (const auto &position : frame.positions)
      middle += position[0] / frame.size();
    std::vector<double> number(cells, 0.), velocity(cells, 0.), exact(cells, 0.);
    for (std::size_t p = 0; p < frame.size(); ++p)
      if (std::abs(frame.positions[p][0] - middle) < 0.5)
        {
          const double y  = frame.positions[p][1];
          const int layer = std::clamp(static_cast<int>(std::floor(y * cells)), 0, cells - 1);
          number[layer] += 1.;
          velocity[layer] += velocities[p][0];
          exact[layer] += exact_velocity(flow, y);
        }
    double largest = 0.;
    for (int layer = 0; layer < cells; ++layer)
      largest = std::max(largest, std::abs(velocity[layer] - exact[layer]) / number[layer]);
    return largest;
  }
} // namespace magmpm::verification
