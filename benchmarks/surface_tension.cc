// Surface tension against what is known of it: drops at rest, that swing and that fly, waves, contact angles.
//
//   surface_tension [--csv] [--long] [--only NAME]
//
// A row is met if its value is at most its limit. --only runs the rows whose names begin so; --long those in 3D and on
// finer lattices too.

#include <magmpm/base/constants.h>
#include <magmpm/base/number_text.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <shared/command_line.h>
#include <shared/limit_rows.h>
#include <verification/capillarity/drop_runs.h>
#include <verification/capillarity/layer_runs.h>
#include <verification/capillarity/sessile_drop.h>

#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace magmpm;
using namespace magmpm::verification;
using benchmarks::LimitCase;
using benchmarks::LimitRow;

namespace
{
  constexpr double rounding = 1e-12;

  /** What is demanded of a drop at rest. */
  struct RestLimits
  {
    double pressure, rms, largest;
  };

  std::vector<LimitRow>
  rows_of(const std::string &name, const RestingDrop &drop, const RestLimits &limits)
  {
    return {{name + ", pressure", std::abs(drop.pressure), limits.pressure},
            {name + ", rms velocity [U]", drop.rms, limits.rms},
            {name + ", largest velocity [U]", drop.largest, limits.largest},
            {name + ", momentum [M U]", drop.momentum, rounding},
            {name + ", angular momentum [M U R]", drop.angular_momentum},
            {name + ", surface energy", std::abs(drop.surface)}};
  }

  std::string
  name_of(const std::string &what, const DropRun &run)
  {
    return what + (run.dim == 3 ? " 3D" : "") + ", R/" + std::to_string(run.cells) + ", La " +
           to_text(run.laplace_number);
  }

  void
  add_resting(std::vector<LimitCase> &cases, const DropRun &run, const RestLimits &limits)
  {
    const std::string name = name_of("drop", run) + ", offset " + to_text(run.offset[0]);
    cases.push_back({name, [=] { return rows_of(name, resting_drop(run), limits); }});
  }

  void
  add_drops(std::vector<LimitCase> &cases, const bool is_long)
  {
    const std::array<double, 3> offsets[] = {{0., 0., 0.}, {0.2, 0.37, 0.13}, {0.5, 0.31, 0.44}};
    for (const auto &offset : offsets)
      {
        DropRun run;
        run.offset         = offset;
        run.laplace_number = 120.;
        add_resting(cases, run, {0.03, 0.005, 0.03});
        if (!is_long)
          continue;
        run.laplace_number = 12000.;
        add_resting(cases, run, {0.03, 0.01, 0.05});
        run.cells = 16;
        add_resting(cases, run, {0.02, 0.01, 0.05});
        run.cells = 8;
        run.dim   = 3;
        add_resting(cases, run, {0.04, 0.01, 0.05});
      }
    if (!is_long)
      {
        add_resting(cases, DropRun(), {0.03, 0.01, 0.05});
        DropRun fine;
        fine.cells    = 16;
        fine.duration = 4.;
        add_resting(cases, fine, {0.02, 0.01, 0.05});
      }
  }

  void
  add_oscillating(std::vector<LimitCase> &cases, const DropRun &drop, const double limit)
  {
    DropRun run            = drop;
    run.amplitude          = 0.05;
    const std::string name = name_of("oscillating drop", run);
    cases.push_back({name, [=]() -> std::vector<LimitRow> {
                       const OscillatingDrop swing = oscillating_drop(run);
                       return {{name + ", omega", std::abs(swing.frequency), limit},
                               {name + ", damping", std::abs(swing.damping), 0.1},
                               {name + ", misfit", swing.misfit},
                               {name + ", momentum [M U]", swing.momentum, rounding}};
                     }});
  }

  void
  add_moved(std::vector<LimitCase> &cases, const DropRun &drop)
  {
    DropRun run            = drop;
    run.velocity           = 0.5;
    const std::string name = name_of("moved drop", run);
    cases.push_back({name, [=]() -> std::vector<LimitRow> {
                       const MovedDrop moved      = moved_drop(run);
                       std::vector<LimitRow> rows = rows_of(name, moved.drop, {0.03, 0.01, 0.05});
                       rows.push_back({name + ", speed", std::abs(moved.speed), 1e-3});
                       rows.push_back({name + ", shape", std::abs(moved.aspect), 0.005});
                       return rows;
                     }});
  }

  void
  add_wave(std::vector<LimitCase> &cases, const int cells, const double limit)
  {
    LayerRun run;
    run.cells              = cells;
    run.depth_cells        = cells / 2;
    run.height_cells       = cells / 4;
    run.layer.viscosity    = 1e-6;
    run.steepness          = 2. * constants::pi / cells; // a cell high
    const std::string name = "capillary-gravity wave, " + std::to_string(cells) + " cells";
    cases.push_back({name, [=]() -> std::vector<LimitRow> {
                       const LayerWave wave = layer_wave(run);
                       return {{name + ", omega", std::abs(wave.frequency), limit},
                               {name + ", decay a period", wave.decay},
                               {name + ", exact decay", wave.exact_decay},
                               {name + ", misfit", wave.misfit},
                               {name + ", steepness", wave.steepness}};
                     }});
  }

  void
  add_sessile(std::vector<LimitCase> &cases,
              const int dim,
              const double angle,
              const double slab = 0.)
  {
    SessileRun run;
    run.slab  = slab;
    run.dim   = dim;
    run.angle = angle;
    if (dim == 3)
      {
        run.cells              = 6;
        run.particles_per_edge = 2;
      }
    const std::string name = std::string("contact angle") + (dim == 3 ? " 3D" : "") +
                             (slab > 0. ? " on a rigid slab" : "") + ", " + to_text(angle) +
                             " degrees";
    cases.push_back({name, [=]() -> std::vector<LimitRow> {
                       const SessileDrop drop = sessile_drop(run);
                       return {{name + ", error [degrees]",
                                std::abs(drop.angle - angle),
                                dim == 3 || run.slab > 0. ? 5. : 3.},
                               {name + ", particles lost", static_cast<double>(drop.n_lost), 0.},
                               {name + ", least [degrees]", drop.least},
                               {name + ", largest [degrees]", drop.largest}};
                     }});
  }

  void
  run_program(const std::vector<std::string> &arguments)
  {
    bool csv = false, is_long = false;
    std::string only;
    benchmarks::CommandLine options("surface_tension");
    options.add_switch("--csv", csv);
    options.add_switch("--long", is_long);
    options.add("--only", [&only](const std::string &value) { only = value; });
    options.read(arguments);

    std::vector<LimitCase> cases;
    add_drops(cases, is_long);
    DropRun coarse, fine, round;
    fine.cells = 16;
    round.dim  = 3;
    add_oscillating(cases, coarse, 0.015);
    add_moved(cases, coarse);
    add_wave(cases, 32, 0.03);
    for (const double angle : {30., 45., 60., 90., 120., 135., 150.})
      if (is_long || (angle != 45. && angle != 90. && angle != 135.))
        add_sessile(cases, 2, angle);
    add_sessile(cases, 3, 60.);
    for (const double angle : {30., 60., 90., 120., 150.})
      add_sessile(cases, 2, angle, 3.37); // its surface between nodes
    if (is_long)
      {
        add_wave(cases, 64, 0.015);
        add_sessile(cases, 3, 120.);
        add_oscillating(cases, fine, 0.007);
        add_oscillating(cases, round, 0.03);
        add_moved(cases, round);
      }
    benchmarks::print_limit_rows(cases, only, csv);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(parallel::report_errors(MPI_COMM_WORLD, std::cerr, [&]() {
    run_program({argv + 1, argv + argc});
  }));
}
