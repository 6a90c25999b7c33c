#include <magmpm/parameters/input_file.h>
#include <magmpm/parameters/motion_input.h>

namespace magmpm
{
  template <int dim>
  KeyFrames<dim>
  read_key_frames(const ParameterRegister &declarations,
                  const std::string &path,
                  const MotionInput &input)
  {
    // A table begins with a number, which is no name of a file.
    const std::string table = is_key_frame_table(input.key_frames)
                                ? input.key_frames
                                : find_input_file(declarations, path, input.key_frames);
    return read_key_frames<dim>(table, input.interpolation, declarations.where(path));
  }

  template KeyFrames<2>
  read_key_frames(const ParameterRegister &, const std::string &, const MotionInput &);
  template KeyFrames<3>
  read_key_frames(const ParameterRegister &, const std::string &, const MotionInput &);
} // namespace magmpm
