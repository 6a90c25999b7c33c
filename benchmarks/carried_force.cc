#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>
#include <magmpm/parameters/parameter_file.h>

#include <deal.II/base/mpi.h>

#include <verification/mechanics/carried_force_errors.h>
#include <verification/program/paths.h>

#include <cstdio>
#include <iostream>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** A soft bar that flies past a magnet, over 10 dx, and turns. */
  constexpr const char *flying_bar = R"(
set Dimension = 2
set End time  = 1
set Gravity   = 0, 0
subsection Box
  set Upper corner = 0.48, 0.24
  set Cell size    = 0.01
end
subsection Bodies
  set List of bodies = bar
  subsection bar
    set Material         = elastomer
    set Lower corner     = 0.083, 0.103
    set Upper corner     = 0.163, 0.143
    set Density          = 1000
    set Velocity         = 4, 0
    set Angular velocity = 12
  end
end
subsection Materials
  set List of materials = elastomer
  subsection elastomer
    set Young's modulus          = 1e6
    set Poisson ratio            = 0.3
    set Saturation magnetization = 8e4
    set Initial susceptibility   = 0.9
  end
end
subsection Magnets
  set List of magnets = ball
  subsection ball
    set Type          = magnetized sphere
    set Position      = 0.24; 0.03
    set Radius        = 0.03
    set Magnetization = 0; 1e6
  end
end
)";

  /** A block between a floor and a plate that comes down on it, above a magnet. */
  constexpr const char *squeezed_block = R"(
set Dimension = 2
set End time  = 1
set Gravity   = 0, 0
subsection Box
  set Upper corner = 0.32, 0.32
  set Cell size    = 0.01
end
subsection Bodies
  set List of bodies = block
  subsection block
    set Material     = elastomer
    set Lower corner = 0.11, 0.10
    set Upper corner = 0.21, 0.20
    set Density      = 1000
  end
end
subsection Materials
  set List of materials = elastomer
  subsection elastomer
    set Young's modulus          = 1e5
    set Poisson ratio            = 0.3
    set Saturation magnetization = 8e4
    set Initial susceptibility   = 0.9
  end
end
subsection Magnets
  set List of magnets = slab
  subsection slab
    set Type          = cuboid
    set Position      = 0.16; 0.06
    set Size          = 0.2, 0.08
    set Magnetization = 0; 5e5
  end
end
subsection Rigid bodies
  set List of rigid bodies = plate
  subsection plate
    set Motion       = scripted
    set Shape        = box
    set Lower corner = 0.06, 0.20
    set Upper corner = 0.26, 0.24
    set Position     = 0.16; if(t < 0.05, 0.22 - 0.6*t, 0.19)
  end
end
)";

  void
  print(const std::string &name, const CarriedForceErrors &errors)
  {
    std::printf("| %s | %u | %u |", name.c_str(), errors.n_steps, errors.n_solves);
    for (const auto &measure : {errors.force, errors.torque, errors.virial})
      std::printf(" %.2f, %.2f %% |", 100. * measure.worst, 100. * measure.rms);
    std::printf("\n");
    std::fflush(stdout);
  }

  template <int dim>
  void
  measure(const std::string &name,
          const ParameterFile &file,
          const double end_time,
          const unsigned int interval)
  {
    print(name, carried_force_errors(read_parameters<dim>(file), end_time, interval));
  }

  void
  run_program()
  {
    const std::string scenes = source_folder() + "/parameter_files/";
    std::cout << version_string()
              << "\nThe carried magnetic force against a solve in the same step: largest and rms.\n"
                 "| scene | steps | solves | force | torque | virial |\n|---|---|---|---|---|---|"
              << std::endl;
    measure<2>(
      "bar that flies past a magnet", parse_parameter_text(flying_bar, "bar.prm"), 0.06, 5);
    measure<2>(
      "block that is squeezed", parse_parameter_text(squeezed_block, "block.prm"), 0.06, 5);
    measure<2>("layer of ferrofluid", read_parameter_file(scenes + "ferrofluid_2d.prm"), 0.1, 20);
    const std::vector<std::string> coarse = {"Box/Cell size=0.03125"};
    measure<3>("cube that comes near a ball",
               read_parameter_file(scenes + "cube_nonlinear.prm", coarse),
               0.115,
               4);
    measure<3>("the same until after the impact",
               read_parameter_file(scenes + "cube_nonlinear.prm", coarse),
               0.17,
               4);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(parallel::report_errors(MPI_COMM_SELF, std::cerr, run_program));
}
