#include <magmpm/parameters/parameter_file.h>
#include <magmpm/simulation/scene.h>

#include <verification/mechanics/colliding_bodies.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr double modulus = 1e6, density = 1000., poisson_ratio = 0.3, radius = 1.;

    double
    speed_of_sound()
    {
      return std::sqrt(modulus * (1. - poisson_ratio) /
                       ((1. + poisson_ratio) * (1. - 2. * poisson_ratio)) / density);
    }

    /** How long they fly until they meet, over R/c. */
    constexpr double gap_at_start = 0.3; // R

    std::string
    point(const int dim, const double x, const double others)
    {
      std::string text = as_text(x);
      for (int d = 1; d < dim; ++d)
        text += ", " + as_text(others);
      return text;
    }

    std::string
    body(const Collision &collision, const int number)
    {
      const double off = collision.offset / collision.cells;
      const double x   = 2. + off + number * (2. * radius + gap_at_start);
      const double v   = (number == 0 ? 1. : -1.) * collision.speed * speed_of_sound();
      return "  subsection body" + std::to_string(number) +
             "\n    set Shape = sphere\n    set Material = rubber\n    set Density = " +
             as_text(density) + "\n    set Radius = " + as_text(radius) +
             "\n    set Centre = " + point(collision.dim, x, 1.5 + off) +
             "\n    set Contact group = " + std::to_string(number) +
             "\n    set Velocity = " + point(collision.dim, v, 0.) + "\n  end\n";
    }

    std::string
    scene_of(const Collision &collision)
    {
      return "set Dimension = " + std::to_string(collision.dim) +
             "\nset End time = 1\nset Gravity = " + point(collision.dim, 0., 0.) +
             "\nsubsection Box\n  set Upper corner = " + point(collision.dim, 7., 3.) +
             "\n  set Cell size = " + as_text(1. / collision.cells) +
             "\nend\nsubsection Time step\n  set Elastic factor = " +
             as_text(collision.elastic_factor) +
             "\nend\nsubsection Bodies\n  set List of bodies = body0, body1\n" +
             body(collision, 0) + body(collision, 1) +
             "end\nsubsection Materials\n  set List of materials = rubber\n  subsection rubber\n"
             "    set Young's modulus = " +
             as_text(modulus) + "\n    set Poisson ratio = " + as_text(poisson_ratio) +
             "\n  end\nend\n";
    }

    /** The time between 1 and 99 % of an impulse that grows over time. */
    double
    duration(const std::vector<double> &times, const std::vector<double> &impulse)
    {
      const auto time_of = [&](const double part) {
        std::size_t i = 1;
        while (i + 1 < impulse.size() && impulse[i] < part * impulse.back())
          ++i;
        const double step = impulse[i] - impulse[i - 1];
        const double over = part * impulse.back() - impulse[i - 1];
        return times[i - 1] + (times[i] - times[i - 1]) * (step > 0. ? over / step : 0.);
      };
      return time_of(0.99) - time_of(0.01);
    }

    double
    total_energy(const ColumnTable &columns)
    {
      double sum = 0.;
      for (const Column &column : columns.all())
        if (column.name.find(" energy") != std::string::npos)
          sum += column.number();
      return sum;
    }

    /** Along x: momentum of a body, and its lowest and highest particle. */
    struct Motion
    {
      double momentum = 0., lowest = 1e30, highest = -1e30;
    };

    template <int dim>
    Motion
    motion_of_body(const Body<dim> &body)
    {
      Motion motion;
      const ParticleSet<dim> &particles = body.particles;
      for (std::size_t p = 0; p < particles.size(); ++p)
        {
          motion.momentum += particles.component(ParticleProperty::mass, 0)[p] *
                             particles.vector(ParticleProperty::velocity, p)[0];
          motion.lowest  = std::min(motion.lowest, particles.position(p)[0]);
          motion.highest = std::max(motion.highest, particles.position(p)[0]);
        }
      return motion;
    }

    template <int dim>
    CollisionResult
    collide_in(const Collision &collision)
    {
      Scene<dim> scene(
        read_parameters<dim>(parse_parameter_text(scene_of(collision), "collision.prm")),
        MPI_COMM_SELF);
      scene.begin();
      const ColumnTable columns = scene.columns();
      const double unit         = radius / speed_of_sound();
      const double end   = (0.5 * gap_at_start / collision.speed + (dim == 2 ? 12. : 25.)) * unit;
      const double start = motion_of_body(scene.bodies()[1]).momentum;
      const double both  = motion_of_body(scene.bodies()[0]).momentum + start;
      std::vector<double> times = {0.}, impulse = {0.};
      double first_energy = 0., highest_energy = 0.;
      while (scene.time() < end)
        {
          const bool is_row = scene.progress().clock.step % 10 == 0;
          scene.step({end, is_row, {}});
          times.push_back(scene.time());
          impulse.push_back(motion_of_body(scene.bodies()[1]).momentum - start);
          if (!is_row)
            continue;
          scene.prepare_row();
          const double energy = total_energy(columns);
          if (first_energy == 0.)
            first_energy = energy;
          highest_energy = std::max(highest_energy, energy);
          scene.end_row();
        }
      const Motion left  = motion_of_body(scene.bodies()[0]),
                   right = motion_of_body(scene.bodies()[1]);
      return {impulse.back() / -start - 1.,
              duration(times, impulse) / unit,
              (right.lowest - left.highest) * collision.cells,
              std::abs(left.momentum + right.momentum - both) / -start,
              highest_energy / first_energy - 1.};
    }
  } // namespace

  CollisionResult
  collide(const Collision &collision)
  {
    return collision.dim == 2 ? collide_in<2>(collision) : collide_in<3>(collision);
  }

  // m/2 d'' = -4/3 E* sqrt(R/2) d^(3/2), 1/E* = 2 (1 - nu^2)/E, from the approach d = 0 at twice the speed of each.
  double
  hertz_contact_time(const double speed)
  {
    constexpr double pi = 3.14159265358979323846;
    const double c = speed_of_sound(), mass = 0.5 * 4. / 3. * pi * density * std::pow(radius, 3);
    const double stiffness = 4. / 3. * modulus / (2. * (1. - poisson_ratio * poisson_ratio)) *
                             std::sqrt(0.5 * radius);
    const double step = 1e-4 * radius / c;
    double approach = 0., velocity = 2. * speed * c;
    std::vector<double> times = {0.}, impulse = {0.};
    while (approach >= 0.)
      {
        const double change = step * stiffness / mass * std::pow(approach, 1.5);
        velocity -= change;
        approach += step * velocity;
        times.push_back(times.back() + step);
        impulse.push_back(impulse.back() + change);
      }
    return duration(times, impulse) * c / radius;
  }
} // namespace magmpm::verification
