// Ferrofluid with surface tension in a uniform field: waves and spikes of a layer, the shape of a drop.
//
//   spikes [--csv] [--long] [--only NAME]
//
// A row is met if its value is at most its limit. --only runs the rows whose names begin so; --long those that take
// minutes each too.

#include <magmpm/base/number_text.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <shared/command_line.h>
#include <shared/limit_rows.h>
#include <verification/capillarity/hexagon_run.h>
#include <verification/capillarity/layer_runs.h>
#include <verification/capillarity/magnetic_drop_run.h>
#include <verification/capillarity/magnetic_drop_shape.h>
#include <verification/capillarity/noise_growth.h>
#include <verification/capillarity/pattern_equilibrium.h>
#include <verification/capillarity/spike_equilibrium.h>
#include <verification/capillarity/surface_waves.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace magmpm;
using namespace magmpm::verification;
using benchmarks::LimitCase;
using benchmarks::LimitRow;

namespace
{
  constexpr double no_limit = std::numeric_limits<double>::infinity();

  /** Of the scene of the waves, M [M_c]. */
  LayerRun
  wave_at(const double magnetization, const double wave_number = 1.)
  {
    LayerRun run;
    run.magnetization   = magnetization;
    run.wave_number     = wave_number;
    run.layer.viscosity = 1e-6;
    run.steepness       = 0.2;
    return run;
  }

  void
  add_growth(std::vector<LimitCase> &cases, const LayerRun &run, const double limit)
  {
    const std::string name = "wave, M " + to_text(run.magnetization) + " M_c, k " +
                             to_text(run.wave_number) + " k_c, " + std::to_string(run.cells) +
                             " cells";
    cases.push_back(
      {name, [=]() -> std::vector<LimitRow> {
         const LayerGrowth growth = layer_growth(run);
         const bool grows         = growth.exact > 0.;
         return {{name + (grows ? ", rate" : ", omega"), std::abs(growth.error()), limit},
                 {name + ", exact [1/s]", std::sqrt(std::abs(growth.exact))},
                 {name + ", misfit", growth.misfit},
                 {name + ", largest steepness", growth.steepness}};
       }});
  }

  /** Where a straight line through s^2 against M^2 crosses zero, in M_c, less 1. */
  std::vector<LimitRow>
  critical_row()
  {
    double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
    for (const double m : {0.8, 0.9, 1.2, 1.3})
      {
        const double square = layer_growth(wave_at(m)).rate_square;
        n += 1.;
        x += m * m;
        y += square;
        xx += m * m * m * m;
        xy += m * m * square;
      }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    const double zero  = (x - y / slope) / n;
    return {{"critical magnetization, by s^2(M^2) [M_c]", std::abs(std::sqrt(zero) - 1.), 0.02}};
  }

  /** Below the critical field what a push has raised only falls. */
  std::vector<LimitRow>
  quiet_rows()
  {
    LayerRun run = wave_at(0.95);
    run.duration = 0.5;
    return {
      {"no growth at 0.95 M_c, late over early amplitude", layer_growth(run).late_over_early, 1.}};
  }

  /** Boxes of so many waves: which one comes out of the noise. */
  LimitCase
  from_noise(const double magnetization, const double waves, const int cells)
  {
    LayerRun run           = wave_at(magnetization);
    run.cells              = cells;
    run.depth_cells        = cells / 2;
    run.height_cells       = cells / 2;
    run.jitter             = 0.5;
    run.layer.viscosity    = 4e-6;
    run.waves              = waves;
    const std::string name = "from noise, M " + to_text(magnetization) + " M_c, " + to_text(waves) +
                             " waves, " + std::to_string(cells) + " cells";
    return {name, [=]() -> std::vector<LimitRow> {
              const NoiseGrowth growth = noise_growth(run);
              return {
                {name + ", wave number", std::abs(growth.wave_number / growth.exact - 1.), 0.1},
                {name + ", exact [k_c]", growth.exact / run.layer.capillary_wave_number()},
                {name + ", measured [k_c]", growth.wave_number / run.layer.capillary_wave_number()},
                {name + ", steepness", growth.steepness}};
            }};
  }

  /** Of a layer half a wave deep with a ceiling one and a half above, by M over that of a deep one; without magmpm. */
  std::vector<LimitRow>
  exact_spikes()
  {
    LayerRun run;
    run.height_cells            = 3 * run.depth_cells;
    const FerrofluidLayer layer = run.boxed_layer();
    const double critical       = critical_state(FerrofluidLayer()).state.magnetization;
    std::vector<LimitRow> rows;
    for (const double m : {1.02, 1.05, 1.1, 1.2})
      rows.push_back(
        {"least energy of spikes, M " + to_text(m) + " M_c of a deep layer, first mode [mm]",
         1e3 * spike_equilibrium(layer, field_of_magnetization(layer, m * critical), run.k())
                 .modes[0]});
    return rows;
  }

  LayerRun
  spikes_at(const double magnetization)
  {
    LayerRun run;
    run.magnetization      = magnetization;
    run.cells              = 24;
    run.depth_cells        = 12;
    run.height_cells       = 36;
    run.particles_per_edge = 4;
    run.layer.viscosity    = 4e-6;
    run.damping            = 20.;
    run.duration           = 0.4;
    run.steepness          = 0.2;
    return run;
  }

  void
  add_spikes(std::vector<LimitCase> &cases, const LayerRun &run, const bool is_tall)
  {
    const std::string name = "spikes, M " + to_text(run.magnetization) + " M_c, " +
                             std::to_string(run.cells) + " cells, " + to_text(run.duration) + " s" +
                             (run.damping > 0. ? ", damped" : "");
    cases.push_back(
      {name, [=]() -> std::vector<LimitRow> {
         const LayerSpikes spikes = layer_spikes(run);
         return {{name + ", first mode", std::abs(spikes.first_mode / spikes.exact - 1.), 0.04},
                 {name + ", first mode [mm]", 1e3 * spikes.first_mode},
                 {name + ", least energy [mm]", 1e3 * spikes.exact},
                 {name + ", change in the last fifth", spikes.change, 0.05},
                 {name + ", particles 1 mm above the crest", spikes.n_flying},
                 {name + ", highest particle over the crest [mm]",
                  1e3 * std::max(spikes.highest - spikes.crest, 0.),
                  is_tall ? 1. : no_limit}};
       }});
  }

  LimitCase
  magnetic_drop(const int dim, const double chi, const double aspect, const int cells = 8)
  {
    MagneticDropRun run;
    run.drop               = {dim, chi};
    run.bond_number        = bond_number_of_aspect(run.drop, aspect);
    run.cells              = cells;
    const std::string name = std::string("magnetic drop") + (dim == 3 ? " 3D" : "") + ", chi " +
                             to_text(chi) + ", spheroid of " + to_text(aspect) + ", R/" +
                             std::to_string(cells);
    return {name, [=]() -> std::vector<LimitRow> {
              const double free = magnetic_drop_shape(run.drop, run.bond_number).moment_aspect;
              const MagneticDropAspect shape = magnetic_drop_aspect(run);
              return {
                {name + ", aspect against free shape", std::abs(shape.measured / free - 1.), 0.03},
                {name + ", aspect against spheroid", std::abs(shape.measured / aspect - 1.), 0.05},
                {name + ", Bond number", run.bond_number},
                {name + ", aspect", shape.measured},
                {name + ", change in the last fifth", shape.change},
                {name + ", highest particle [R]", shape.highest},
                {name + ", particles lost", static_cast<double>(shape.n_lost), 0.}};
            }};
  }

  /** Between its jumps a drop of high chi stays as long, or as short, as it was. */
  std::vector<LimitRow>
  hysteresis_rows()
  {
    MagneticDropRun run;
    run.drop                            = {3, 40.};
    const Hysteresis jumps              = *hysteresis(run.drop);
    run.bond_number                     = 0.5 * (jumps.bond_up + jumps.bond_down);
    run.room                            = 5.;
    const MagneticDropAspect from_short = magnetic_drop_aspect(run);
    run.start_aspect                    = jumps.aspect_down;
    const MagneticDropAspect from_long  = magnetic_drop_aspect(run);
    const double exact                  = spheroid_aspect(run.drop, run.bond_number);
    const std::string name              = "hysteresis 3D, chi 40, ";
    return {
      {name + "short, aspect against spheroid", std::abs(from_short.measured / exact - 1.), 0.05},
      {name + "aspect of long spheroids that fall, over that of the long drop",
       jumps.aspect_down / from_long.measured,
       1.},
      {name + "aspect of the short one", from_short.measured},
      {name + "aspect of the long one", from_long.measured},
      {name + "particles that the short one lost", static_cast<double>(from_short.n_lost), 0.},
      {name + "particles that the long one lost", static_cast<double>(from_long.n_lost), 0.}};
  }

  /** Crests of the hexagons of least energy with the field falling, without magmpm. */
  std::vector<LimitRow>
  exact_hexagons(const double susceptibility)
  {
    HexagonRun run;
    run.layer.medium.initial_susceptibility = susceptibility;
    const FerrofluidLayer layer             = run.boxed_layer();
    std::vector<double> modes               = {1.5, 0.25, 0.14, 0., 0., 0., 0., 0.};
    std::vector<LimitRow> rows;
    for (const double b : {1.1, 1.05, 1.02, 1., 0.99, 0.98, 0.97, 0.96, 0.95, 0.94, 0.93, 0.92})
      {
        run.induction = b;
        const PatternEnergy energy(layer, run.state(), run.k(), Pattern::hexagons, 8);
        const PatternShape shape = pattern_equilibrium(energy, modes, run.k());
        modes                    = shape.modes;
        rows.push_back({"least energy of hexagons, chi " + to_text(susceptibility) + ", B " +
                          to_text(b) + " B_c, crest [mm]",
                        1e3 * shape.crest});
        if (shape.crest < 1e-5)
          break;
      }
    return rows;
  }

  /** A pattern that began tall, or flat, against the hexagons of least energy, or none. */
  LimitCase
  hexagons(const double induction, const bool is_tall)
  {
    HexagonRun run;
    run.induction          = induction;
    run.start              = is_tall ? 0.8 : 0.;
    run.layer.viscosity    = 4e-6;
    const std::string name = "hexagons 3D, B " + to_text(induction) + " B_c, from " +
                             (is_tall ? "tall ones" : "a flat layer");
    return {
      name, [=]() -> std::vector<LimitRow> {
        const HexagonHeights found = hexagon_heights(run);
        const double exact         = is_tall ? found.exact : 0.;
        std::vector<LimitRow> rows = {{name + ", first mode [mm]", 1e3 * found.first_mode},
                                      {name + ", of least energy [mm]", 1e3 * exact},
                                      {name + ", change in the last fifth [mm]",
                                       1e3 * found.change},
                                      {name + ", highest particle over the crest [mm]",
                                       1e3 * std::max(found.highest - found.crest, 0.)}};
        const bool stands          = exact > 1e-5; // as low as the minimum is known
        rows.insert(
          rows.begin(),
          stands
            ? LimitRow{name + ", first mode", std::abs(found.first_mode / exact - 1.), 0.04}
            : LimitRow{name + ", flat, first mode [mm]", 1e3 * std::abs(found.first_mode), 0.2});
        return rows;
      }};
  }

  void
  run_program(const std::vector<std::string> &arguments)
  {
    bool csv = false, is_long = false;
    std::string only;
    benchmarks::CommandLine options("spikes");
    options.add_switch("--csv", csv);
    options.add_switch("--long", is_long);
    options.add("--only", [&only](const std::string &value) { only = value; });
    options.read(arguments);

    std::vector<LimitCase> cases;
    for (const double m : {0.9, 1.2, 1.3})
      add_growth(cases, wave_at(m), m < 1. ? no_limit : 0.05);
    cases.push_back({"critical magnetization", critical_row});
    cases.push_back({"no growth at 0.95 M_c", quiet_rows});
    cases.push_back({"least energy of spikes", exact_spikes});
    for (const double waves : {5., 7.})
      for (const int cells : {24, 48})
        if (is_long || cells == 24)
          cases.push_back(from_noise(1.1, waves, cells));
    for (const double m : {1.05, 1.1, 1.2})
      add_spikes(cases, spikes_at(m), true);
    for (const double aspect : {1.5, 2., 3.})
      cases.push_back(magnetic_drop(2, 1., aspect));
    cases.push_back(magnetic_drop(3, 2., 2.));
    if (is_long)
      {
        for (const double chi : {0.5, 1., 2.})
          for (const double aspect : {1.2, 1.5, 2., 3.})
            if (chi < 2. || aspect != 2.)
              cases.push_back(magnetic_drop(3, chi, aspect));
        cases.push_back({"hysteresis 3D", hysteresis_rows});
        for (const double b : {1.1, 1.05, 0.995, 0.95})
          cases.push_back(hexagons(b, true));
        cases.push_back(hexagons(0.97, false));
        for (const double chi : {1., 2.})
          cases.push_back({"least energy of hexagons, chi " + to_text(chi),
                           [chi] { return exact_hexagons(chi); }});
        for (const double k : {0.5, 2.})
          add_growth(cases, wave_at(1.3, k), 0.05);
        LayerRun fine     = wave_at(1.3, 2.);
        fine.cells        = 64;
        fine.depth_cells  = 32;
        fine.height_cells = 32;
        add_growth(cases, fine, 0.05);
        for (const double m : {1.05, 1.1, 1.2})
          {
            LayerRun run = spikes_at(m);
            run.duration = 1.;
            if (m < 1.2)
              run.damping = 0.;
            add_spikes(cases, run, true);
          }
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
