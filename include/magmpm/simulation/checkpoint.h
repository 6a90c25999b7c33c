#pragma once

#include <magmpm/coupling/section.h>
#include <magmpm/results/run_output.h>
#include <magmpm/simulation/checkpoint_file.h>

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace magmpm
{
  inline const RunOutput checkpoint_output = {"checkpoint", "to go on from, with --resume"};

  /** A run between two steps, all that it needs to go on but its particles; the same on all ranks. */
  struct Checkpoint
  {
    std::string version;    ///< of the program that wrote it
    std::string parameters; ///< Parameters::complete_text
    std::vector<Section> sections;
    unsigned int n_files = 0; ///< of particles, beside it: one of each rank that wrote it

    std::vector<SectionTitle>
    titles() const;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &version;
      archive &parameters;
      archive &sections;
      archive &n_files;
    }
  };

  /** Columns of numbers of one body's particles, where they are: nothing is copied on the way. */
  using ColumnsToWrite = std::vector<ConstBytes>;

  /**
   * Makes room for so many more particles of a body, and says where their columns are to go, in the order
   * in which they were written. Called once for each body of each file, in their order.
   */
  using MakeRoom = std::function<std::vector<Bytes>(const std::size_t body, const std::size_t n)>;

  /**
   * The checkpoints of a run in the folder `checkpoint` of its results: a folder for each, and the small
   * file `latest`, which names the one to resume from.
   *
   * A checkpoint is written whole, a file per rank, brought to the disk, and only then named; older ones
   * are removed after that. So whenever a run is killed, `latest` names a good one. Every file carries
   * the version of this format, its length and a CRC, so that one which was damaged later, or written by
   * another version of magmpm, is noticed before anything in it is believed.
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
     * @param particles  of this rank by body: all columns of a body with one entry a particle, of
     *                   eight bytes.
     * @throw RunError   on all ranks, if a rank cannot write its part; the ones before stay.
     */
    void
    write(const std::string &name,
          Checkpoint checkpoint,
          const std::vector<ColumnsToWrite> &particles) const;

    /**
     * Reads the latest checkpoint, without its particles. Collective.
     *
     * @throw InputError  on all ranks, if there is none.
     * @throw RunError    on all ranks, if it is damaged or of another version.
     */
    Checkpoint
    read() const;

    /**
     * Reads the particles of the latest checkpoint. Those of all ranks that wrote it are dealt out to this
     * run's ranks file by file, not to the owners of their blocks. Collective.
     *
     * @throw RunError    on all ranks, if a file is missing or damaged, or has other columns.
     */
    void
    read_particles(const Checkpoint &checkpoint, const MakeRoom &make_room) const;

    /** Removes the checkpoints of an older run. Collective. */
    void
    clear() const;

    /** The path of the checkpoint to resume from; empty if there is none. The same on all ranks. Collective. */
    std::string
    latest() const;

  private:
    void
    remove_old_ones(const std::string &newest) const;

    const MPI_Comm communicator;
    const std::string folder;
    const int n_kept;
  };
} // namespace magmpm
