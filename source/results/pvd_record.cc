#include <magmpm/base/exceptions.h>
#include <magmpm/results/pvd_record.h>

#include <deal.II/base/data_out_base.h>

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
      dealii::DataOutBase::write_pvd_record(output, all_frames);
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
