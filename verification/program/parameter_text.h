#pragma once

#include <string>
#include <utility>
#include <vector>

namespace magmpm::verification
{
  /** The text of a small scene, piece by piece; by default a box of 32 cells of 10 mm along x. */
  struct ParameterText
  {
    int dim               = 2;
    std::string end_time  = "0.1";
    std::string gravity   = "0, 0";
    std::string box       = "0.32, 0.32"; ///< upper corner
    std::string cell_size = "0.01";
    std::vector<std::pair<std::string, std::string>> bodies;    ///< names and lines
    std::vector<std::pair<std::string, std::string>> materials; ///< names and lines
    std::string rest;                                           ///< other sections

    ParameterText &
    add_body(const std::string &name,
             const std::string &material,
             const std::string &density,
             const std::string &lines)
    {
      bodies.emplace_back(
        name, "set Material = " + material + "\nset Density = " + density + "\n" + lines);
      return *this;
    }

    /** A box-shaped body of density 1000. */
    ParameterText &
    add_box(const std::string &name,
            const std::string &material,
            const std::string &lower,
            const std::string &upper,
            const std::string &lines = "")
    {
      return add_body(name,
                      material,
                      "1000",
                      "set Lower corner = " + lower + "\nset Upper corner = " + upper + "\n" +
                        lines);
    }

    ParameterText &
    add_solid(const std::string &name, const std::string &modulus, const std::string &lines = "")
    {
      materials.emplace_back(
        name, "set Young's modulus = " + modulus + "\nset Poisson ratio = 0.3\n" + lines);
      return *this;
    }

    ParameterText &
    add_fluid(const std::string &name,
              const std::string &bulk_modulus,
              const std::string &viscosity,
              const std::string &lines = "")
    {
      materials.emplace_back(name,
                             "set Mechanical law = viscoelastic fluid\nset Bulk modulus = " +
                               bulk_modulus + "\nset Viscosity = " + viscosity + "\n" + lines);
      return *this;
    }

    std::string
    text() const
    {
      return "set Dimension = " + std::to_string(dim) + "\nset End time = " + end_time +
             "\nset Gravity = " + gravity + "\nsubsection Box\nset Upper corner = " + box +
             "\nset Cell size = " + cell_size + "\nend\n" +
             subsections("Bodies", "bodies", bodies) +
             subsections("Materials", "materials", materials) + rest;
    }

  private:
    static std::string
    subsections(const std::string &section,
                const std::string &list,
                const std::vector<std::pair<std::string, std::string>> &entries)
    {
      std::string names, text;
      for (const auto &[name, lines] : entries)
        {
          names += (names.empty() ? "" : ", ") + name;
          text += "subsection " + name + "\n" + lines + "\nend\n";
        }
      return "subsection " + section + "\nset List of " + list + " = " + names + "\n" + text +
             "end\n";
    }
  };

  /** Walls of one condition on all faces. */
  inline std::string
  walls(const int dim, const std::string &condition)
  {
    std::string text = "subsection Walls\n";
    for (int d = 0; d < dim; ++d)
      for (const char *side : {"Lower ", "Upper "})
        text += std::string("set ") + side + "xyz"[d] + " = " + condition + "\n";
    return text + "end\n";
  }
} // namespace magmpm::verification
