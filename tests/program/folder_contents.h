#pragma once

#include <verification/text_file.h>

#include <filesystem>
#include <map>
#include <string>

namespace magmpm::testing
{
  /** Every file below a folder, by its path from there, with its bytes. */
  inline std::map<std::string, std::string>
  folder_contents(const std::string &folder)
  {
    std::map<std::string, std::string> files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file())
        files[std::filesystem::relative(entry.path(), folder).string()] =
          verification::contents(entry.path().string());
    return files;
  }

  /** The names of files that are not the same in two folders, or in one only; "" if there are none. */
  inline std::string
  changed_files(const std::map<std::string, std::string> &before,
                const std::map<std::string, std::string> &after)
  {
    std::string names;
    for (const auto &[name, bytes] : before)
      if (after.count(name) == 0 || after.at(name) != bytes)
        names += name + " ";
    for (const auto &[name, bytes] : after)
      if (before.count(name) == 0)
        names += name + " ";
    return names;
  }
} // namespace magmpm::testing
