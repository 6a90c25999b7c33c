#pragma once

#include <magmpm/results/pvd_record.h>
#include <magmpm/results/run_output.h>

#include <mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace magmpm
{
  /** Frames of one kind, as an output writes them: files in `NAME` and `NAME.pvd`, which lists them. */
  struct FrameKind
  {
    std::string name;
    std::string meaning; ///< for users: "particles, frame by frame (ParaView)"

    /** What a user opens. */
    RunOutput
    record() const
    {
      return {name + ".pvd", meaning};
    }
  };

  /** The frames of one kind that a run writes into its output folder. */
  class FrameSeries
  {
  public:
    /** @param directory  the output folder. */
    FrameSeries(const MPI_Comm communicator, const std::string &directory, const FrameKind &kind);

    /**
     * Makes the folder of the frames; the output folder must exist. Collective.
     *
     * @throw RunError  if it cannot be made.
     */
    void
    make_folder() const;

    const std::string &
    name() const
    {
      return kind.name;
    }

    /** Where the files of the frames lie. */
    std::string
    folder() const
    {
      return directory + "/" + kind.name;
    }

    /**
     * Adds a frame to the record. Collective.
     *
     * @param time      [s].
     * @param file      of the frame, in folder(); that of rank 0 counts.
     * @throw RunError  if the record cannot be written.
     */
    void
    add(const double time, const std::string &file);

    /** The frames so far: time [s] and file of each. What counts is that of rank 0. */
    const std::vector<std::pair<double, std::string>> &
    frames() const
    {
      return record.frames();
    }

    /** Goes on behind the frames of an earlier run. */
    void
    resume(const std::vector<std::pair<double, std::string>> &frames_so_far)
    {
      record.resume(frames_so_far);
    }

  private:
    const MPI_Comm communicator;
    const std::string directory;
    const FrameKind kind;
    PvdRecord record;
  };

  /** "cube_0012" for frame 12 of the series "cube". */
  std::string
  frame_name(const std::string &series, const unsigned int frame);

  /**
   * Removes the record of that kind and the files of its frames that an earlier run left in
   * @p directory, and nothing else: also their folder stays. One rank only.
   *
   * @throw RunError  if one cannot be removed.
   */
  void
  remove_frames(const std::string &directory, const FrameKind &kind);
} // namespace magmpm
