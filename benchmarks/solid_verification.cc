// Elastic solids against what is known of them: how they bend, swing, spin, and what the transfer loses.
//
//   solid_verification [--csv] [--only NAME] [--apic]
//
// A row is met if its value is at most its limit. --only runs the rows whose names begin so, --apic all of
// them with the transfer APIC, for comparison.

#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <verification/mechanics/cantilever.h>
#include <verification/mechanics/free_beam.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  struct Value
  {
    std::string name;
    double value, limit;
  };

  void
  print(const Value &value, const bool csv)
  {
    if (csv)
      std::cout << '"' << value.name << "\"," << value.value << ',' << value.limit << std::endl;
    else
      {
        std::printf("%-60s %10.4g  limit %8.4g%s\n",
                    value.name.c_str(),
                    value.value,
                    value.limit,
                    value.value <= value.limit ? "" : "  MISSED");
        std::fflush(stdout);
      }
  }

  /** A run that gives one value or several. */
  struct Case
  {
    std::string name;
    std::function<std::vector<Value>()> values;
  };

  Case
  bent_by_weight(const std::string &name, const Cantilever &cantilever)
  {
    return {name, [name, cantilever]() -> std::vector<Value> {
              const CantileverErrors errors = cantilever_errors(cantilever);
              const bool is_heavy           = cantilever.weights > 2.;
              std::vector<Value> values     = {
                    {name + ", sag", std::abs(errors.sag), is_heavy ? 0.015 : 0.03},
                    {name + ", change of the sag", std::abs(errors.change), 0.003}};
              if (is_heavy)
                values.push_back({name + ", reach", std::abs(errors.reach), 0.035});
              return values;
            }};
  }

  void
  add_cantilevers(const Transfer transfer, std::vector<Case> &cases)
  {
    const std::string name_of_transfer = (transfer == Transfer::fmpm ? "FMPM" : "APIC");
    for (const int dim : {2, 3})
      for (const double nu : {0., 0.45})
        for (const double offset : {0., 0.25, 0.31, 0.5})
          {
            Cantilever cantilever;
            cantilever.dim           = dim;
            cantilever.poisson_ratio = nu;
            cantilever.offset        = offset;
            cantilever.transfer      = name_of_transfer;
            cases.push_back(bent_by_weight("cantilever " + std::to_string(dim) + "D, nu " +
                                             to_text(nu) + ", offset " + to_text(offset),
                                           cantilever));
          }
    for (const int dim : {2, 3})
      for (const double offset : {0., 0.31})
        {
          Cantilever heavy;
          heavy.dim      = dim;
          heavy.offset   = offset;
          heavy.weights  = 8.;
          heavy.transfer = name_of_transfer;
          cases.push_back(bent_by_weight("cantilever " + std::to_string(dim) +
                                           "D, 8 weights, offset " + to_text(offset),
                                         heavy));
        }
  }

  void
  add_v_beams(const Transfer transfer, std::vector<Case> &cases)
  {
    FreeBeam two_cells;
    two_cells.transfer = transfer;
    for (const int cells : {2, 4})
      for (const double offset : {0., 0.31})
        for (const double load : {0.3, 1., 3.})
          {
            const std::string name = "V beam, " + std::to_string(cells) + " cells, offset " +
                                     to_text(offset) + ", q " + to_text(load);
            FreeBeam beam = two_cells;
            beam.cells    = cells;
            beam.offset   = offset;
            cases.push_back({name, [name, beam, load]() -> std::vector<Value> {
                               const VBeamErrors errors = v_beam_errors(beam, load, 2., 0.7);
                               return {{name + ", height", std::abs(errors.height), 0.01},
                                       {name + ", reach", std::abs(errors.reach), 0.01},
                                       {name + ", angle of shape and F",
                                        std::abs(errors.angle_of_ends),
                                        load > 2. ? 0.045 : 0.01}};
                             }});
          }
    for (const double load : {1., 3.})
      {
        const std::string name = "V beam swinging, q " + to_text(load);
        cases.push_back({name, [name, load, two_cells]() -> std::vector<Value> {
                           return {{name + ", height",
                                    std::abs(v_beam_errors(two_cells, load, 1., 2.).height),
                                    0.025}};
                         }});
      }
    cases.push_back({"V beam carried over 16 cells", [two_cells]() -> std::vector<Value> {
                       return {{"V beam carried over 16 cells, height",
                                std::abs(v_beam_errors(two_cells, 3., 2., 2., 0.4).height),
                                0.04}};
                     }});
  }

  void
  add_losses(const Transfer transfer, std::vector<Case> &cases)
  {
    FreeBeam beam;
    beam.transfer = transfer;
    cases.push_back({"beam swinging freely", [beam]() -> std::vector<Value> {
                       const EnergyLeft left = energy_of_swinging_beam(beam);
                       return {{"beam swinging freely, energy lost", 1. - left.at_end, 0.1},
                               {"beam swinging freely, energy gained", left.largest - 1., 0.001}};
                     }});
    cases.push_back(
      {"bar", [transfer]() -> std::vector<Value> {
         std::vector<Value> values;
         double least = 1., largest = 0.;
         for (const double factor : {0.4, 0.1, 0.02})
           {
             const double loss = loss_of_bar(transfer, factor);
             least             = std::min(least, loss);
             largest           = std::max(largest, loss);
             values.push_back({"bar, loss a period at factor " + to_text(factor), loss, 0.01});
           }
         values.push_back({"bar, largest loss over least", largest / least, 1.5});
         return values;
       }});
    cases.push_back(
      {"spin", []() -> std::vector<Value> {
         return {
           {"spin 2D, FMPM, angular momentum", change_of_angular_momentum<2>(Transfer::fmpm), 1e-4},
           {"spin 2D, APIC, angular momentum", change_of_angular_momentum<2>(Transfer::apic), 1e-8},
           {"spin 3D, FMPM, angular momentum", change_of_angular_momentum<3>(Transfer::fmpm), 1e-4},
           {"spin 3D, APIC, angular momentum",
            change_of_angular_momentum<3>(Transfer::apic),
            1e-8}};
       }});
  }

  void
  run_program(const std::vector<std::string> &arguments)
  {
    bool csv          = false;
    Transfer transfer = Transfer::fmpm;
    std::string only;
    for (std::size_t i = 0; i < arguments.size(); ++i)
      if (arguments[i] == "--csv")
        csv = true;
      else if (arguments[i] == "--apic")
        transfer = Transfer::apic;
      else if (arguments[i] == "--only" && i + 1 < arguments.size())
        only = arguments[++i];
      else
        throw InputError("'" + arguments[i] +
                         "' is no option of solid_verification: [--csv] [--only NAME] [--apic].");

    std::vector<Case> cases;
    add_cantilevers(transfer, cases);
    add_v_beams(transfer, cases);
    add_losses(transfer, cases);
    if (csv)
      std::cout << "name,value,limit\n";
    else
      std::cout << version_string() << '\n';
    for (const Case &one : cases)
      {
        if (one.name.compare(0, only.size(), only) != 0)
          continue;
        for (const Value &value : one.values())
          print(value, csv);
      }
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
