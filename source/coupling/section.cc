#include <magmpm/base/exceptions.h>
#include <magmpm/coupling/section.h>

#include <algorithm>

namespace magmpm
{
  void
  check_titles(const std::vector<SectionTitle> &found, const std::vector<SectionTitle> &expected)
  {
    const auto find = [](const std::vector<SectionTitle> &titles, const std::string &name) {
      return std::find_if(titles.begin(), titles.end(), [&](const SectionTitle &title) {
        return title.name == name;
      });
    };
    const std::string remedy =
      " Resume it with the version of magmpm that wrote it, or start anew.";
    for (const SectionTitle &title : expected)
      {
        const auto other = find(found, title.name);
        if (other == found.end())
          throw RunError("the checkpoint has no section '" + title.name + "'." + remedy);
        if (other->version != title.version)
          throw RunError("section '" + title.name + "' of the checkpoint has version " +
                         std::to_string(other->version) + ", this magmpm reads version " +
                         std::to_string(title.version) + "." + remedy);
      }
    for (const SectionTitle &title : found)
      if (find(expected, title.name) == expected.end())
        throw RunError("the checkpoint has a section '" + title.name +
                       "' that this magmpm does not know." + remedy);
  }

  const std::string &
  section_named(const std::string &name, const std::vector<Section> &sections)
  {
    for (const Section &section : sections)
      if (section.title.name == name)
        return section.bytes;
    throw RunError("the checkpoint has no section '" + name + "'.");
  }
} // namespace magmpm
