#include <magmpm/parameters/parameter_listing.h>

#include <algorithm>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /** The longest line, indentation and "# " included. */
    constexpr std::size_t line_width = 78;

    /** Breaks a text at blanks into lines of up to @p width letters, or one word. */
    std::vector<std::string>
    lines_of(const std::string &text, const std::size_t width)
    {
      std::vector<std::string> lines;
      std::istringstream words(text);
      std::string word;
      while (words >> word)
        if (!lines.empty() && lines.back().size() + 1 + word.size() <= width)
          lines.back() += " " + word;
        else
          lines.push_back(word);
      return lines;
    }

    std::string
    blanks(const std::size_t n)
    {
      return std::string(n, ' ');
    }

    /** The parameters directly in a section, their values one below the other. */
    void
    list_parameters(const std::vector<const DeclaredParameter *> &parameters,
                    const std::string &indentation,
                    std::ostream &listing)
    {
      std::size_t longest_name = 0, longest_value = 0;
      for (const DeclaredParameter *parameter : parameters)
        {
          longest_name  = std::max(longest_name, parameter->name.size());
          longest_value = std::max(longest_value, parameter->value.size());
        }
      for (const DeclaredParameter *parameter : parameters)
        {
          if (parameter != parameters.front())
            listing << '\n';
          for (const std::string &line : lines_of(parameter->text + parameter->unit_in_brackets(),
                                                  line_width - indentation.size() - 2))
            listing << indentation << "# " << line << '\n';
          listing << indentation << "set " << parameter->name
                  << blanks(longest_name - parameter->name.size()) << " = " << parameter->value;
          if (!parameter->default_value.empty() && parameter->value != parameter->default_value)
            listing << blanks(longest_value - parameter->value.size())
                    << " # default: " << parameter->default_value;
          listing << '\n';
        }
    }

    void
    list_section(const ParameterTable &table,
                 const std::string &section,
                 const int depth,
                 std::ostream &listing)
    {
      const std::string indentation = blanks(2 * depth);
      const auto parameters         = table.parameters_in(section);
      const auto subsections        = table.subsections_in(section);
      list_parameters(parameters, indentation, listing);
      if (!parameters.empty() && !subsections.empty())
        listing << "\n\n";
      for (const std::string &name : subsections)
        {
          listing << indentation << "subsection " << name << '\n';
          list_section(table, joined_path(section, name), depth + 1, listing);
          listing << indentation << "end\n\n" << (depth == 0 ? "\n" : "");
        }
    }
  } // namespace

  std::string
  listing_of(const ParameterTable &table)
  {
    std::ostringstream listing;
    listing << "# Listing of Parameters\n# ---------------------\n";
    list_section(table, "", 0, listing);
    return listing.str();
  }
} // namespace magmpm
