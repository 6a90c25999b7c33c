#include <magmpm/parameters/parameter_sections.h>
#include <magmpm/parameters/parameters.h>

#include <sstream>

namespace magmpm
{
  namespace
  {
    const char *const introduction = R"(# Parameters

This file is the output of `magmpm --print-parameters`.

A parameter file consists of lines `set NAME = VALUE`, which may stand in `subsection NAME` ... `end`;
`#` starts a comment. Below, a heading `Bodies/<body>` is a subsection of the subsection `Bodies`
that has the name of a body: every name in `List of shapes`, `List of bodies`, `List of materials`,
`List of magnets`, `List of rigid bodies` and `List of contacts` has such a subsection; one that is not listed is left out. On the command line the same is `--set "Bodies/cube/Density=1000"`.

All values are in SI units. Vectors are numbers separated by commas, and what changes in time is given
as expressions of t separated by semicolons, such as `0.5; 0.5; 0.2 + 0.1*t`. The lists below are
those of `Dimension = 3`. With `Dimension = 2` (plane strain; all quantities per metre of depth)
vectors have two components and spins one, and there are no cylinders, tubes and meshes, and no
faces along z.
)";

    /** Text in a cell of a Markdown table. */
    std::string
    as_cell(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        {
          if (c == '|' || c == '<' || c == '>' || c == '*' || c == '_')
            result += '\\';
          result += c;
        }
      return result;
    }

    std::string
    default_of(const DeclaredParameter &parameter)
    {
      switch (parameter.presence)
        {
          case Presence::required:
            return "must be given";
          case Presence::optional:
            return "not given";
          default:
            return parameter.default_value.empty() ? "empty" : "`" + parameter.default_value + "`";
        }
    }
  } // namespace

  std::string
  parameter_manual()
  {
    ParameterInput<3> input;
    input.shapes.names     = {"<shape>"};
    input.body_names       = {"<body>"};
    input.material_names   = {"<material>"};
    input.magnet_names     = {"<magnet>"};
    input.rigid_body_names = {"<rigid body>"};
    input.contact_names    = {"<contact>"};

    Parameters<3> parameters;
    ParameterRegister declarations;
    declare_parameters(declarations, input, parameters);

    std::ostringstream manual;
    manual << introduction;
    std::string section = "none yet";
    for (const DeclaredParameter &parameter : declarations.declared_parameters())
      {
        if (parameter.section != section)
          {
            section = parameter.section;
            manual << "\n## " << (section.empty() ? "Outside of all subsections" : as_cell(section))
                   << "\n\n| name | default | range | unit | |\n|---|---|---|---|---|\n";
          }
        manual << "| " << parameter.name << " | " << default_of(parameter) << " | "
               << as_cell(parameter.range) << " | " << as_cell(parameter.unit) << " | "
               << as_cell(parameter.text) << " |\n";
      }
    return manual.str();
  }
} // namespace magmpm
