#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/results/pvd_record.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /** One named quantity of all particles of this rank, as it is written. */
  struct ParticleQuantity
  {
    std::string name;
    std::string unit;           ///< "m/s"; "-" if it has none
    int n_components = 1;       ///< 1 (scalar) or dim (vector)
    std::vector<double> values; ///< by particle, then by component
  };

  /**
   * Writes the particles of a frame for ParaView: one file `particles/particles_<frame>.0.vtu` of
   * all ranks together, a .pvtu beside it, and `particles.pvd`, which lists the frames so far and
   * is what a user opens. Every particle is a vertex cell; quantities are called "name [unit]" and
   * stored in single precision; a vector has three components in 2D too (the third is zero), so
   * that ParaView takes it for one.
   */
  template <int dim>
  class ParticleOutput
  {
  public:
    /**
     * Makes the folder `particles` in @p directory, which must exist. Collective.
     *
     * @throw RunError if the folder cannot be made.
     */
    ParticleOutput(const MPI_Comm communicator, const std::string &directory);

    /**
     * Writes one frame; ranks without particles take part with empty lists. Collective.
     *
     * @param frame       number of the frame, in the names of the files.
     * @param time        [s].
     * @param positions   of this rank's particles [m].
     * @param quantities  the same names in the same order on all ranks.
     */
    void
    write_frame(const unsigned int frame,
                const double time,
                const std::vector<Vector<dim>> &positions,
                const std::vector<ParticleQuantity> &quantities);

    /** The frames written so far, particles.pvd. */
    PvdRecord &
    frames()
    {
      return record;
    }

  private:
    const MPI_Comm communicator;
    const std::string directory;
    PvdRecord record;
  };
} // namespace magmpm
