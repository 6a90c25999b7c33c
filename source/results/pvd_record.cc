#include <magmpm/base/exceptions.h>
#include <magmpm/results/pvd_record.h>

#include <cstdio>
#include <fstream>

namespace magmpm
{
  PvdRecord::PvdRecord(const std::string &path)
    : path(path)
  {
  }

  void
  PvdRecord::add(const double time, const std::string &file)
  {
    all_frames.emplace_back(time, file);

    const std::string unfinished = path + ".unfinished";
    {
      std::ofstream output(unfinished);
      output.precision(12);
      output << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                "ByteOrder=\"LittleEndian\">\n<Collection>\n";
      for (const auto &[time_of_frame, file_of_frame] : all_frames)
        output << "<DataSet timestep=\"" << time_of_frame << "\" group=\"\" part=\"0\" file=\""
               << file_of_frame << "\"/>\n";
      output << "</Collection>\n</VTKFile>\n";
      output.close();
      if (!output)
        throw RunError("The list of frames '" + unfinished +
                       "' cannot be written. Is the disk full, or the output directory gone?");
    }
    if (std::rename(unfinished.c_str(), path.c_str()) != 0)
      throw RunError("The list of frames '" + path + "' cannot be replaced by a newer one ('" +
                     unfinished + "'). Are you allowed to write in the output directory?");
  }
} // namespace magmpm
