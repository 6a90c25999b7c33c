
#include <verification/mechanics/spinning_block.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    std::string
    scene(const int cells)
    {
      return R"(
set Dimension = 3
set End time  = 1
set Gravity   = 0, 0, 0
subsection Box
  set Upper corner = 0.32, 0.32, 0.32
  set Cell size    = )" +
             as_text(0.08 / cells) + R"(
end
subsection Bodies
  set List of bodies = block
  subsection block
    set Material         = rubber
    set Lower corner     = 0.12, 0.12, 0.12
    set Upper corner     = 0.20, 0.20, 0.20
    set Density          = 1000
    set Angular velocity = 10, 20, 30
  end
end
subsection Materials
  set List of materials = rubber
  subsection rubber
    set Young's modulus = 1e5
    set Poisson ratio   = 0.3
    set Transfer        = APIC
  end
end
subsection Output
  set Frame interval = 1
  set Particles      = false
end
)";
    }
  } // namespace

  double
  angular_momentum_error(const int cells)
  {
    const Statistics statistics(run_scene("spinning-block-" + std::to_string(cells), scene(cells)));
    double square = 0., change = 0.;
    for (const char axis : {'x', 'y', 'z'})
      {
        const auto &column = statistics[std::string("angular momentum ") + axis + " [kg m^2/s]"];
        square += column.front() * column.front();
        for (const double value : column)
          change = std::max(change, std::abs(value - column.front()));
      }
    return change / std::sqrt(square);
  }
} // namespace magmpm::verification
