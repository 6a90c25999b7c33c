#include <magmpm/base/constants.h>

#include <verification/mechanics/fluid_motion.h>
#include <verification/program/parameter_text.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr const char *no_frames = "subsection Output\nset Particles = false\n"
                                      "set Rigid bodies = false\nset Frame interval = 1\nend\n";

    /** A point with these coordinates along x, y, z as far as there are any. */
    std::string
    point(const int dim, const double *coordinates)
    {
      std::string text;
      for (int d = 0; d < dim; ++d)
        text += (d > 0 ? ", " : "") + as_text(coordinates[d]);
      return text;
    }

    /** A block of water, four or six cells wide, that flies from near the middle into a direction of the lattice. */
    void
    add_jet(const int dim, const int *direction, ParameterText &scene)
    {
      const double edge = dim == 2 ? 0.32 : 0.16, half_width = dim == 2 ? 0.03 : 0.015;
      const double speed = dim == 2 ? 6. : 4.; // m/s, of 10 m/s
      double size        = 0.;
      for (int d = 0; d < dim; ++d)
        size += std::abs(direction[d]);
      double lower[3], upper[3], velocity[3];
      for (int d = 0; d < dim; ++d)
        {
          const double middle = 0.5 * edge + direction[d] * (0.5 * edge - half_width - 0.02);
          lower[d]            = middle - half_width;
          upper[d]            = middle + half_width;
          velocity[d]         = speed * direction[d] / std::sqrt(size);
        }
      scene.add_box("jet" + std::to_string(scene.bodies.size()),
                    "water",
                    point(dim, lower),
                    point(dim, upper),
                    "set Velocity = " + point(dim, velocity) + "\n");
    }

    /** To the faces of the box, and into its corners; in 3D into two of them. */
    ParameterText
    jets(const int dim)
    {
      ParameterText scene;
      scene.dim      = dim;
      scene.end_time = dim == 2 ? "0.04" : "0.02";
      scene.gravity  = dim == 2 ? "0, 0" : "0, 0, 0";
      if (dim == 3)
        scene.box = "0.16, 0.16, 0.16";
      scene.add_fluid("water", "1e5", "0.01");
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = (dim == 3 ? -1 : 0); z <= (dim == 3 ? 1 : 0); ++z)
            {
              const int direction[3] = {x, y, z};
              const int n_axes       = std::abs(x) + std::abs(y) + std::abs(z);
              const bool is_corner   = dim == 2 ? n_axes == 2 : n_axes == 3 && x == y && y == z;
              if (n_axes == 1 || is_corner)
                add_jet(dim, direction, scene);
            }
      return scene;
    }
  } // namespace

  double
  held_in_slosh()
  {
    ParameterText scene;
    scene.end_time = "1";
    scene.gravity  = "3, -9.81";
    scene.add_fluid("water", "3.2e4", "0.001").add_box("water", "water", "0, 0", "0.32, 0.16");
    scene.rest = walls(2, "slip") + no_frames;
    return Statistics(run_scene("slosh", scene.text())).last("held particles");
  }

  double
  held_jets(const int dim)
  {
    double held = 0.;
    for (const std::string condition : {"stick", "slip", "separate"})
      {
        ParameterText scene = jets(dim);
        scene.rest          = walls(dim, condition) + no_frames;
        held += Statistics(run_scene("jets-" + std::to_string(dim) + "-" + condition, scene.text()))
                  .last("held particles");
      }
    return held;
  }

  MergingDrops
  merging_drops()
  {
    constexpr double dx = 1. / 64., gravity = 9.81, height = 1.275, meeting_speed = 0.4; // m, s
    ParameterText scene;
    scene.end_time  = "0.4";
    scene.gravity   = "0, " + as_text(-gravity);
    scene.box       = "1, 2";
    scene.cell_size = as_text(dx);
    scene.add_fluid("water", "1e5", "1e-3");
    const std::string disc = "set Shape = sphere\nset Radius = 0.078125\nset Centre = ";
    scene.add_body(
      "left", "water", "1000", disc + "0.275, " + as_text(height) + "\nset Velocity = 0.5, 0\n");
    scene.add_body(
      "right", "water", "1000", disc + "0.45, " + as_text(height) + "\nset Velocity = -0.3, 0\n");
    scene.rest = no_frames;
    const Statistics statistics(run_scene("drops", scene.text()));

    const double mass    = 2. * 1000. * constants::pi * 0.078125 * 0.078125;
    const auto &momentum = statistics["momentum x [kg/s]"];
    MergingDrops drops   = {};
    for (const double now : momentum)
      drops.momentum = std::max(drops.momentum, std::abs(now / momentum.front() - 1.));
    drops.path = (statistics.last("centre of mass y [m]") - height +
                  0.5 * gravity * std::pow(statistics.last("time [s]"), 2)) /
                 dx;
    double lowest = mechanical_energy(statistics).front();
    for (const double energy : mechanical_energy(statistics))
      {
        drops.energy_rise = std::max(drops.energy_rise, energy - lowest);
        lowest            = std::min(lowest, energy);
      }
    drops.energy_rise /= 0.5 * mass * meeting_speed * meeting_speed;
    return drops;
  }

  double
  momentum_change_of_stirred_pool()
  {
    constexpr double speed = 0.8, mass = 0.03 * 0.06 * 2000.; // m/s, kg/m
    ParameterText scene;
    scene.end_time = "0.2";
    scene.gravity  = "0, -9.81";
    scene.box      = "1.28, 0.32";
    scene.add_fluid("water", "2e4", "0.01")
      .add_solid("rubber", "1e5")
      .add_box("left", "water", "0.4, 0", "0.6, 0.06")
      .add_box("right", "water", "0.66, 0", "0.88, 0.06")
      .add_box("above", "water", "0.6, 0.03", "0.66, 0.06")
      .add_box("block", "rubber", "0.6, 0", "0.66, 0.03");
    scene.rest = walls(2, "slip") + no_frames +
                 "subsection Rigid bodies\nset List of rigid bodies = paddle\nsubsection paddle\n"
                 "set Lower corner = 0.5, 0.0605\nset Upper corner = 0.53, 0.1205\n"
                 "set Density = 2000\nset Velocity = " +
                 as_text(speed) + ", -0.4\nend\nend\n";
    const Statistics statistics(run_scene("stirred-pool", scene.text()));
    const auto &material = statistics["momentum x [kg/s]"];
    const auto &paddle   = statistics["paddle: velocity x [m/s]"];
    double change        = 0.;
    for (std::size_t row = 0; row < material.size(); ++row)
      change = std::max(change, std::abs(material[row] + mass * (paddle[row] - speed)));
    if (paddle.back() > 0.9 * speed)
      throw std::runtime_error("The paddle stirred nothing.");
    return change / (mass * speed);
  }
} // namespace magmpm::verification
