#pragma once

#include <string>
#include <vector>

namespace magmpm
{
  /** A line "set NAME = VALUE", or a --set "SECTION/NAME=VALUE" of the command line. */
  struct ParameterEntry
  {
    std::string section; ///< "Bodies/cube"; empty at the top
    std::string name;
    std::string value;
    std::string origin; ///< for messages: "cube.prm, line 12"
    bool from_command_line;

    /** "Bodies/cube/Density" */
    std::string
    path() const
    {
      return section.empty() ? name : section + "/" + name;
    }
  };

  /**
   * A parameter file in the language of deal.II's ParameterHandler (without its "include"), cut into
   * entries that still know their line, so that a message can name it. Which names and values are
   * allowed is not known here: see ParameterRegister.
   */
  struct ParameterFile
  {
    std::string name; ///< as the user typed it
    std::vector<ParameterEntry> entries;

    /** The lines "subsection ...", used or not: section and origin only. */
    std::vector<ParameterEntry> subsections;

    /** The text of the file; what the command line set follows at the end, as lines that set it. */
    std::string text;

    /** The entry of that path that counts, which is the last one, or a null pointer. */
    const ParameterEntry *
    last_entry(const std::string &path) const;

    /** "output-<name>" of a file ".../<name>.prm". */
    std::string
    default_output_directory() const;
  };

  /**
   * Cuts @p text into entries.
   *
   * @param name       of the file, for messages.
   * @param overrides  values from the command line, "Section/Name=value" each; they win.
   * @throw InputError  names file, line and what stands there.
   */
  ParameterFile
  parse_parameter_text(const std::string &text,
                       const std::string &name,
                       const std::vector<std::string> &overrides = {});

  /** The same for the file @p name. @throw InputError also if it cannot be read. */
  ParameterFile
  read_parameter_file(const std::string &name, const std::vector<std::string> &overrides = {});
} // namespace magmpm
