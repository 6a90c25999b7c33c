// What magnetism does to bodies that move and deform, against mechanics that knows nothing of the
// lattice: mean stress, angular momentum, work, momentum.

#include "catch.h"

#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <verification/program/paths.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

using namespace magmpm::verification;

namespace
{
  constexpr double vacuum_permeability = 1.25663706212e-6; // [N/A^2]
  constexpr double pi                  = 3.14159265358979;

  /** A value for each axis: "a, b" in 2D, "a, a, b" in 3D. */
  std::string
  vector_text(const int dim, const std::string &other, const std::string &last, const char *comma)
  {
    std::string text;
    for (int d = 0; d + 1 < dim; ++d)
      text += other + comma;
    return text + last;
  }

  /**
   * A soft magnetic body alone in a box of 24^dim cells of dx = 10 mm without gravity, 1000 kg/m^3.
   *
   * @param body   lines of its subsection that tell the shape.
   * @param magnet lines of the subsection of the only magnet.
   */
  std::string
  floating_body(const std::string &name,
                const int dim,
                const std::string &body,
                const std::string &magnet,
                const std::string &end_time,
                const std::string &frame_interval)
  {
    return write_scene(name,
                       "set Dimension = " + std::to_string(dim) + "\nset End time = " + end_time +
                         "\nset Gravity = " + vector_text(dim, "0", "0", ", ") + R"(
subsection Box
  set Cell size = 0.01
  set Upper corner = )" + vector_text(dim, "0.24", "0.24", ", ") +
                         R"(
end
subsection Bodies
  set List of bodies = body
  subsection body
    set Material = elastomer
    set Density  = 1000
)" + body + R"(
  end
end
subsection Materials
  set List of materials = elastomer
  subsection elastomer
    set Mechanical law           = neo-Hookean
    set Young's modulus          = 1e6
    set Poisson ratio            = 0.3
    set Saturation magnetization = 8e4
    set Initial susceptibility   = 0.9
  end
end
subsection Magnets
  set List of magnets = magnet
  subsection magnet
)" + magnet + R"(
  end
end
subsection Output
  set Fields = false
  set Particle quantities = velocity
  set Frame interval = )" +
                         frame_interval + "\nend\n");
  }

  Statistics
  statistics_of(const std::string &scene, const std::string &options = "")
  {
    const Outcome run = run_magmpm(scene + " " + options);
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    return Statistics("output-" + scene.substr(0, scene.find('.')));
  }

  using Points = std::vector<std::array<double, 3>>;

  /** Positions of the particles of a frame, in the order in which they were written. */
  Points
  particles_of(const std::string &folder, const int frame)
  {
    char name[64];
    std::snprintf(name, sizeof(name), "/particles/particles_%04d.pvtu", frame);
    vtkNew<vtkXMLPUnstructuredGridReader> reader;
    reader->SetFileName((folder + name).c_str());
    reader->Update();
    Points points(reader->GetOutput()->GetNumberOfPoints());
    for (std::size_t p = 0; p < points.size(); ++p)
      reader->GetOutput()->GetPoint(p, points[p].data());
    return points;
  }

  /** A file of the points of a regular grid, @p distance apart, in a sphere (disc in 2D). */
  void
  write_sphere(const std::string &file,
               const int dim,
               const double centre,
               const double radius,
               const double distance)
  {
    std::ofstream stream(file);
    const int n = static_cast<int>(std::lround((centre + radius) / distance));
    for (int k = 0; k < (dim == 3 ? n : 1); ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          {
            double square = 0.;
            std::string line;
            for (int d = 0; d < dim; ++d)
              {
                const double x = distance * ((d == 0 ? i : d == 1 ? j : k) + 0.5);
                square += (x - centre) * (x - centre);
                line += (d == 0 ? "" : ", ") + std::to_string(x);
              }
            if (square <= radius * radius)
              stream << line << '\n';
          }
  }

  /**
   * Mean of du/dx along an axis over a convex body of particles on a regular lattice, by Gauss:
   * along each row the difference of the displacements of its ends, which are extrapolated from the
   * particles by half of their distance.
   */
  double
  mean_strain(const Points &start, const Points &now, const int axis, const double distance)
  {
    std::map<std::array<long, 2>, std::vector<std::size_t>> rows;
    for (std::size_t p = 0; p < start.size(); ++p)
      rows[{std::lround(start[p][(axis + 1) % 3] / distance - 0.5),
            std::lround(start[p][(axis + 2) % 3] / distance - 0.5)}]
        .push_back(p);
    double sum = 0., length = 0.;
    for (auto &[place, row] : rows)
      {
        if (row.size() < 2)
          continue;
        std::sort(row.begin(), row.end(), [&, axis = axis](const auto a, const auto b) {
          return start[a][axis] < start[b][axis];
        });
        const auto displacement = [&, &row = row](const std::size_t i) {
          return now[row[i]][axis] - start[row[i]][axis];
        };
        const std::size_t last = row.size() - 1;
        sum += 1.5 * displacement(last) - 0.5 * displacement(last - 1) - 1.5 * displacement(0) +
               0.5 * displacement(1);
        length += row.size() * distance;
      }
    return sum / length;
  }
} // namespace

TEST_CASE("A magnetized sphere stretches along the field", "[program]")
{
  // A sphere (disc in 2D) of radius 10 dx that is free in a uniform field carries the traction mu_0
  // M_n^2/2 and no other force. The mean stress is int x (x) t/V, so the mean strains along and
  // across the field differ by mu_0 M^2/(10 mu) (8 mu in 2D), M its magnetization. Its particles are on a
  // regular grid, in whose rows the strain is measured. It vibrates
  // about that: a mean over time with the weight 1 - cos over some periods removes the vibration.
  for (const int dim : {2, 3})
    {
      const std::string name = "stretch-" + std::to_string(dim) + "d";
      write_sphere(name + ".csv", dim, 0.12, 0.1, 0.005);
      const std::string folder = "output-" + name;
      const Statistics statistics =
        statistics_of(floating_body(name,
                                    dim,
                                    "    set Shape = points\n    set File  = " + name + ".csv",
                                    "    set Field = " + vector_text(dim, "0", "1e5", "; "),
                                    "0.075",
                                    "0.0015"));
      const Points start = particles_of(folder, 0);
      const int n_frames = 50, along = dim - 1;
      double along_field = 0., across = 0.;
      for (int frame = 1; frame < n_frames; ++frame)
        {
          const Points now    = particles_of(folder, frame);
          const double weight = (1. - std::cos(2. * pi * frame / n_frames)) / n_frames;
          REQUIRE(now.size() == start.size());
          along_field += weight * mean_strain(start, now, along, 0.005);
          across += weight * mean_strain(start, now, 0, 0.005);
        }
      const double volume        = start.size() * std::pow(0.005, dim);
      const double magnetization = statistics.last(dim == 2 ? "body: magnetic moment y [A m]"
                                                            : "body: magnetic moment z [A m^2]") /
                                   volume;
      const double shear_modulus = 1e6 / (2. * 1.3);
      const double exact         = vacuum_permeability * magnetization * magnetization /
                           ((dim == 2 ? 8. : 10.) * shear_modulus);
      std::printf("stretch in a field, %dD: %.4e, exact %.4e, difference %.1f %%; across %.2e\n",
                  dim,
                  along_field - across,
                  exact,
                  100. * ((along_field - across) / exact - 1.),
                  across);
      CHECK(along_field > 0.);
      CHECK(across < 0.);
      CHECK(along_field - across == Approx(exact).epsilon(0.05));
    }
}

TEST_CASE("A rod turns by the torque of the field", "[program]")
{
  // Angular momentum of a free body in a uniform field is the time integral of its torque mu_0 m x
  // H_0, m its moment, for a body of any shape. When the field is switched off it is kept. The
  // torque comes from the antisymmetric part of the force's stress, the moment from the
  // magnetization: they share nothing.
  for (const int dim : {2, 3})
    {
      const std::string field = "if(t < 0.01, 7e4, 0)";
      const std::string rod =
        dim == 2 ? "    set Shape = box\n    set Lower corner = 0.06, 0.09\n"
                   "    set Upper corner = 0.18, 0.14"
                 : "    set Shape = cylinder\n    set Centre = 0.12, 0.12, 0.12\n"
                   "    set Axis = 1, 0.3, 0.2\n    set Radius = 0.03\n    set Length = 0.12";
      const Statistics statistics =
        statistics_of(floating_body("turn-" + std::to_string(dim) + "d",
                                    dim,
                                    rod,
                                    "    set Field = " +
                                      (dim == 2 ? field + "; " + field : field + "; 0; " + field),
                                    "0.012",
                                    "0.01"),
                      "--set Output/Particles=false");
      // About z in 2D, about y in 3D: from the moments along the axes of the field.
      const std::string unit = dim == 2 ? " [A m]" : " [A m^2]";
      const auto &time       = statistics["time [s]"];
      const auto &angular =
        statistics[dim == 2 ? "angular momentum z [kg m/s]" : "angular momentum y [kg m^2/s]"];
      const auto &first =
        statistics["body: magnetic moment " + std::string(dim == 2 ? "x" : "z") + unit];
      const auto &second =
        statistics["body: magnetic moment " + std::string(dim == 2 ? "y" : "x") + unit];
      double integral = 0., reached = 0., change = 0.;
      for (std::size_t row = 1; row < statistics.n_rows(); ++row)
        if (time[row - 1] < 0.01 * (1. - 1e-9))
          {
            integral += vacuum_permeability * 7e4 * (first[row] - second[row]) *
                        (time[row] - time[row - 1]);
            reached = angular[row];
          }
        else
          change = std::max(change, std::abs(angular[row] - reached));
      std::printf(
        "rod in a field, %dD: angular momentum %.5g, integral of the torque %.5g, kept to "
        "%.1e\n",
        dim,
        reached,
        integral,
        change / std::abs(reached));
      CHECK(std::abs(reached) > 1e-4);
      CHECK(reached == Approx(integral).epsilon(0.02));
      CHECK(change < 1e-5 * std::abs(reached)); // of FMPM, of a rod that vibrates
      CHECK(statistics.last("time [s]") > 0.0119);
    }
}

TEST_CASE("A moved magnet does the work that the energies gain", "[program]")
{
  // A magnet passes below a block on the wall. Its energy depends on where the one is from the
  // other, so the work on the moved magnet, against the force of the block, is that of the block's
  // force over the way of the magnet; magnetic, elastic and kinetic energy gain it. Solved in every
  // step.
  const Statistics statistics = statistics_of(
    floating_body("work",
                  2,
                  "    set Lower corner = 0.08, 0.16\n    set Upper corner = 0.16, 0.24",
                  "    set Type = magnetized sphere\n    set Radius = 0.03\n"
                  "    set Position = 0.02 + 2*t; 0.06\n"
                  "    set Magnetization = 0; 1e6",
                  "0.08",
                  "0.04"),
    "--set Output/Particles=false --set \"Magnetics/Solve/When=every step\"");
  const auto &time  = statistics["time [s]"];
  const auto &force = statistics["body: magnetic force x [N/m]"];
  const auto energy = [&](const std::size_t row) {
    return statistics["magnetic energy [J/m]"][row] + statistics["elastic energy [J/m]"][row] +
           statistics["kinetic energy [J/m]"][row];
  };
  double work = 0., most_work = 0., largest = 0.;
  for (std::size_t row = 1; row < statistics.n_rows(); ++row)
    {
      work += (force[row] + force[row - 1]) * (time[row] - time[row - 1]); // at 2 m/s
      most_work = std::max(most_work, std::abs(work));
      largest   = std::max(largest, std::abs(energy(row) - energy(0) - work));
    }
  std::printf("moved magnet: work up to %.4g J/m, energies gain it but for %.2f %%\n",
              most_work,
              100. * largest / most_work);
  CHECK(most_work > 0.1);
  CHECK(largest < 0.01 * most_work);
}

TEST_CASE("A body floats in a uniform field", "[program]")
{
  // The field pulls a body apart but not away: its momentum stays zero over 1000 steps. It is
  // compared with what each half of the body hands to the other, mu_0 M^2/2 over its cross-section
  // for that time. The lattice around the body cuts off the far end of the field's stress, a few
  // 1e-5 of it.
  for (const int dim : {2, 3})
    {
      const Statistics statistics = statistics_of(
        floating_body("float-" + std::to_string(dim) + "d",
                      dim,
                      "    set Shape  = sphere\n    set Radius = 0.06\n    set Centre = " +
                        std::string(dim == 2 ? "" : "0.1177, ") + "0.1234, 0.1291",
                      "    set Field = " + vector_text(dim, "0", "1e5", "; "),
                      "0.1",
                      "0.1"),
        "--set Output/Particles=false --set \"Time step/Time step=1e-4\"");
      REQUIRE(statistics.n_rows() == 1001);
      double momentum = 0.;
      for (const std::string &axis :
           dim == 2 ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"x", "y", "z"})
        momentum = std::hypot(
          momentum, statistics.last("momentum " + axis + (dim == 2 ? " [kg/s]" : " [kg m/s]")));
      const double volume        = statistics.last("particles") * std::pow(0.005, dim);
      const double section       = dim == 2 ? 0.12 : pi * 0.06 * 0.06;
      const double magnetization = statistics.last(dim == 2 ? "body: magnetic moment y [A m]"
                                                            : "body: magnetic moment z [A m^2]") /
                                   volume;
      const double exchanged = 0.5 * vacuum_permeability * magnetization * magnetization * section *
                               0.1;
      std::printf("floating body, %dD: momentum %.2e, exchanged %.2e, ratio %.1e\n",
                  dim,
                  momentum,
                  exchanged,
                  momentum / exchanged);
      CHECK(momentum < 2e-4 * exchanged);
    }
}

TEST_CASE("Between solves the force follows the motion", "[program]")
{
  // A cube that falls to a magnet, solved in every step and by default, after a way of 0.15 dx.
  // Between solves the force goes on changing as before: it is that of the present height, which
  // the run with all solves tells, to second order of the way. With dx = 1/32 m 0.15 dx change the
  // force by up to a sixth, and less than 4 % of it are missed; three quarters of the solves are saved.
  const std::string scene = source_folder() +
                            "/parameter_files/cube_nonlinear.prm --set Output/Particles=false "
                            "--set Output/Fields=false --set \"Box/Cell size=0.03125\" "
                            "--set \"End time=0.1\" --set \"Output/Frame interval=0.1\" ";
  const auto run_with = [&](const std::string &name, const std::string &when) {
    const Outcome run = run_magmpm(scene + "--set \"Output directory=" + name +
                                   "\" --set \"Magnetics/Solve/When=" + when + "\"");
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    return Statistics(name);
  };
  const Statistics all = run_with("trigger-all", "every step");
  const Statistics few = run_with("trigger-few", "changed");

  const std::string height = "centre of mass z [m]", force = "cube: magnetic force z [N]";
  const auto force_at = [&](const double z) {
    std::size_t row = 1;
    while (row + 1 < all.n_rows() && all[height][row] > z)
      ++row;
    const double part = (z - all[height][row - 1]) / (all[height][row] - all[height][row - 1]);
    return all[force][row - 1] + part * (all[force][row] - all[force][row - 1]);
  };
  double largest_error = 0.;
  for (std::size_t row = 2; row < few.n_rows(); ++row)
    largest_error = std::max(largest_error,
                             std::abs(few[force][row] / force_at(few[height][row]) - 1.));
  const double ratio = few.last("magnetic solves") / all.last("magnetic solves");
  std::printf("default trigger: %.0f of %.0f solves, the force is wrong by %.1f %% at most\n",
              few.last("magnetic solves"),
              all.last("magnetic solves"),
              100. * largest_error);
  CHECK(ratio < 0.5);
  CHECK(largest_error < 0.05);
}

TEST_CASE("Cells of dx and the smeared indicator act", "[program]")
{
  // The moment of a linear disc in a uniform field is chi/(1 + chi/2) H_0 V. The smeared indicator
  // makes it too large by about 0.35 dx/R, the sharp one hardly; cells of dx take more unknowns
  // than those of 2 dx.
  const std::string scene = floating_body("choices",
                                          2,
                                          "    set Shape  = sphere\n    set Radius = 0.06\n"
                                          "    set Centre = 0.1234, 0.1291",
                                          "    set Field = 0; 1e5",
                                          "1e-4",
                                          "1e-4");
  const auto run_with     = [&](const std::string &option) {
    const Statistics statistics = statistics_of(
      scene, "--set Output/Particles=false --set \"Magnetics/Magnetization law=linear\" " + option);
    const double volume = pi * 0.06 * 0.06;
    return std::pair<double, double>(
      statistics.last("body: magnetic moment y [A m]") / (0.9 / 1.45 * 1e5 * volume) - 1.,
      statistics.last("potential unknowns"));
  };
  const auto [sharp, unknowns]      = run_with("");
  const auto [fine, more_unknowns]  = run_with("--set \"Magnetics/Potential cell size=dx\"");
  const auto [smeared, as_unknowns] = run_with("--set \"Magnetics/Material indicator=smeared\"");
  std::printf(
    "disc, R = 6 dx: error of the moment %.2f %%, with cells of dx %.2f %% (%.0f unknowns "
    "instead of %.0f), smeared %.2f %%\n",
    100. * sharp,
    100. * fine,
    more_unknowns,
    unknowns,
    100. * smeared);
  CHECK(std::abs(sharp) < 0.01);
  CHECK(std::abs(fine) < 0.01);
  CHECK(fine != sharp);
  CHECK(smeared > 0.01);
  CHECK(more_unknowns > 2.5 * unknowns);
  CHECK(as_unknowns == unknowns);
}
