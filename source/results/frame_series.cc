#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/together.h>
#include <magmpm/results/frame_series.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <regex>

namespace magmpm
{
  FrameSeries::FrameSeries(const MPI_Comm communicator,
                           const std::string &directory,
                           const FrameKind &kind)
    : communicator(communicator)
    , directory(directory)
    , kind(kind)
    , record(directory + "/" + kind.record().name)
  {
  }

  void
  FrameSeries::make_folder() const
  {
    std::string things = kind.name;
    std::replace(things.begin(), things.end(), '_', ' ');
    parallel::make_folder(communicator, folder(), "the " + things);
  }

  void
  FrameSeries::add(const double time, const std::string &file)
  {
    parallel::on_first_rank(communicator, [&]() { record.add(time, kind.name + "/" + file); });
  }

  std::string
  frame_name(const std::string &series, const unsigned int frame)
  {
    char number[16];
    std::snprintf(number, sizeof(number), "_%04u", frame);
    return series + number;
  }

  void
  remove_frames(const std::string &directory, const FrameKind &kind)
  {
    namespace fs          = std::filesystem;
    const fs::path folder = fs::path(directory) / kind.name;
    const std::regex of_frame(kind.name + "_[0-9]{4,}([.]0[.]vtu|[.]pvtu|[.]vtp)");
    try
      {
        // The record first: it shall never name a frame that is gone.
        fs::remove(fs::path(directory) / kind.record().name);
        if (!fs::is_directory(folder))
          return;
        std::vector<fs::path> frames;
        for (const auto &entry : fs::directory_iterator(folder))
          if (std::regex_match(entry.path().filename().string(), of_frame))
            frames.push_back(entry.path());
        for (const fs::path &frame : frames)
          fs::remove(frame);
      }
    catch (const fs::filesystem_error &error)
      {
        throw RunError("The frames that an earlier run left in '" + folder.string() +
                       "' cannot be removed: " + error.code().message() +
                       ". Are you allowed to write there?");
      }
  }
} // namespace magmpm
