#pragma once

#include <magmpm/results/pvd_record.h>
#include <magmpm/magnetics/potential_problem.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * Writes the magnetic fields of a frame for ParaView, on the adaptive mesh of the potential: one file
   * `fields/fields_<frame>.0.vtu` of all ranks together, a .pvtu beside it, and `fields.pvd`, which
   * lists the frames so far and is what a user opens. Quantities, called "name [unit]":
   *
   *   potential       phi [A]
   *   H_int           -grad phi [A/m], the field that the material makes
   *   H               H_int + H_ext [A/m]
   *   M               magnetization [A/m]
   *   B               mu_0 (H + M) [T]
   *   number_density  of grains [1/m^3]
   *
   * M and thus B are those of material: inside a magnet its own magnetization is not in them.
   * All are values at the nodes of FE_Q(2), each cell cut in 2^dim, in single precision; H_int, which
   * jumps between cells, is averaged there, so that field lines drawn by a stream tracer are continuous. M and the density
   * of grains are means over the quadrature points around a node.
   */
  template <int dim>
  class FieldOutput
  {
  public:
    /**
     * Makes the folder `fields` in @p directory, which must exist. Collective.
     *
     * @param quantities  the names above that are written.
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

    /** The names of all quantities. */
    static const std::vector<std::string> &
    quantity_names();

    /** The frames written so far, fields.pvd. */
    PvdRecord &
    frames()
    {
      return record;
    }

  private:
    const MPI_Comm communicator;
    const std::string directory;
    const std::vector<std::string> quantities;
    PvdRecord record;
  };
} // namespace magmpm
