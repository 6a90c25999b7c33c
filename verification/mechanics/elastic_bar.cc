
#include <verification/mechanics/elastic_bar.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <stdexcept>

namespace magmpm::verification
{
  namespace
  {
    constexpr double wave_speed = 10.; // m/s: E = 1e5 Pa, rho = 1000 kg/m^3
    constexpr double length     = 1.;  // m

    // The end sags by g L^2/(2 c^2) = 5e-5 L: the law is linear for it.
    std::string
    scene(const int cells)
    {
      return R"(
set Dimension = 2
set End time  = 2.1
set Gravity   = 0.01, 0
subsection Box
  set Upper corner = 1.5, 0.75
  set Cell size    = )" +
             as_text(length / cells) + R"(
end
subsection Bodies
  set List of bodies = bar
  subsection bar
    set Material     = rubber
    set Lower corner = 0, 0.25
    set Upper corner = 1, 0.5
    set Density      = 1000
  end
end
subsection Materials
  set List of materials = rubber
  subsection rubber
    set Young's modulus = 1e5
    set Poisson ratio   = 0
  end
end
subsection Output
  set Frame interval = 3
  set Particles      = false
end
)";
    }

    /** Times at which the values pass the level upwards, between rows linearly. */
    std::vector<double>
    crossings(const std::vector<double> &times,
              const std::vector<double> &values,
              const double level)
    {
      std::vector<double> found;
      for (std::size_t i = 1; i < times.size(); ++i)
        if (values[i - 1] < level && values[i] >= level)
          found.push_back(times[i - 1] + (times[i] - times[i - 1]) * (level - values[i - 1]) /
                                           (values[i] - values[i - 1]));
      return found;
    }
  } // namespace

  double
  frequency_error(const int cells)
  {
    const std::string folder = run_scene("elastic-bar-" + std::to_string(cells), scene(cells));
    const Statistics statistics(folder);
    const std::vector<double> &times  = statistics["time [s]"];
    const std::vector<double> &places = statistics["centre of mass x [m]"];
    const auto [least, most]          = std::minmax_element(places.begin(), places.end());
    const auto passes                 = crossings(times, places, 0.5 * (*least + *most));
    if (passes.size() < 3)
      throw std::runtime_error("The bar did not swing.");
    const double frequency = (passes.size() - 1) / (passes.back() - passes.front());
    return frequency / (wave_speed / (4. * length)) - 1.;
  }
} // namespace magmpm::verification
