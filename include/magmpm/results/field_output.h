#pragma once

#include <magmpm/magnetics/field_quantities.h>
#include <magmpm/results/frame_series.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  template <int dim>
  class ExternalField;
  template <int dim>
  class PotentialProblem;

  inline const FrameKind field_frames = {"fields", "magnetic fields on the mesh (ParaView)"};

  /**
   * Writes the magnetic fields of a frame for ParaView, on the adaptive mesh of the potential: one file
   * `fields/fields_<frame>.0.vtu` of all ranks together, a .pvtu beside it, and `fields.pvd`, which
   * lists the frames so far and is what a user opens. Quantities (field_quantities()) are called
   * "name [unit]". All are values at the nodes of FE_Q(2), each cell cut in 2^dim, in single precision; H_int, which
   * jumps between cells, is averaged there, so that field lines drawn by a stream tracer are continuous. M and the density
   * of grains are means over the octants around a node.
   */
  template <int dim>
  class FieldOutput
  {
  public:
    /**
     * Makes the folder `fields` in @p directory, which must exist. Collective.
     *
     * @param quantities  names of those that are written.
     * @throw InputError if a name is unknown, RunError if the folder cannot be made.
     */
    FieldOutput(const MPI_Comm communicator,
                const std::string &directory,
                const std::vector<std::string> &quantities);

    /**
     * Writes one frame: potential and medium of the last solve, with the sources as they are now (in
     * general those of that solve). Collective.
     *
     * @param frame  number of the frame, in the names of the files.
     * @param time   [s].
     */
    void
    write_frame(const unsigned int frame,
                const double time,
                const PotentialProblem<dim> &potential,
                const ExternalField<dim> &sources);

    /** The frames written so far, fields.pvd. */
    FrameSeries &
    frames()
    {
      return series;
    }

  private:
    const MPI_Comm communicator;
    const std::vector<FieldQuantity<dim>> quantities;
    FrameSeries series;
  };
} // namespace magmpm
