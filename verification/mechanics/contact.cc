#include <verification/mechanics/contact.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace magmpm::verification
{
  namespace
  {
    constexpr double modulus = 1e6, density = 1000., poisson_ratio = 0.3;

    double
    speed_of_sound()
    {
      return std::sqrt(modulus * (1. - poisson_ratio) /
                       ((1. + poisson_ratio) * (1. - 2. * poisson_ratio)) / density);
    }

    /** Components in 3D or, without the middle one, in 2D. */
    std::string
    point(const int dim, const double x, const double y, const double z)
    {
      return as_text(x) + (dim == 3 ? ", " + as_text(y) : "") + ", " + as_text(z);
    }

    std::string
    upward(const int dim)
    {
      return dim == 3 ? "z" : "y";
    }

    std::string
    box(const std::string &lower, const std::string &upper)
    {
      return "  set Lower corner = " + lower + "\n  set Upper corner = " + upper + "\n";
    }

    std::string
    block(const std::string &lower,
          const std::string &upper,
          const std::string &velocity,
          const std::string &slab = "")
    {
      return "subsection Bodies\n  set List of bodies = block" +
             std::string(slab.empty() ? "" : ", slab") +
             "\n  subsection block\n    set Material = elastomer\n    set Density = " +
             as_text(density) + "\n" + box(lower, upper) + "    set Velocity = " + velocity +
             "\n  end\n" + slab +
             "end\nsubsection Materials\n  set List of materials = elastomer\n"
             "  subsection elastomer\n    set Young's modulus = " +
             as_text(modulus) + "\n    set Poisson ratio = " + as_text(poisson_ratio) +
             "\n  end\nend\n";
    }

    /** The subsection of an elastic slab that sticks to the wall below, in contact group 1. */
    std::string
    slab(const int dim, const double height)
    {
      return "  subsection slab\n    set Material = elastomer\n    set Density = " +
             as_text(density) + "\n    set Contact group = 1\n" +
             box(point(dim, 0.5, 0., 0.), point(dim, 7.5, 2., height)) + "  end\n";
    }

    std::string
    ground(const int dim, const Ground kind, const double height, const double friction)
    {
      if (kind == Ground::slab)
        return "subsection Contacts\n  set List of contacts = sliding\n  subsection sliding\n"
               "    set Groups = 0, 1\n    set Friction = " +
               as_text(friction) + "\n  end\nend\n";
      if (kind == Ground::wall)
        return "subsection Walls\n  set Lower " + upward(dim) + " = separate\n  set Lower " +
               upward(dim) + " friction = " + as_text(friction) + "\nend\n";
      return "subsection Rigid bodies\n  set List of rigid bodies = ground\n  subsection ground\n" +
             box(point(dim, -4., -4., height - 4.), point(dim, 12., 12., height)) +
             "    set Motion = scripted\n    set Contact = separate\n    set Friction = " +
             as_text(friction) + "\n  end\nend\n";
    }

    std::string
    run_for(const double end_time, const int rows_every, const bool writes_halfway = false)
    {
      return "set End time = " + as_text(end_time) +
             "\nsubsection Output\n  set Frame interval = " +
             as_text(writes_halfway ? 0.5 * end_time : end_time) +
             "\n  set Particles = " + (writes_halfway ? "true" : "false") +
             "\n  set Particle quantities = body\n  set Statistics every = " +
             std::to_string(rows_every) + "\nend\n";
    }

    /** The columns of the energies, added up. */
    std::vector<double>
    total_energy(const Statistics &statistics)
    {
      std::vector<double> total(statistics.n_rows());
      for (const std::string &heading : statistics.headings)
        if (heading.find(" energy [J") != std::string::npos)
          for (std::size_t row = 0; row < total.size(); ++row)
            total[row] += statistics[heading][row];
      return total;
    }
    /** Where the centre of the first body is along x in each frame; its particles are all alike. */
    std::vector<double>
    places_of_first_body(const std::string &folder)
    {
      std::vector<double> places;
      for (const ParticleFrame &frame : particle_frames(folder))
        {
          const auto &bodies = frame.quantities.at("body [-]");
          double sum         = 0.;
          int n              = 0;
          for (std::size_t p = 0; p < frame.size(); ++p)
            if (bodies[p][0] == 0.)
              {
                sum += frame.positions[p][0];
                ++n;
              }
          places.push_back(sum / n);
        }
      return places;
    }
  } // namespace

  ImpactResult
  impact(const Impact &impact)
  {
    const int dim   = impact.dim;
    const double dx = 1. / impact.cells, speed = impact.speed * speed_of_sound();
    const bool on_wall = (impact.ground == Ground::wall);
    const double floor = on_wall ? 0. : (4. + impact.offset) * dx;
    const double start = floor + 0.5 + (on_wall ? impact.offset * dx : 0.);
    const double end   = 10. * 0.1 / speed;
    const std::string scene =
      "set Dimension = " + std::to_string(dim) + "\nset Gravity = " + point(dim, 0., 0., 0.) +
      "\nsubsection Box\n" + box(point(dim, 0., 0., 0.), point(dim, 4., 4., 4.)) +
      "  set Cell size = " + as_text(dx) +
      "\nend\nsubsection Time step\n  set Elastic factor = " + as_text(impact.elastic_factor) +
      "\nend\n" +
      block(
        point(dim, 1.5, 1.5, start), point(dim, 2.5, 2.5, start + 1.), point(dim, 0., 0., -speed)) +
      ground(dim, impact.ground, floor, 0.) + run_for(end, 1);
    const Statistics statistics(run_scene("impact", scene));

    const auto &momentum =
      statistics["momentum " + upward(dim) + (dim == 3 ? " [kg m/s]" : " [kg/s]")];
    const auto &kinetic = statistics[dim == 3 ? "kinetic energy [J]" : "kinetic energy [J/m]"];
    const auto &depth   = statistics["deepest contact [m]"];
    const auto &steps   = statistics["dt [s]"];
    const auto total    = total_energy(statistics);
    const auto first    = std::find_if(depth.begin(), depth.end(), [](double d) { return d > 0.; });
    return {-momentum.back() / momentum.front(),
            first == depth.end() ? 0. : -*first / dx,
            first == depth.end() ? 0. : speed * steps[first - depth.begin()] / dx,
            *std::max_element(depth.begin(), depth.end()) / dx,
            (*std::max_element(total.begin(), total.end()) - total.front()) / kinetic.front()};
  }

  InclineResult
  slide(const Incline &incline)
  {
    constexpr double angle = 0.3, gravity = 1.; // rad, m/s^2
    const int dim   = incline.dim;
    const double dx = 1. / 8., end = 2. / std::sqrt(gravity * std::sin(angle)); // s
    const double off   = incline.offset * dx;
    const double floor = incline.ground == Ground::wall ? 0. : 0.5 + off;
    const std::string scene =
      "set Dimension = " + std::to_string(dim) +
      "\nset Gravity = " + point(dim, gravity * std::sin(angle), 0., -gravity * std::cos(angle)) +
      "\nsubsection Box\n" + box(point(dim, 0., 0., 0.), point(dim, 8., 2., 4.)) +
      "  set Cell size = " + as_text(dx) +
      "\nend\nsubsection Rest\n  set Damping rate = " + as_text(incline.damping_rate) + "\nend\n" +
      block(point(dim, 1. + off, 0.5 + off, floor),
            point(dim, 2. + off, 1.5 + off, floor + 0.5),
            point(dim, 0., 0., 0.),
            incline.ground == Ground::slab ? slab(dim, floor) : "") +
      ground(dim, incline.ground, floor, incline.friction) + run_for(end, 20, true);
    // At the start, halfway and at the end.
    const std::vector<double> places = places_of_first_body(run_scene("incline", scene));
    const double way = 0.5 * gravity * (std::sin(angle) - incline.friction * std::cos(angle)) *
                       end * end;
    return {(places.back() - places.front()) / way - 1., (places.back() - places[1]) / dx};
  }

  double
  energy_rise_on(const Obstruction obstruction, const double elastic_factor)
  {
    const std::string shape =
      obstruction == Obstruction::ball
        ? "    set Shape = sphere\n    set Centre = 0.5, 0.5, 0.1\n    set Radius = 0.1\n"
        : box("0.4, 0.4, 0", "0.6, 0.6, 0.2");
    const std::string scene =
      "set Dimension = 3\nset Gravity = 0, 0, -15\nsubsection Box\n" + box("0, 0, 0", "1, 1, 1") +
      "  set Cell size = 0.03125\nend\nsubsection Time step\n  set Elastic factor = " +
      as_text(elastic_factor) +
      "\nend\nsubsection Bodies\n  set List of bodies = cube\n  subsection cube\n"
      "    set Material = clay\n    set Density = 2500\n" +
      box("0.40625, 0.40625, 0.3515625", "0.59375, 0.59375, 0.5390625") +
      "  end\nend\nsubsection Materials\n  set List of materials = clay\n  subsection clay\n"
      "    set Young's modulus = 1e5\n    set Poisson ratio = 0.3\n  end\nend\n"
      "subsection Rigid bodies\n  set List of rigid bodies = body\n  subsection body\n" +
      shape + "    set Motion = scripted\n    set Contact = separate\n  end\nend\n" +
      run_for(0.35, 1);
    const Statistics statistics(run_scene("cube_on_body", scene));
    const auto &kinetic = statistics["kinetic energy [J]"];
    double lowest = total_energy(statistics).front(), rise = 0.;
    for (const double energy : total_energy(statistics))
      {
        lowest = std::min(lowest, energy);
        rise   = std::max(rise, energy - lowest);
      }
    return rise / *std::max_element(kinetic.begin(), kinetic.end());
  }
} // namespace magmpm::verification
