#include <verification/mechanics/dam_break.h>
#include <verification/mechanics/inviscid_collapse.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace magmpm::verification
{
  namespace
  {
    constexpr double width   = 0.05715; // m
    constexpr double gravity = 9.81;    // m/s^2
    const double time_unit   = std::sqrt(width / (2. * gravity));

    /** T and Z of the experiment. */
    const std::vector<std::pair<double, double>> experiment = {{0.832, 1.217},
                                                               {1.219, 1.474},
                                                               {1.997, 2.292},
                                                               {2.547, 2.995},
                                                               {3.345, 4.134},
                                                               {4.034, 4.944}};

    // Sound at ten times the largest speed, about 2 sqrt(2 g a); the viscosity is that of water.
    std::string
    scene(const int cells)
    {
      return R"(
set Dimension = 2
set End time  = )" +
             as_text(4.1 * time_unit) + R"(
set Gravity   = 0, -9.81
subsection Box
  set Upper corner = )" +
             as_text(8. * width) + ", " + as_text(3. * width) + R"(
  set Cell size    = )" +
             as_text(width / cells) + R"(
end
subsection Bodies
  set List of bodies = column
  subsection column
    set Material     = water
    set Lower corner = 0, 0
    set Upper corner = )" +
             as_text(width) + ", " + as_text(2. * width) + R"(
    set Density      = 1000
  end
end
subsection Materials
  set List of materials = water
  subsection water
    set Mechanical law = viscoelastic fluid
    set Bulk modulus   = 4e5
    set Viscosity      = 1e-3
  end
end
subsection Walls
  set Lower x = separate
  set Upper x = separate
  set Lower y = separate
  set Upper y = separate
end
subsection Output
  set Frame interval   = )" +
             as_text(0.1 * time_unit) + R"(
  set Statistics every = 1000
end
)";
    }

    /** Where the front and the foremost particle are, over a. */
    std::pair<double, double>
    reach(const ParticleFrame &frame)
    {
      std::vector<double> places;
      for (const auto &position : frame.positions)
        places.push_back(position[0] / width);
      std::sort(places.begin(), places.end());
      return {places[static_cast<std::size_t>(0.995 * places.size())], places.back()};
    }
  } // namespace

  std::vector<DamFront>
  dam_fronts(const int cells)
  {
    const auto frames =
      particle_frames(run_scene("dam-break-" + std::to_string(cells), scene(cells)));
    std::vector<double> times;
    for (const auto &[time, place] : experiment)
      times.push_back(time);
    const std::vector<InviscidFront> inviscid = inviscid_fronts(times, 60);
    std::vector<DamFront> fronts;
    for (const auto &[time, place] : experiment)
      {
        const auto after =
          std::find_if(frames.begin(), frames.end(), [t = time](const auto &frame) {
            return frame.time >= t * time_unit;
          });
        if (after == frames.begin() || after == frames.end())
          throw std::runtime_error(
            "The run of the dam break has no frame about T = " + as_text(time) + ".");
        const auto before = after - 1;
        const double part = (time * time_unit - before->time) / (after->time - before->time);
        const auto [front_before, foremost_before] = reach(*before);
        const auto [front_after, foremost_after]   = reach(*after);
        fronts.push_back({time,
                          place,
                          inviscid[fronts.size()].front,
                          (1. - part) * front_before + part * front_after,
                          (1. - part) * foremost_before + part * foremost_after});
      }
    return fronts;
  }

  double
  inviscid_front_error(const std::vector<DamFront> &fronts)
  {
    double largest = 0.;
    for (const DamFront &front : fronts)
      largest = std::max(largest, std::abs(front.simulated / front.inviscid - 1.));
    return largest;
  }

  double
  dam_front_error(const std::vector<DamFront> &fronts)
  {
    double largest = 0.;
    for (const DamFront &front : fronts)
      if (front.time < 3.5)
        largest = std::max(largest, std::abs(front.simulated / front.measured - 1.));
    return largest;
  }
} // namespace magmpm::verification
