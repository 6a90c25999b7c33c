#include <magmpm/results/field_output.h>
#include <magmpm/results/particle_output.h>
#include <magmpm/results/rigid_body_output.h>
#include <magmpm/results/run_log.h>
#include <magmpm/results/run_outputs.h>
#include <magmpm/results/statistics_file.h>
#include <magmpm/results/surface_output.h>

namespace magmpm
{
  namespace
  {
    const std::vector<FrameKind> &
    frame_kinds()
    {
      static const std::vector<FrameKind> kinds = {
        particle_frames, field_frames, surface_frames, rigid_body_frames};
      return kinds;
    }
  } // namespace

  const std::vector<RunOutput> &
  run_outputs()
  {
    static const std::vector<RunOutput> outputs = [] {
      std::vector<RunOutput> list;
      for (const FrameKind &kind : frame_kinds())
        list.push_back(kind.record());
      list.insert(
        list.end(),
        {statistics_output,
         log_output,
         {"parameters.prm", "every parameter of this run; original.prm is the file as given"}});
      return list;
    }();
    return outputs;
  }

  void
  remove_earlier_frames(const std::string &directory)
  {
    for (const FrameKind &kind : frame_kinds())
      remove_frames(directory, kind);
  }
} // namespace magmpm
