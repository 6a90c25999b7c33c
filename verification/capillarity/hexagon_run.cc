#include <magmpm/base/constants.h>

#include <verification/capillarity/hexagon_run.h>
#include <verification/capillarity/particle_file.h>
#include <verification/capillarity/pattern_equilibrium.h>
#include <verification/capillarity/surface_waves.h>
#include <verification/program/parameter_text.h>
#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi         = constants::pi;
    constexpr int per_edge      = 2; ///< particles along an edge of a cell
    constexpr int n_modes       = 8;
    constexpr double short_edge = 16. / 28.; ///< over the longer one
    constexpr double wave_length =
      0.9949; ///< of the area, over the longer edge: sqrt(sqrt(3) 16/28)

    double
    dx_of(const HexagonRun &run)
    {
      return 2. * pi / run.k() / wave_length / run.cells;
    }

    /** The first mode, 1 at the corners with crests, by the waves that fit the cell. */
    double
    pattern(const HexagonRun &run, const std::array<double, 3> &place)
    {
      const double ky = pi / (run.cells * dx_of(run)), kx = ky / short_edge;
      return (std::cos(2. * ky * place[1]) +
              2. * std::cos(kx * place[0]) * std::cos(ky * place[1])) /
             3.;
    }

    std::string
    magnetic_lines(const HexagonRun &run)
    {
      const bool is_linear = run.layer.law == MagnetizationLaw::linear;
      std::string text     = "subsection Magnets\nset List of magnets = coil\nsubsection coil\n"
                             "set Field = 0; 0; " +
                         as_text(run.state().induction() / constants::vacuum_permeability) +
                         "\nend\nend\nsubsection Magnetics\nset Magnetization law = " +
                         (is_linear ? "linear" : "Langevin") +
                         "\nset Newton tolerance = 1e-6\nsubsection Potential box\n";
      for (const char axis : {'x', 'y', 'z'})
        for (const std::string side : {"Lower ", "Upper "})
          text += "set " + side + axis + " = shielded\n";
      return text + "end\nend\n";
    }

    std::string
    material_lines(const FerrofluidLayer &layer)
    {
      std::string text =
        "set Surface tension = " + as_text(layer.surface_tension) +
        "\nset Initial susceptibility = " + as_text(layer.medium.initial_susceptibility) + "\n";
      if (layer.law != MagnetizationLaw::linear)
        text += "set Saturation magnetization = " + as_text(layer.medium.saturation_magnetization) +
                "\n";
      return text;
    }

    /** Runs it; its output folder. @param amplitude  of the first mode at the start [m]. */
    std::string
    run_hexagons(const HexagonRun &run, const double amplitude)
    {
      const FerrofluidLayer boxed = run.boxed_layer();
      const double dx             = dx_of(run);
      const std::string name = "hexagons-" + as_text(run.induction) + "-" + as_text(run.start) +
                               "-" + std::to_string(run.cells);
      ParticleGrid grid;
      grid.dim     = 3;
      grid.spacing = dx / per_edge;
      grid.upper   = {short_edge * run.cells * dx, run.cells * dx, boxed.depth + boxed.height};
      ParameterText scene;
      scene.dim      = 3;
      scene.end_time = as_text(run.duration);
      scene.gravity  = "0, 0, " + as_text(-boxed.gravity);
      scene.box      = as_text(grid.upper[0]) + ", " + as_text(grid.upper[1]) + ", " +
                  as_text(grid.upper[2]);
      scene.cell_size = as_text(dx);
      scene.add_fluid("ferrofluid",
                      as_text(boxed.density * run.sound * run.sound),
                      as_text(boxed.density * boxed.viscosity),
                      material_lines(boxed));
      const std::string file = write_particles(name, grid, [&](const std::array<double, 3> &place) {
        return place[2] < boxed.depth + amplitude * pattern(run, place);
      });
      scene.add_body("layer",
                     "ferrofluid",
                     as_text(boxed.density),
                     "set Shape = points\nset File = " + file +
                       "\nset Particles per edge = " + std::to_string(per_edge) + "\n");
      scene.rest = "set Checkpoint every = never\n" + walls(3, "slip") + magnetic_lines(run) +
                   "subsection Rest\nset Damping rate = " + as_text(run.damping) +
                   "\nend\nsubsection Output\nset Particle quantities = J\nset Fields = false\n"
                   "set Statistics every = 100\nset Frame interval = " +
                   as_text(run.duration / 50.) + "\nend\n";
      return run_scene(name, scene.text());
    }
  } // namespace

  double
  HexagonRun::k() const
  {
    return wave_number * layer.capillary_wave_number();
  }

  FerrofluidLayer
  HexagonRun::boxed_layer() const
  {
    FerrofluidLayer boxed = layer;
    const double edge     = 2. * pi / k() / wave_length;
    boxed.depth           = 0.5 * edge;
    boxed.height          = 1.5 * edge;
    boxed.faces           = FieldFaces::shielded;
    return boxed;
  }

  LayerField
  HexagonRun::state() const
  {
    const FerrofluidLayer boxed = boxed_layer();
    return field_of_induction(boxed, induction * critical_state(boxed).state.induction());
  }

  HexagonHeights
  hexagon_heights(const HexagonRun &run)
  {
    const FerrofluidLayer boxed = run.boxed_layer();
    const PatternEnergy energy(boxed, run.state(), run.k(), Pattern::hexagons, n_modes);
    std::vector<double> tall(n_modes, 0.);
    tall[0]                  = 1.5;
    tall[1]                  = 0.25;
    tall[2]                  = 0.14;
    const PatternShape shape = pattern_equilibrium(energy, tall, run.k());
    HexagonHeights heights   = {0., shape.modes[0] / run.k(), shape.crest, 0., 0.};
    const auto frames        = particle_frames(run_hexagons(run, run.start * shape.crest));
    const double volume      = std::pow(dx_of(run) / per_edge, 3);
    const double area        = short_edge * std::pow(run.cells * dx_of(run), 2);
    const std::size_t half = frames.size() / 2, last = frames.size() * 4 / 5;
    double least = 1e300, largest = -1e300;
    for (std::size_t i = half; i < frames.size(); ++i)
      {
        double sum = 0.;
        for (const auto &place : frames[i].positions)
          {
            // The mean of the square of the mode is 1/6.
            sum += 6. * volume / area * pattern(run, place);
            heights.highest = std::max(heights.highest, place[2] - boxed.depth);
          }
        heights.first_mode += sum / static_cast<double>(frames.size() - half);
        if (i >= last)
          {
            least   = std::min(least, sum);
            largest = std::max(largest, sum);
          }
      }
    heights.change = largest - least;
    return heights;
  }
} // namespace magmpm::verification
