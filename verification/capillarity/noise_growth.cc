#include <magmpm/base/constants.h>

#include <verification/capillarity/noise_growth.h>
#include <verification/capillarity/surface_waves.h>
#include <verification/program/program_run.h>

#include <cmath>
#include <string>

namespace magmpm::verification
{
  namespace
  {
    /** The wave that grows fastest in the box, of which the depth goes with the wave. */
    double
    fastest(LayerRun &run)
    {
      for (int i = 0; i < 10; ++i)
        run.wave_number = fastest_wave(run.boxed_layer(), run.state()).wave_number /
                          run.layer.capillary_wave_number();
      return run.k();
    }

    /** Over the modes that grow: the noise of short ones has no wave in it. */
    void
    measure(const LayerRun &run, const ParticleFrame &frame, NoiseGrowth &growth)
    {
      const double step = 0.5 * run.k() / run.waves; // of the modes of the box
      double squares = 0., moment = 0.;
      const FerrofluidLayer layer = run.boxed_layer();
      const LayerField state      = run.state();
      for (int m = 1; m * step < 3. * run.k(); ++m)
        {
          if (stiffness(layer, state, m * step) > 0.)
            continue;
          const double square = std::pow(mode_amplitude(run, frame, m * step), 2);
          squares += square;
          moment += square * m * step;
        }
      growth.wave_number = moment / squares;
      growth.steepness   = run.k() * std::sqrt(squares);
      growth.time        = frame.time;
    }
  } // namespace

  NoiseGrowth
  noise_growth(LayerRun run)
  {
    NoiseGrowth growth     = {0., fastest(run), 0., 0.};
    const double rate      = fastest_wave(run.boxed_layer(), run.state()).rate;
    const double end       = run.duration > 0. ? run.duration : 6. / rate;
    const std::string name = "noise-growth-" + as_text(run.magnetization) + "-" +
                             as_text(run.waves);
    for (const ParticleFrame &frame :
         particle_frames(run_scene(name, layer_scene(run, "0", end, 60))))
      if (growth.steepness < 0.2)
        measure(run, frame, growth);
    return growth;
  }
} // namespace magmpm::verification
