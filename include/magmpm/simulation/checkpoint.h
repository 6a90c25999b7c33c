#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /** A run between two steps: all it needs to go on. */
  struct Checkpoint
  {
    std::string version;    ///< of the program that wrote it
    std::string parameters; ///< Parameters::complete_text
    std::vector<char> run;  ///< what the simulation packed, the same on all ranks

    /** This rank's particles by body, records of ParticleSet one after the other. */
    std::vector<std::vector<double>> particles;
  };

  /**
   * The checkpoints of a run in the folder `checkpoint` of its results: a folder for each, and the small
   * file `latest`, which names the one to resume from.
   *
   * A checkpoint is written whole, a file per rank, brought to the disk, and only then named; older ones
   * are removed after that. So whenever a run is killed, `latest` names a good one. Every file carries
   * its length and a CRC, so that one which was damaged later is noticed.
   */
  class CheckpointFolder
  {
  public:
    /** @param n_kept  checkpoints that stay on the disk, the latest included. */
    CheckpointFolder(const MPI_Comm communicator,
                     const std::string &output_directory,
                     const int n_kept);

    /**
     * Writes a checkpoint; if the latest has that name already, there is nothing to do. Collective.
     *
     * @throw RunError  on all ranks, if a rank cannot write its part; the ones before stay.
     */
    void
    write(const std::string &name, const Checkpoint &checkpoint) const;

    /**
     * Reads the latest checkpoint. The particles of all ranks that wrote it are dealt out to this run's
     * ranks as they come, not to the owners of their blocks. Collective.
     *
     * @throw InputError  on all ranks, if there is none.
     * @throw RunError    on all ranks, if a file is missing or damaged.
     */
    Checkpoint
    read() const;

    /** Makes sure that a run which starts afresh does not leave the checkpoints of an older one. */
    void
    clear() const;

    /** The path of the checkpoint to resume from; empty if there is none. Rank 0 knows. */
    std::string
    latest() const;

  private:
    void
    remove_old_ones() const;

    const MPI_Comm communicator;
    const std::string folder;
    const int n_kept;
    int rank    = 0;
    int n_ranks = 1;
  };
} // namespace magmpm
