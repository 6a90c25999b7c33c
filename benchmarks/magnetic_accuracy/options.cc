#include <magnetic_accuracy/options.h>
#include <shared/command_line.h>

#include <algorithm>

namespace magmpm::benchmarks
{
  bool
  Options::wants(const std::string &group) const
  {
    return groups.empty() || std::find(groups.begin(), groups.end(), group) != groups.end();
  }

  Options
  parse_options(const std::vector<std::string> &arguments, const std::vector<std::string> &groups)
  {
    Options options;
    CommandLine line("magnetic_accuracy");
    line.add_switch("--csv", options.csv);
    line.add_switch("--check", options.check);
    line.add_switch("--help", options.help);
    line.add_number("--max-resolution", options.max_resolution);
    line.add("--only", [&](const std::string &value) {
      for (const std::string &name : split(value))
        options.groups.push_back(one_of("--only", name, groups));
    });
    line.add("--dimension", [&](const std::string &value) {
      options.dimensions = {std::stoi(one_of("--dimension", value, {"2", "3"}))};
    });
    line.add("--offsets", [&](const std::string &value) {
      options.max_offsets =
        static_cast<unsigned int>(std::max(1., positive_number("--offsets", value)));
    });
    line.add("--indicator", [&](const std::string &value) {
      const bool sharp  = one_of("--indicator", value, {"sharp", "smeared"}) == "sharp";
      options.indicator = (sharp ? MaterialIndicator::sharp : MaterialIndicator::smeared);
    });
    line.add("--cell-edge", [&](const std::string &value) {
      options.cell_edge = std::stoi(one_of("--cell-edge", value, {"1", "2"}));
    });
    line.read(arguments);
    return options;
  }

  std::string
  usage(const std::vector<std::string> &groups)
  {
    return R"(magnetic_accuracy [option]...

Compares the magnetic part of magmpm with exact solutions, and prints the relative errors: rms and
largest over random places of the body on the lattice.

  --only GROUP,...             of )" +
           joined(groups) + R"(
  --dimension 2|3              otherwise both
  --max-resolution R/dx        leaves finer cases away; default 16
  --offsets N                  places on the lattice at most; default 8
  --indicator sharp|smeared    how material is told from vacuum; default sharp
  --cell-edge 2|1              of the mesh at material, in dx; default 2
  --csv                        prints lines "name,value,limit" (value: rms) instead of a table
  --check                      exit code 1 if a limit is missed
  --help                       prints this

On several processor cores: mpirun -np 2 magnetic_accuracy
)";
  }
} // namespace magmpm::benchmarks
