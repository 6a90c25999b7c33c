#pragma once

#include <string>
#include <utility>
#include <vector>

namespace magmpm
{
  /**
   * The .pvd file of a series of frames: what ParaView is told to open. It names the file of every
   * frame with its time, and is written anew with each frame, first beside the old one and then in
   * its place, so that a run that is cut off leaves a record of all its frames.
   */
  class PvdRecord
  {
  public:
    /** @param path  of the .pvd file; the frames' files are given relative to its folder. */
    explicit PvdRecord(const std::string &path);

    /**
     * Adds a frame and writes the file. One rank only.
     *
     * @param time  of the frame [s].
     * @param file  of the frame, relative to the folder of the .pvd file.
     * @throw RunError if the file cannot be written.
     */
    void
    add(const double time, const std::string &file);

    /** The frames so far: time [s] and file of each. */
    const std::vector<std::pair<double, std::string>> &
    frames() const
    {
      return all_frames;
    }

    /** Goes on behind the frames of an earlier run; the next add() writes the file. */
    void
    resume(const std::vector<std::pair<double, std::string>> &frames_so_far)
    {
      all_frames = frames_so_far;
    }

  private:
    const std::string path;
    std::vector<std::pair<double, std::string>> all_frames;
  };
} // namespace magmpm
