#include <magmpm/base/constants.h>

#include <verification/capillarity/layer_scene.h>
#include <verification/capillarity/surface_waves.h>
#include <verification/program/parameter_text.h>
#include <verification/program/program_run.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi = constants::pi;

    double
    dx_of(const LayerRun &run)
    {
      return 2. * pi / run.k() / run.cells;
    }

    std::string
    magnetic_lines(const LayerRun &run)
    {
      if (run.magnetization == 0.)
        return "";
      std::string text = "subsection Magnets\nset List of magnets = coil\nsubsection coil\n"
                         "set Field = 0; " +
                         as_text(run.state().induction() / constants::vacuum_permeability) +
                         "\nend\nend\nsubsection Magnetics\nset Magnetization law = linear\n"
                         "set Newton tolerance = 1e-6\nsubsection Potential box\n";
      for (const std::string face : {"Lower x", "Upper x", "Lower y", "Upper y"})
        text += "set " + face + " = shielded\n";
      return text + "end\nend\n";
    }
  } // namespace

  std::string
  layer_scene(const LayerRun &run, const std::string &lean, const double end, const int n_frames)
  {
    const double dx              = dx_of(run);
    const FerrofluidLayer &layer = run.layer;
    ParameterText text;
    text.end_time = as_text(end);
    text.gravity  = lean + "; " + as_text(-layer.gravity);
    text.box      = as_text(run.waves * run.cells * dx) + ", " +
               as_text((run.depth_cells + run.height_cells) * dx);
    text.cell_size = as_text(dx);
    text.add_fluid("ferrofluid",
                   as_text(layer.density * run.sound * run.sound),
                   as_text(layer.density * layer.viscosity),
                   "set Surface tension = " + as_text(layer.surface_tension) + "\n" +
                     (run.magnetization > 0. ? "set Initial susceptibility = " +
                                                 as_text(layer.medium.initial_susceptibility) + "\n"
                                             : ""));
    text.add_body(
      "layer",
      "ferrofluid",
      as_text(layer.density),
      "set Lower corner = 0, 0\nset Upper corner = " + as_text(run.waves * run.cells * dx) + ", " +
        as_text(run.depth_cells * dx) +
        "\nset Initial state = hydrostatic\nset Particles per edge = " +
        std::to_string(run.particles_per_edge) + "\nset Jitter = " + as_text(run.jitter) + "\n");
    text.rest = "set Checkpoint every = never\n" + walls(2, "slip") + magnetic_lines(run) +
                (run.damping > 0.
                   ? "subsection Rest\nset Damping rate = " + as_text(run.damping) + "\nend\n"
                   : "") +
                "subsection Output\nset Particle quantities = J\nset Fields = false\n"
                "set Statistics every = 1000\nset Frame interval = " +
                as_text(end / n_frames) + "\nend\n";
    return text.text();
  }

  double
  mode_amplitude(const LayerRun &run, const ParticleFrame &frame, const double k)
  {
    double sum = 0.;
    for (const auto &place : frame.positions)
      sum += std::cos(k * place[0]);
    return 2. * run.boxed_layer().depth * sum / static_cast<double>(frame.size());
  }

  double
  LayerRun::k() const
  {
    return wave_number * layer.capillary_wave_number();
  }

  FerrofluidLayer
  LayerRun::boxed_layer() const
  {
    FerrofluidLayer boxed = layer;
    const double dx       = 2. * pi / k() / cells;
    boxed.depth           = depth_cells * dx;
    boxed.height          = height_cells * dx;
    boxed.floor           = Floor::slip;
    boxed.faces           = FieldFaces::shielded;
    return boxed;
  }

  LayerField
  LayerRun::state() const
  {
    const FerrofluidLayer boxed = boxed_layer();
    return field_of_magnetization(boxed, magnetization * critical_state(boxed).state.magnetization);
  }
} // namespace magmpm::verification
