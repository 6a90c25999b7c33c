#include <magmpm/base/constants.h>
#include <magmpm/materials/magnetization.h>

#include <verification/mechanics/wire_meniscus.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double edge        = 0.1; // m
    constexpr double gravity     = 9.81;
    constexpr double density     = 1000.;
    const MagneticContent medium = {3e3, 0.5}; // M_s [A/m], chi_0

    /** A ring round the wire [m]. */
    struct Ring
    {
      double inner, outer;
    };

    constexpr Ring near = {edge / 8., edge * 3. / 16.};
    constexpr Ring far  = {edge * 9. / 32., edge * 3. / 8.};

    std::string
    scene(const WireMeniscus &pool)
    {
      const std::string middle = as_text(0.5 * edge), top = as_text(0.25 * edge);
      return "set Dimension = 3\nset End time = " + as_text(pool.duration) +
             "\nset Gravity = 0, 0, " + as_text(-gravity) + "\nset Checkpoint every = never\n" +
             "subsection Box\nset Upper corner = " + as_text(edge) + ", " + as_text(edge) + ", " +
             as_text(0.75 * edge) + "\nset Cell size = " + as_text(edge / pool.cells) + "\nend\n" +
             "subsection Bodies\nset List of bodies = pool\nsubsection pool\n"
             "set Material = ferrofluid\nset Lower corner = 0, 0, 0\nset Upper corner = " +
             as_text(edge) + ", " + as_text(edge) + ", " + top +
             "\nset Density = " + as_text(density) +
             "\nset Particles per edge = " + std::to_string(pool.particles_per_edge) +
             "\nend\nend\n" +
             "subsection Materials\nset List of materials = ferrofluid\nsubsection ferrofluid\n"
             "set Mechanical law = viscoelastic fluid\nset Bulk modulus = 6.4e4\n"
             "set Viscosity = 0.01\nset Saturation magnetization = " +
             as_text(medium.saturation_magnetization) +
             "\nset Initial susceptibility = " + as_text(medium.initial_susceptibility) +
             "\nend\nend\n" +
             "subsection Magnets\nset List of magnets = wire\nsubsection wire\n"
             "set Type = straight wire\nset Current = " +
             as_text(pool.current) + "\nset Position = " + middle + "; " + middle + "; 0\n" +
             "set Conductor radius = " + as_text(edge / pool.cells) + "\nend\nend\n" + R"(
subsection Walls
  set Lower x = slip
  set Upper x = slip
  set Lower y = slip
  set Upper y = slip
  set Lower z = slip
  set Upper z = slip
end
subsection Magnetics
  set Newton tolerance = 1e-6
end
subsection Rest
  set Damping rate = 20
end
subsection Output
  set Particle quantities = J
  set Fields              = false
  set Statistics every    = 10
  set Frame interval      = )" +
             as_text(pool.duration / 20.) + "\nend\n";
    }

    /** mu_0/(rho g) int M dH at a distance from the wire [m]. */
    double
    height(const double current, const double radius)
    {
      const Vector<2> field = {{current / (2. * constants::pi * radius), 0.}};
      return constants::vacuum_permeability / (density * gravity) *
             magnetic_response(MagnetizationLaw::langevin, medium, field).coenergy;
    }

    double
    exact_mean(const double current, const Ring &ring)
    {
      constexpr int n = 1000;
      double sum = 0., area = 0.;
      for (int i = 0; i < n; ++i)
        {
          const double radius = ring.inner + (ring.outer - ring.inner) * (i + 0.5) / n;
          sum += radius * height(current, radius);
          area += radius;
        }
      return sum / area;
    }

    /** The part of a square of edge @p spacing around (x, y) that lies over a ring, by 6 x 6 points. */
    double
    part_over(const Ring &ring, const double x, const double y, const double spacing)
    {
      constexpr int n = 6;
      int n_over      = 0;
      for (int i = 0; i < n * n; ++i)
        {
          const double radius = std::hypot(x + ((i % n + 0.5) / n - 0.5) * spacing - 0.5 * edge,
                                           y + ((i / n + 0.5) / n - 0.5) * spacing - 0.5 * edge);
          n_over += (radius > ring.inner && radius < ring.outer);
        }
      return static_cast<double>(n_over) / (n * n);
    }

    /**
     * Volume of the particles over a ring, over its area [m]. Each is spread over the square that it began in: by
     * their centres alone a ring of one cell knows its volume to 10 %.
     */
    double
    mean_height(const ParticleFrame &frame, const double spacing, const Ring &ring)
    {
      const double particle_volume = spacing * spacing * spacing;
      const auto &volume_ratios    = frame.quantities.at("J [-]");
      double volume                = 0.;
      for (std::size_t p = 0; p < frame.size(); ++p)
        volume += particle_volume * volume_ratios[p][0] *
                  part_over(ring, frame.positions[p][0], frame.positions[p][1], spacing);
      return volume / (constants::pi * (ring.outer * ring.outer - ring.inner * ring.inner));
    }
  } // namespace

  MeniscusHeights
  meniscus_heights(const WireMeniscus &pool)
  {
    const std::string folder = run_scene("wire-meniscus-" + std::to_string(pool.cells) +
                                           (pool.current > 0. ? "" : "-no-current"),
                                         scene(pool));
    const double spacing     = edge / pool.cells / pool.particles_per_edge;
    const auto frames        = particle_frames(folder);
    MeniscusHeights heights  = {0., 0., 0.};
    // The mean of the last frames.
    constexpr int n_last = 5;
    for (auto frame = frames.end() - n_last; frame != frames.end(); ++frame)
      heights.measured += (mean_height(*frame, spacing, near) - mean_height(*frame, spacing, far)) /
                          (n_last * edge);
    if (pool.current > 0.)
      heights.exact = (exact_mean(pool.current, near) - exact_mean(pool.current, far)) / edge;
    const double mass = density * 0.25 * edge * edge * edge;
    heights.speed     = std::sqrt(2. * Statistics(folder).last("kinetic energy [J]") / mass);
    return heights;
  }
} // namespace magmpm::verification
