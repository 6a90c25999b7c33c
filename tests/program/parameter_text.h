#pragma once

#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <string>
#include <utility>
#include <vector>

namespace magmpm::testing
{
  /** The text of a small scene, piece by piece; a box of 32 cells of 10 mm along x. */
  struct ParameterText
  {
    int dim              = 2;
    std::string end_time = "0.1";
    std::string gravity  = "0, 0";
    std::string box      = "0.32, 0.32";                        ///< upper corner
    std::vector<std::pair<std::string, std::string>> bodies;    ///< names and lines
    std::vector<std::pair<std::string, std::string>> materials; ///< names and lines
    std::string rest;                                           ///< other sections

    /** A box-shaped body of density 1000. */
    ParameterText &
    add_box(const std::string &name,
            const std::string &material,
            const std::string &lower,
            const std::string &upper,
            const std::string &lines = "")
    {
      bodies.emplace_back(name,
                          "set Material = " + material +
                            "\nset Density = 1000\nset Lower corner = " + lower +
                            "\nset Upper corner = " + upper + "\n" + lines);
      return *this;
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
              const std::string &viscosity)
    {
      materials.emplace_back(name,
                             "set Mechanical law = viscoelastic fluid\nset Bulk modulus = " +
                               bulk_modulus + "\nset Viscosity = " + viscosity + "\n");
      return *this;
    }

    std::string
    text() const
    {
      return "set Dimension = " + std::to_string(dim) + "\nset End time = " + end_time +
             "\nset Gravity = " + gravity + "\nsubsection Box\nset Upper corner = " + box +
             "\nset Cell size = 0.01\nend\n" + subsections("Bodies", "bodies", bodies) +
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

  /** Kinetic, elastic and gravitational energy of each row, in 2D. */
  inline std::vector<double>
  mechanical_energy(const verification::Statistics &statistics)
  {
    std::vector<double> energy;
    for (std::size_t row = 0; row < statistics.n_rows(); ++row)
      energy.push_back(statistics["kinetic energy [J/m]"][row] +
                       statistics["elastic energy [J/m]"][row] +
                       statistics["gravitational energy [J/m]"][row]);
    return energy;
  }

  /** Rows of a column of text: here the limits of dt. */
  inline int
  rows_with(const std::string &folder, const std::string &word)
  {
    std::istringstream lines(verification::contents(folder + "/statistics.csv"));
    int n = 0;
    for (std::string line; std::getline(lines, line);)
      n += (line.find("," + word + ",") != std::string::npos);
    return n;
  }
} // namespace magmpm::testing
