#pragma once

#include <magmpm/particles/particle_quantities.h>
#include <magmpm/results/frame_series.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  inline const FrameKind particle_frames = {"particles", "particles, frame by frame (ParaView)"};

  /**
   * Writes the particles of a frame for ParaView: one file `particles/particles_<frame>.0.vtu` of
   * all ranks together, a .pvtu beside it, and `particles.pvd`, which lists the frames so far and
   * is what a user opens. Every particle is a vertex cell; quantities (particle_quantities()) are
   * called "name [unit]" and stored in single precision; a vector has three components in 2D too
   * (the third is zero), so that ParaView takes it for one.
   */
  template <int dim>
  class ParticleOutput
  {
  public:
    /**
     * Makes the folder `particles` in @p directory, which must exist. Collective.
     *
     * @param quantities  names of those that are written.
     * @param law         of magnetization.
     * @throw InputError if a name is unknown, RunError if the folder cannot be made.
     */
    ParticleOutput(const MPI_Comm communicator,
                   const std::string &directory,
                   const std::vector<std::string> &quantities,
                   const MagnetizationModel &law);

    /**
     * Writes one frame; ranks without particles take part. Collective.
     *
     * @param frame   number of the frame, in the names of the files.
     * @param time    [s].
     * @param bodies  with this rank's particles.
     */
    void
    write_frame(const unsigned int frame, const double time, const std::vector<Body<dim>> &bodies);

    /** The frames written so far, particles.pvd. */
    FrameSeries &
    frames()
    {
      return series;
    }

  private:
    const MPI_Comm communicator;
    const std::vector<ParticleQuantity<dim>> quantities;
    const MagnetizationModel law;
    FrameSeries series;
  };
} // namespace magmpm
