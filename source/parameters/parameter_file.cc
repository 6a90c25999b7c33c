#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_file.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /** Without space at the ends, inner runs of it made one blank, as ParameterHandler does. */
    std::string
    single_spaced(const std::string &text)
    {
      std::istringstream words(text);
      std::string result, word;
      while (words >> word)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }

    std::string
    lower_case(std::string text)
    {
      for (char &c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return text;
    }

    /** Reads line after line and remembers which subsections are open. */
    class LineReader
    {
    public:
      explicit LineReader(ParameterFile &file)
        : file(file)
      {
      }

      void
      read(const std::string &text)
      {
        std::istringstream lines(text);
        std::string line, joined;
        for (int number = 1; std::getline(lines, line); ++number)
          {
            if (joined.empty())
              line_number = number;
            joined += line.substr(0, line.find('#'));
            if (continues(joined))
              continue;
            read_statement(single_spaced(joined));
            joined.clear();
          }
        read_statement(single_spaced(joined));
        if (!open_sections.empty())
          throw InputError(file.name + ": the subsection '" + open_sections.back() + "' of line " +
                           std::to_string(open_lines.back()) +
                           " is not closed: an 'end' is missing.");
      }

    private:
      ParameterFile &file;
      int line_number = 0;
      std::vector<std::string> open_sections;
      std::vector<int> open_lines;

      std::string
      origin() const
      {
        return file.name + ", line " + std::to_string(line_number);
      }

      /** Whether the line ends with a backslash, which is taken away. */
      static bool
      continues(std::string &line)
      {
        const std::size_t last = line.find_last_not_of(" \t\r");
        if (last == std::string::npos || line[last] != '\\')
          return false;
        line.erase(last);
        return true;
      }

      std::string
      section() const
      {
        std::string path;
        for (const std::string &name : open_sections)
          path += (path.empty() ? "" : "/") + name;
        return path;
      }

      void
      read_statement(const std::string &statement)
      {
        if (statement.empty())
          return;
        const std::size_t space   = statement.find(' ');
        const std::string keyword = lower_case(statement.substr(0, space));
        const std::string rest    = (space == std::string::npos) ? "" : statement.substr(space + 1);
        const std::size_t equal   = rest.find('=');

        if (keyword == "set" && equal != std::string::npos && equal > 0)
          file.entries.push_back({section(),
                                  single_spaced(rest.substr(0, equal)),
                                  single_spaced(rest.substr(equal + 1)),
                                  origin(),
                                  false});
        else if (keyword == "subsection" && !rest.empty())
          {
            open_sections.push_back(rest);
            open_lines.push_back(line_number);
            file.subsections.push_back({section(), "", "", origin(), false});
          }
        else if (keyword == "end" && rest.empty())
          close_section();
        else
          throw InputError(origin() + ": cannot understand '" + statement +
                           "'. A line is 'set NAME = VALUE', 'subsection NAME', 'end', or a "
                           "comment after '#'.");
      }

      void
      close_section()
      {
        if (open_sections.empty())
          throw InputError(origin() + ": this 'end' closes nothing: no subsection is open here.");
        open_sections.pop_back();
        open_lines.pop_back();
      }
    };

    ParameterEntry
    parse_override(const std::string &override)
    {
      const std::string origin = "--set \"" + override + "\"";
      const std::size_t equal  = override.find('=');
      const std::string path   = single_spaced(override.substr(0, equal));
      const std::size_t slash  = path.find_last_of('/');
      const std::string name   = slash == std::string::npos ? path : path.substr(slash + 1);
      if (equal == std::string::npos || name.empty())
        throw InputError(origin + ": cannot understand this; write --set \"Section/Name=value\", "
                                  "such as --set \"Bodies/cube/Density=1000\".");
      if (override.find('#') != std::string::npos)
        throw InputError(origin + ": '#' starts a comment and cannot be part of a value.");
      return {slash == std::string::npos ? "" : path.substr(0, slash),
              name,
              single_spaced(override.substr(equal + 1)),
              origin,
              true};
    }

    /** The entry as lines of a parameter file. */
    std::string
    as_statements(const ParameterEntry &entry)
    {
      std::istringstream sections(entry.section);
      std::string name, text, closing;
      while (std::getline(sections, name, '/'))
        {
          text += "subsection " + name + "\n";
          closing += "end\n";
        }
      return text + "set " + entry.name + " = " + entry.value + "\n" + closing;
    }
  } // namespace

  const ParameterEntry *
  ParameterFile::last_entry(const std::string &path) const
  {
    const ParameterEntry *last = nullptr;
    for (const ParameterEntry &entry : entries)
      if (entry.path() == path)
        last = &entry;
    return last;
  }

  std::string
  ParameterFile::default_output_directory() const
  {
    const std::size_t slash = name.find_last_of('/');
    const std::string last  = slash == std::string::npos ? name : name.substr(slash + 1);
    return "output-" + last.substr(0, last.find_last_of('.'));
  }

  ParameterFile
  parse_parameter_text(const std::string &text,
                       const std::string &name,
                       const std::vector<std::string> &overrides)
  {
    ParameterFile file;
    file.name = name;
    file.text = text;
    LineReader(file).read(text);

    if (!overrides.empty())
      file.text += "\n# Set on the command line:\n";
    for (const std::string &override : overrides)
      {
        file.entries.push_back(parse_override(override));
        file.text += as_statements(file.entries.back());
      }
    return file;
  }

  ParameterFile
  read_parameter_file(const std::string &name, const std::vector<std::string> &overrides)
  {
    errno = 0;
    std::ifstream stream(name);
    std::ostringstream text;
    // An empty file leaves the failbit set in text, a folder sets the badbit of the stream.
    if (stream)
      text << stream.rdbuf();
    if (!stream.is_open() || stream.bad() || errno != 0)
      throw InputError("cannot read the parameter file '" + name +
                       "': " + std::strerror(errno == 0 ? EIO : errno) + ".");
    return parse_parameter_text(text.str(), name, overrides);
  }
} // namespace magmpm
