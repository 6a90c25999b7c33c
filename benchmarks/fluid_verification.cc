// Fluids against what is known of them: at rest, in waves, when they collapse and fall, and what floats.
//
//   fluid_verification [--csv] [--only NAME]
//
// A row is met if its value is at most its limit. --only runs the rows whose names begin so.

#include <magmpm/base/number_text.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <shared/command_line.h>
#include <shared/limit_rows.h>
#include <verification/mechanics/dam_break.h>
#include <verification/mechanics/elastic_bar.h>
#include <verification/mechanics/floating_body.h>
#include <verification/mechanics/fluid_motion.h>
#include <verification/mechanics/hydrostatic_column.h>
#include <verification/mechanics/hydrostatic_start.h>
#include <verification/mechanics/standing_wave.h>

#include <algorithm>
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
  constexpr double rounding = 1e-11;

  LimitCase
  at_rest(const std::string &name,
          const int cells,
          const int dim,
          const ColumnFloor floor,
          const double limit)
  {
    return {name, [=]() -> std::vector<LimitRow> {
              const HydrostaticErrors errors = hydrostatic_errors(cells, dim, floor);
              return {{name + ", pressure inside", errors.inside, limit},
                      {name + ", pressure at the floor", std::abs(errors.floor_cell), limit}};
            }};
  }

  void
  add_columns(std::vector<LimitCase> &cases)
  {
    for (const int cells : {8, 16, 32})
      cases.push_back(
        at_rest("column, H/" + std::to_string(cells), cells, 2, ColumnFloor::wall, 0.005));
    cases.push_back(at_rest("column 3D, H/8", 8, 3, ColumnFloor::wall, 0.005));
    cases.push_back(at_rest("column on an elastic slab", 16, 2, ColumnFloor::elastic_slab, 0.01));
    cases.push_back(
      at_rest("column on a slab of its own group", 16, 2, ColumnFloor::separate_slab, 0.01));
    cases.push_back(
      {"elastic bar", []() -> std::vector<LimitRow> {
         return {{"elastic bar, L/16, frequency", std::abs(frequency_error(16)), 0.002}};
       }});
  }

  void
  add_starts(std::vector<LimitCase> &cases)
  {
    const auto add = [&](const std::string &name, const HydrostaticPool &pool) {
      cases.push_back({name, [=]() -> std::vector<LimitRow> {
                         return {{name + ", rms |v|/c", hydrostatic_unrest(pool), 1e-4}};
                       }});
    };
    for (const int cells : {8, 16, 32})
      add("hydrostatic start, H/" + std::to_string(cells), {2, cells});
    add("hydrostatic start 3D, H/16", {3});
    add("hydrostatic start, walls that separate", {2, 16, 0.05, "separate"});
    add("hydrostatic start, oil on water", {2, 16, 0.05, "slip", true});
  }

  void
  add_walls(std::vector<LimitCase> &cases)
  {
    cases.push_back({"held", []() -> std::vector<LimitRow> {
                       return {{"held particles, slosh", held_in_slosh(), 0.},
                               {"held particles, jets 2D", held_jets(2), 0.},
                               {"held particles, jets 3D", held_jets(3), 0.}};
                     }});
  }

  void
  add_waves(std::vector<LimitCase> &cases)
  {
    for (const int cells : {32, 64})
      {
        const std::string name = "standing wave, " + std::to_string(cells) + " cells";
        cases.push_back(
          {name, [name, cells]() -> std::vector<LimitRow> {
             const StandingWave wave = standing_wave(cells);
             const bool is_fine      = cells == 64;
             return {{name + ", omega", std::abs(wave.frequency), is_fine ? 0.004 : 0.008},
                     {name + ", decay a period", std::abs(wave.decay), is_fine ? 0.004 : 0.015},
                     {name + ", misfit", wave.misfit, 0.005},
                     {name + ", amplitude [dx]", wave.amplitude * cells}};
           }});
      }
  }

  std::vector<LimitRow>
  fronts_of(const int cells, const double limit)
  {
    std::vector<LimitRow> rows;
    for (const DamFront &front : dam_fronts(cells))
      {
        const std::string name = "dam break, a/" + std::to_string(cells) +
                                 ", T = " + to_text(front.time);
        rows.push_back({name + ", front against boundary elements",
                        std::abs(front.simulated / front.inviscid - 1.),
                        limit});
        rows.push_back(
          {name + ", experiment against boundary elements", front.measured / front.inviscid - 1.});
      }
    return rows;
  }

  LimitCase
  floating(const std::string &name, const FloatingBody &body, const double limit)
  {
    return {name, [=]() -> std::vector<LimitRow> {
              const FloatingErrors errors = floating_errors(body);
              std::vector<LimitRow> rows  = {
                 {name + ", height [dx]", std::abs(errors.height), limit},
                 {name + ", swing [dx]", errors.swing}};
              if (body.kind == FloaterKind::rigid && !body.is_round)
                rows.push_back({name + ", turn [rad]", errors.turn});
              return rows;
            }};
  }

  void
  add_floats(std::vector<LimitCase> &cases)
  {
    constexpr auto rigid = FloaterKind::rigid;
    for (const double density : {250., 500., 750.})
      cases.push_back(floating(
        "float, disc, density " + to_text(density / 1000.), {2, rigid, true, density}, 0.2));
    cases.push_back(floating("float, box, density 0.25", {2, rigid, false, 250.}, 0.2));
    cases.push_back(floating("float, box, density 0.5", {2, rigid, false, 500.}, 0.4));
    constexpr auto elastic = FloaterKind::elastic;
    cases.push_back(floating("float, elastic block, density 0.5", {2, elastic, false, 500.}, 0.3));
    for (const double density : {250., 500., 750.})
      cases.push_back(
        floating("float, elastic block in group 1, density " + to_text(density / 1000.),
                 {2, elastic, false, density, 1},
                 0.3));
    cases.push_back(
      floating("float, elastic disc in group 1, density 0.5", {2, elastic, true, 500., 1}, 0.3));
    cases.push_back(floating("float 3D, ball, density 0.5", {3, rigid, true, 500.}, 0.3));
    cases.push_back(floating("float 3D, box, density 0.5", {3, rigid, false, 500.}, 0.3));
  }

  void
  add_motion(std::vector<LimitCase> &cases)
  {
    cases.push_back({"stirred pool", []() -> std::vector<LimitRow> {
                       return {{"stirred pool, momentum of fluid, block and paddle",
                                momentum_change_of_stirred_pool(),
                                rounding}};
                     }});
    cases.push_back({"drops", []() -> std::vector<LimitRow> {
                       const MergingDrops drops = merging_drops();
                       return {{"drops, momentum", drops.momentum, rounding},
                               {"drops, path [dx]", std::abs(drops.path), 0.1},
                               {"drops, rise of the energy", drops.energy_rise, 0.003}};
                     }});
  }

  void
  run_program(const std::vector<std::string> &arguments)
  {
    bool csv = false;
    std::string only;
    benchmarks::CommandLine options("fluid_verification");
    options.add_switch("--csv", csv);
    options.add("--only", [&only](const std::string &value) { only = value; });
    options.read(arguments);

    std::vector<LimitCase> cases;
    add_columns(cases);
    add_starts(cases);
    add_walls(cases);
    add_motion(cases);
    add_waves(cases);
    cases.push_back({"dam break, a/16", [] { return fronts_of(16, 0.03); }});
    cases.push_back({"dam break, a/32", [] { return fronts_of(32, 0.01); }});
    add_floats(cases);
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
