#include <magmpm/parameters/input_file.h>

#include <filesystem>

namespace magmpm
{
  std::string
  find_input_file(const ParameterRegister &declarations,
                  const std::string &path,
                  const std::string &file)
  {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const std::string beside = declarations.folder() + file;
    if (fs::path(file).is_absolute() || beside == file)
      {
        if (fs::is_regular_file(file, ignored))
          return file;
        throw declarations.error(path,
                                 "there is no such file" +
                                   (fs::path(file).is_absolute()
                                      ? std::string(".")
                                      : " in " + fs::current_path().string() +
                                          ", the folder of the parameter file and the working "
                                          "directory.") +
                                   " Correct the name.");
      }
    for (const std::string &place : {beside, file})
      if (fs::is_regular_file(place, ignored))
        return place;
    throw declarations.error(path,
                             "there is no such file, neither " + beside +
                               " (beside the parameter file) nor " +
                               (fs::current_path() / file).string() +
                               " (in the working directory). Correct the name, or put the file in "
                               "one of these places.");
  }
} // namespace magmpm
