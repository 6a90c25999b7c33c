// The wording of the messages on wrong parameter files. Each one says where the fault is, which
// value is wrong, what is allowed and, where it is not plain, what to do; a user sees nothing else.

#include "../catch.h"

#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameters.h>

using namespace magmpm;

namespace
{
  const char *const valid_text = R"(set End time = 1
subsection Box
  set Upper corner = 1, 1, 1
  set Cell size = 0.0625
end
subsection Bodies
  set List of bodies = cube
  subsection cube
    set Material = clay
    set Lower corner = 0.25, 0.25, 0.5
    set Upper corner = 0.75, 0.75, 0.75
    set Density = 1000
  end
end
subsection Materials
  set List of materials = clay
  subsection clay
    set Young's modulus = 1e5
    set Poisson ratio = 0.3
    set Saturation magnetization = 8e4
    set Initial susceptibility = 1
  end
end
subsection Magnets
  set List of magnets = magnet
  subsection magnet
    set Type = magnetized sphere
    set Position = 0.5; 0.5; 0.25
    set Magnetization = 0; 0; 1e6
    set Radius = 0.125
    set Contact = separate
  end
end
)";

  /** The message on a text, or nothing if it is valid. */
  std::string
  message_on(const std::string &text, const std::vector<std::string> &overrides = {})
  {
    try
      {
        const ParameterFile file = parse_parameter_text(text, "cube.prm", overrides);
        read_dimension(file) == 2 ? (void)read_parameters<2>(file) : (void)read_parameters<3>(file);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  /** The message on the valid text with one value changed, without the value's place in front. */
  std::string
  message_with(const std::string &override, const std::vector<std::string> &others = {})
  {
    std::vector<std::string> overrides = others;
    overrides.push_back(override);
    const std::string message = message_on(valid_text, overrides);
    const std::string place   = "--set \"" + override + "\": ";
    return message.rfind(place, 0) == 0 ? message.substr(place.size()) : message;
  }

  /** A message about a magnet, from where it names the parameter: without the file's or option's name. */
  std::string
  without_place(const std::string &message)
  {
    const auto place = message.find(": Magnets/");
    return place == std::string::npos ? message : message.substr(place + 2);
  }

  /** The valid text with a line replaced. */
  std::string
  with_line(const std::string &line, const std::string &replacement)
  {
    std::string text     = valid_text;
    const std::size_t at = text.find(line);
    REQUIRE(at != std::string::npos);
    return text.replace(at, line.size(), replacement);
  }
} // namespace

// Else the messages below could be on another fault than the one that was made.
TEST_CASE("The text that the messages are tested with is valid", "[parameters]")
{
  CHECK(message_on(valid_text) == "");
}

// One line of the valid text spoilt at a time, so the message can have only one right place and
// wording.
TEST_CASE("Messages on lines that cannot be read", "[parameters]")
{
  CHECK(message_on(with_line("  set Cell size = 0.0625", "  sett Cell size = 0.0625")) ==
        "cube.prm, line 4: cannot understand 'sett Cell size = 0.0625'. A line is 'set NAME = "
        "VALUE', 'subsection NAME', 'end', or a comment after '#'.");
  CHECK(message_on(std::string(valid_text) + "end\n") ==
        "cube.prm, line 34: this 'end' closes nothing: no subsection is open here.");
  CHECK(message_on(std::string(valid_text) + "subsection Walls\n") ==
        "cube.prm: the subsection 'Walls' of line 34 is not closed: an 'end' is missing.");
  CHECK(message_with("Density") ==
        "cannot understand this; write --set \"Section/Name=value\", such as --set "
        "\"Bodies/cube/Density=1000\".");
  CHECK_THROWS_WITH(
    read_parameter_file("no such file.prm"),
    "cannot read the parameter file 'no such file.prm': No such file or directory.");
}

// Letters left out and names of other sections: the right name is known, so the message has to
// offer it.
TEST_CASE("Messages on unknown names", "[parameters]")
{
  CHECK(message_on(with_line("set Density", "set Densty")) ==
        "cube.prm, line 12: there is no parameter 'Densty' in subsection Bodies/cube; did you mean "
        "'Density'?");
  CHECK(message_on(with_line("subsection Magnets", "subsection Magnet")) ==
        "cube.prm, line 24: there is no subsection 'Magnet'; did you mean 'Magnets'?");
  CHECK(message_on(with_line("subsection cube", "subsection cubes")) ==
        "cube.prm, line 8: there is no subsection 'cubes' in subsection Bodies ('Bodies/List of "
        "bodies' is 'cube'); did you mean 'cube'?");
  CHECK(
    message_on(with_line("List of bodies", "List of bodys")) ==
    "cube.prm, line 7: there is no parameter 'List of bodys' in subsection Bodies; did you mean "
    "'List of bodies'?");
  CHECK(message_with("Bodies/cube/Denisty=1") ==
        "there is no parameter 'Denisty' in subsection Bodies/cube; did you mean 'Density'?");
  CHECK(message_with("Bodies/ball/Density=1") ==
        "there is no subsection 'ball' in subsection Bodies ('Bodies/List of bodies' is 'cube').");
  CHECK(message_with("Cell size=1") ==
        "there is no parameter 'Cell size' outside of all subsections; did you mean 'Box/Cell "
        "size'?");
  CHECK(message_with("Colour=red") ==
        "there is no parameter 'Colour' outside of all subsections; 'magmpm --print-parameters' "
        "lists all.");
}

// Values that are no number, none, or beyond the range that the manual gives, which the message
// repeats.
TEST_CASE("Messages on values out of range", "[parameters]")
{
  CHECK(message_on(with_line("set Density = 1000", "set Density = heavy")) ==
        "cube.prm, line 12: Bodies/cube/Density = heavy: must be a number > 0 [kg/m^3]. (Mass per "
        "undeformed volume.)");
  CHECK(message_on(with_line("    set Density = 1000\n", "")) ==
        "cube.prm: Bodies/cube/Density is not given; it must be a number > 0 [kg/m^3]. (Mass per "
        "undeformed volume.)");
  CHECK(message_with("End time=0") ==
        "End time = 0: must be a number > 0 [s]. (Simulated time at which the run ends.)");
  CHECK(
    message_with("Output/Frame interval=-1") ==
    "Output/Frame interval = -1: must be a number > 0 [s]. (Simulated time between two frames.)");
  CHECK(message_with("Materials/clay/Poisson ratio=0.5") ==
        "Materials/clay/Poisson ratio = 0.5: must be a number above -1 and below 0.5. (Transverse "
        "contraction of a solid, together with Young's modulus.)");
  CHECK(message_with("Gravity=0, -9.81") ==
        "Gravity: '0, -9.81' has 2 components, not 3. Give 3 expressions of the time t [s], "
        "separated by semicolons, such as '0.5; 0.5; 0.2 + 0.1*t'.");
  CHECK(message_with("Bodies/cube/Particles per edge=1.5") ==
        "Bodies/cube/Particles per edge = 1.5: must be an integer from 1 to 8. (Particles along an "
        "edge of a lattice cell: 2 means 8 per cell in 3D.)");
  CHECK(
    message_with("Walls/Lower z=sticky") ==
    "Walls/Lower z = sticky: must be one of: stick, slip, separate, open. (What material does at "
    "this face of the box; open: it passes.)");
  CHECK(
    message_with("Output/Field quantities=H, D") ==
    "Output/Field quantities = H, D: must be any of: potential, H_int, H, M, B, number_density. "
    "(What is written of the fields.)");
  CHECK(message_with("Dimension=4") == "Dimension = 4: must be 2 or 3.");
  CHECK(message_with("Bodies/List of bodies=cube, cube") ==
        "Bodies/List of bodies = cube, cube: the name 'cube' is there twice; names must differ.");
  CHECK(
    message_with("Bodies/List of bodies=my cube") ==
    "Bodies/List of bodies = my cube: the name 'my cube' must consist of letters, digits, _ and "
    "-, since it becomes part of headings. Names are separated by commas.");
}

// Edges and spacings that do not fit: the nearest good values were worked out by hand.
TEST_CASE("Messages on the box", "[parameters]")
{
  CHECK(message_with("Box/Upper corner=1, 1, 1.1") ==
        "Box/Upper corner = 1, 1, 1.1: the edge along z is 17.6 cells, but must be a multiple of 4 "
        "cells. Good values near: upper corner at z = 1 or 1.25 m, or Cell size = 0.06875 m (16 "
        "cells).");
  CHECK(message_with("Box/Upper corner=1, 0, 1") ==
        "Box/Upper corner = 1, 0, 1: along y it must lie above Box/Lower corner (0 m).");
  CHECK(message_with("Box/Cell size=1e-7") ==
        "Box/Cell size = 1e-7: that makes 1e+07 cells along x; at most 1e6 are possible. Choose "
        "larger cells.");
}

// Bodies outside of the box, without extent or into one another, by lengths known from their
// corners.
TEST_CASE("Messages on bodies", "[parameters]")
{
  CHECK(message_with("Bodies/cube/Upper corner=0.75, 0.75, 1.2") ==
        "Bodies/cube/Upper corner = 0.75, 0.75, 1.2: the body reaches to z = 1.2 m, outside of the "
        "box, which is from 0 to 1 m there. Move the body or enlarge the box.");
  CHECK(message_with("Bodies/cube/Upper corner=0.75, 0.1, 0.75") ==
        "Bodies/cube/Upper corner = 0.75, 0.1, 0.75: along y it must lie above Bodies/cube/Lower "
        "corner (0.25 m).");
  CHECK(message_with("Bodies/cube/Material=klay") ==
        "Bodies/cube/Material = klay: there is no material of this name. Materials/List of "
        "materials is 'clay'; did you mean 'clay'?");
  CHECK(
    message_with("Bodies/cube/Arrangement=face-centred", {"Bodies/cube/Particles per edge=1"}) ==
    "Bodies/cube/Arrangement = face-centred: with Particles per edge = 1 every other cell would be "
    "empty; it takes 2 or more.");
  CHECK(message_with("Bodies/cube/Shape=sphere") ==
        "cube.prm: Bodies/cube/Centre is not given: Shape = sphere needs it.");
  CHECK(message_with("Bodies/cube/Radius=1") ==
        "Bodies/cube/Radius = 1: Shape = box does not use it; remove this line or change that.");
  CHECK(message_with("Bodies/cube/Axis=0, 0, 0",
                     {"Bodies/cube/Shape=cylinder",
                      "Bodies/cube/Lower corner=",
                      "Bodies/cube/Upper corner=",
                      "Bodies/cube/Centre=0.5, 0.5, 0.6",
                      "Bodies/cube/Radius=0.1",
                      "Bodies/cube/Length=0.1"}) ==
        "Bodies/cube/Axis = 0, 0, 0: it must have a length greater than 0.");
  CHECK(message_with("Bodies/List of bodies=") ==
        "Bodies/List of bodies is not given: a scene needs at least one body.");
  CHECK(
    message_with("Bodies/List of bodies=cube, b",
                 {"Bodies/b/Material=clay",
                  "Bodies/b/Density=1",
                  "Bodies/b/Shape=sphere",
                  "Bodies/b/Centre=0.5, 0.5, 0.8",
                  "Bodies/b/Radius=0.1"}) ==
    "Bodies/List of bodies = cube, b: the bodies 'cube' and 'b' overlap at the start; move them "
    "apart.");
}

// Moduli given twice or not at all, and values without meaning for a law.
TEST_CASE("Messages on materials", "[parameters]")
{
  CHECK(message_with("Materials/clay/Shear modulus=1") ==
        "cube.prm: Materials/clay/Mechanical law = neo-Hookean: the moduli are given in two ways. "
        "Give either Young's modulus and Poisson ratio, or Shear modulus and Lame lambda.");
  CHECK(message_with("Materials/clay/Young's modulus=", {"Materials/clay/Poisson ratio="}) ==
        "cube.prm: Materials/clay/Mechanical law = neo-Hookean: the moduli are given in no way. "
        "Give either Young's modulus and Poisson ratio, or Shear modulus and Lame lambda.");
  CHECK(message_with("Materials/clay/Poisson ratio=") ==
        "Materials/clay/Poisson ratio is not given: the other one of this pair needs it.");
  CHECK(
    message_with("Materials/clay/Lame lambda=-1",
                 {"Materials/clay/Young's modulus=",
                  "Materials/clay/Poisson ratio=",
                  "Materials/clay/Shear modulus=1.5"}) ==
    "Materials/clay/Lame lambda = -1: must be above -2/3 of the Shear modulus (-1 Pa): with less "
    "the material has no resistance to compression.");
  CHECK(message_with("Materials/clay/Viscosity=1") ==
        "Materials/clay/Viscosity = 1: Mechanical law = neo-Hookean does not use it; remove this "
        "line or change that.");
  CHECK(message_with("Materials/clay/Mechanical law=viscoelastic fluid") ==
        "cube.prm: Materials/clay/Bulk modulus is not given: Mechanical law = viscoelastic fluid "
        "needs it.");
  CHECK(message_with("Materials/clay/Grain moment=1e-19") ==
        "cube.prm, line 20: Materials/clay/Saturation magnetization = 8e4: the magnetization is "
        "given in two ways. Give either Saturation magnetization and Initial susceptibility, or "
        "Grain moment and Grain number density.");
  CHECK(message_with("Materials/clay/Saturation magnetization=") ==
        "Materials/clay/Saturation magnetization is not given: Magnetization law = Langevin needs "
        "it.");
  CHECK(message_with("Materials/clay/Initial susceptibility=",
                     {"Magnetics/Magnetization law=linear"}) ==
        "Materials/clay/Initial susceptibility is not given: a magnetic material needs it.");
}

// Grains of absurd properties would give a medium of no, infinite or negative susceptibility, which
// the potential problem has no solution for: they are refused with parameter, value and what is
// allowed.
TEST_CASE("Messages on absurd grains", "[parameters]")
{
  for (const std::string value : {"0", "-300", "1e-300", "nan", "inf", "20000"})
    CHECK(message_with("Magnetics/Temperature=" + value) ==
          "Magnetics/Temperature = " + value +
            ": must be a number from 1 to 10000 [K]. (Of the grains; it relates their moment and "
            "number density to M_s and chi_0.)");

  const std::vector<std::string> grains = {"Materials/clay/Saturation magnetization=",
                                           "Materials/clay/Initial susceptibility="};
  const auto message_with_grains = [&](const std::string &moment, const std::string &density) {
    std::vector<std::string> others = grains;
    others.push_back("Materials/clay/Grain number density=" + density);
    return message_with("Materials/clay/Grain moment=" + moment, others);
  };
  CHECK(message_with_grains("1.09e-19", "7.55e23") == "");
  for (const std::string value : {"0", "-1e-19", "nan"})
    CHECK(message_with_grains(value, "7.55e23") ==
          "Materials/clay/Grain moment = " + value +
            ": must be a number > 0 [A m^2]. (Magnetic moment m of one grain, together with the "
            "grain number density, instead of M_s = n m and chi_0 = mu_0 n m^2/(3 k_B T).)");
  for (const std::string value : {"0", "-7e23", "nan"})
    CHECK(message_with_grains("1.09e-19", value)
            .find("Materials/clay/Grain number density = " + value +
                  ": must be a number > 0 [1/m^3].") != std::string::npos);
  CHECK(message_with_grains("1", "7.55e23") ==
        "Materials/clay/Grain moment = 1: it gives the material the initial susceptibility "
        "7.63539e+37, which must be above 0 and at most 1e+06. Are the units right?");
  CHECK(message_with_grains("1e-300", "7.55e23") ==
        "Materials/clay/Grain moment = 1e-300: it gives the material the initial susceptibility 0, "
        "which must be above 0 and at most 1e+06. Are the units right?");
  CHECK(message_with("Materials/clay/Initial susceptibility=1e7") ==
        "Materials/clay/Initial susceptibility = 1e7: it gives the material the initial "
        "susceptibility 1e+07, which must be above 0 and at most 1e+06. Are the units right?");
  CHECK(message_with("Materials/clay/Initial susceptibility=1e-300",
                     {"Materials/clay/Saturation magnetization=1e300"}) ==
        "Materials/clay/Initial susceptibility = 1e-300: it gives the material the saturation "
        "magnetization 1e+300 A/m with inf grains per m^3, which must be finite. Are the units "
        "right?");
}

// The box of the potential holds the mechanical box, or material would lie outside of it.
TEST_CASE("Messages on the box of the potential", "[parameters]")
{
  for (const std::string value : {"0.99", "0", "-2"})
    CHECK(message_with("Magnetics/Potential box factor=" + value) ==
          "Magnetics/Potential box factor = " + value +
            ": must be a number >= 1. (Edge of the box of the potential over that of the "
            "mechanical box, at least, where its faces are open.)");
  CHECK(message_with("Magnetics/Potential box factor=1") == "");

  // Keys of blocks have 21 bits for a coordinate: larger boxes would mix them up without a word.
  CHECK_THAT(message_with("Magnetics/Potential box factor=1e9"),
             Catch::StartsWith("Magnetics/Potential box factor = 1e9: that makes ") &&
               Catch::EndsWith(" cells along x; at most 4.17792e+06 are possible. Choose a smaller "
                               "factor, or larger cells."));
}

// A magnet in a body by a depth known from radius and corner, and what a kind of magnet does not
// have.
TEST_CASE("Messages on magnets", "[parameters]")
{
  CHECK(message_with("Magnets/magnet/Position=0.5; 0.5; 0.4") ==
        "Magnets/magnet/Position = 0.5; 0.5; 0.4: this solid magnet (radius 0.125 m, at 0.5, 0.5, "
        "0.4 m) overlaps the body 'cube' by 0.025 m at the start. Move one of them, or set "
        "Magnets/magnet/Contact = none.");
  CHECK(message_with("Magnets/magnet/Position=0.5; 0.5; 0.4", {"Magnets/magnet/Contact=none"}) ==
        "");
  CHECK(message_with("Magnets/magnet/Position=0.5; 0.5")
          .rfind("Magnets/magnet/Position: '0.5; 0.5' has 2 components, not 3.", 0) == 0);
  CHECK(message_with("Magnets/magnet/Magnetization=")
          .rfind("Magnets/magnet/Magnetization is not given: Type = magnetized sphere needs it.",
                 0) == 0);
  CHECK(message_with("Magnets/magnet/Contact=slip",
                     {"Magnets/magnet/Type=uniform field",
                      "Magnets/magnet/Field=0; 0; 1",
                      "Magnets/magnet/Position=",
                      "Magnets/magnet/Magnetization=",
                      "Magnets/magnet/Radius="}) ==
        "Magnets/magnet/Contact = slip: a uniform field has no surface; set it to none.");
}

// Each kind of source takes its own parameters, which are all it takes.
TEST_CASE("Messages on the kinds of magnets", "[parameters]")
{
  const std::vector<std::string> no_sphere = {"Magnets/magnet/Radius=",
                                              "Magnets/magnet/Position=0.5; 0.5; 0.1"};
  const auto message_of_kind = [&](const std::string &kind, std::vector<std::string> others) {
    others.insert(others.begin(), no_sphere.begin(), no_sphere.end());
    others.push_back("Magnets/magnet/Type=" + kind);
    return without_place(message_on(valid_text, others));
  };
  const std::string magnet = "Magnets/magnet/", none = magnet + "Contact=none",
                    unmagnetized = magnet + "Magnetization=";
  CHECK(message_of_kind("cuboid", {magnet + "Size=0.1, 0.1, 0.1"}) == "");
  CHECK(message_of_kind("cuboid", {}) ==
        "Magnets/magnet/Size is not given: Type = cuboid needs it.");
  CHECK(message_of_kind("cuboid", {magnet + "Size=0.1, 0, 0.1"}) ==
        "Magnets/magnet/Size = 0.1, 0, 0.1: all edges must be greater than 0.");
  CHECK(
    message_of_kind("cuboid", {magnet + "Size=0.1, 0.1, 0.1", magnet + "Length=1"}) ==
    "Magnets/magnet/Length = 1: Type = cuboid does not use it; remove this line or change that.");
  CHECK(message_of_kind("cuboid", {magnet + "Size=0.1, 0.1, 0.1", unmagnetized})
          .rfind("Magnets/magnet/Magnetization is not given: Type = cuboid needs it. Or give "
                 "Remanence, mu_0 times as much [T].",
                 0) == 0);
  CHECK(message_of_kind("cuboid", {magnet + "Size=0.1, 0.1, 0.1", magnet + "Remanence=0; 0; 1"}) ==
        "Magnets/magnet/Remanence = 0; 0; 1: the magnetization is given in two ways. Give either "
        "Magnetization or Remanence.");
  CHECK(message_of_kind("cylinder",
                        {magnet + "Radius=0.1", magnet + "Length=0.1", magnet + "Axis=0, 0, 0"}) ==
        "Magnets/magnet/Axis = 0, 0, 0: it must have a length greater than 0.");
  CHECK(
    message_of_kind("current loop",
                    {none,
                     unmagnetized,
                     magnet + "Radius=0.1",
                     magnet + "Current=3",
                     magnet + "Conductor radius=0.2"}) ==
    "Magnets/magnet/Conductor radius = 0.2: it must be smaller than the Radius of the loop (0.1 "
    "m).");
  CHECK(message_of_kind("straight wire",
                        {unmagnetized, magnet + "Current=3", magnet + "Conductor radius=0.2"}) ==
        "Magnets/magnet/Contact = separate: a straight wire has no surface; set "
        "it to none.");
  CHECK(
    message_of_kind("point dipole", {none, magnet + "Moment=0; 0; 1", magnet + "Radius=0.01"}) ==
    "Magnets/magnet/Magnetization = 0; 0; 1e6: Type = point dipole does not "
    "use it; remove this line or change that.");
  CHECK(message_of_kind("magnetized mesh", {magnet + "File=nowhere.stl"})
          .find("Magnets/magnet/File = nowhere.stl: there is no such file") != std::string::npos);
}

// Ways to move that exclude each other, and those that may be given together.
TEST_CASE("Messages on the motion of magnets", "[parameters]")
{
  const std::string magnet = "Magnets/magnet/";
  CHECK(message_with(magnet + "Rotation=0; 0; t", {magnet + "Strength=1 - t"}) == "");
  CHECK(message_with(magnet + "Key frames=0, 0.5, 0.5, 0.25; 1, 0.5, 0.5, 0.2",
                     {magnet + "Position="}) == "");
  CHECK(message_with(magnet + "Position=") ==
        "Magnets/magnet/Position is not given: Type = magnetized sphere needs it, or Key frames.");
  CHECK(without_place(message_with(magnet + "Key frames=0, 0.5, 0.5, 0.25")) ==
        "Magnets/magnet/Position = 0.5; 0.5; 0.25: Key frames say this already. "
        "Give either of them.");
  CHECK(message_with(magnet + "Key frames=0, 0.5, 0.5", {magnet + "Position="})
          .find("Magnets/magnet/Key frames: the row '0, 0.5, 0.5' has 3 numbers.") !=
        std::string::npos);
  CHECK(message_with(magnet + "Key frames=nowhere.csv", {magnet + "Position="})
          .find("Magnets/magnet/Key frames = nowhere.csv: there is no such file") !=
        std::string::npos);
  CHECK(message_with(magnet + "Interpolation=smooth") ==
        "Magnets/magnet/Interpolation = smooth: it is used between Key frames only, which are not "
        "given.");
  CHECK(message_with(magnet + "Rotation=0; t")
          .find("Magnets/magnet/Rotation: '0; t' has 2 components, not 3.") != std::string::npos);
  CHECK(
    message_with(magnet + "Strength=1; 2")
      .find(
        "Magnets/magnet/Strength: '1; 2' has 2 components, not 1. Give one expression of the time "
        "t [s], such as '0.2 + 0.1*t'.") != std::string::npos);
  CHECK(message_with(magnet + "Friction=0.2", {magnet + "Contact=stick"}) ==
        "Magnets/magnet/Friction = 0.2: there is friction with Contact = slip or separate only.");
}

// A cube of two named shapes, one fault at a time: the message has to name the shape at fault, which may be one
// that another is made of, and the list from which names are taken.
TEST_CASE("Messages on shapes made of others", "[parameters]")
{
  const std::string shapes = R"(subsection Shapes
  set List of shapes = block, hole, nut
  subsection block
    set Lower corner = 0.25, 0.25, 0.5
    set Upper corner = 0.75, 0.75, 0.75
  end
  subsection hole
    set Shape = cylinder
    set Centre = 0.5, 0.5, 0.5
    set Radius = 0.125
    set Axis = 0, 0, 1
    set Length = 1
  end
  subsection nut
    set Shape = difference
    set Of = block, hole
  end
end
)";
  const std::string corners =
    "    set Lower corner = 0.25, 0.25, 0.5\n    set Upper corner = 0.75, 0.75, 0.75\n";
  std::string text = valid_text;
  text.replace(
    text.find(corners), corners.size(), "    set Shape = difference\n    set Of = block, hole\n");
  text += shapes;
  CHECK(message_on(text) == "");
  CHECK(message_on(text, {"Bodies/cube/Shape=union", "Bodies/cube/Of=block, nut"}) == "");
  CHECK(
    message_on(text, {"Bodies/cube/Of=block, bolt"}) ==
    "--set \"Bodies/cube/Of=block, bolt\": Bodies/cube/Of = block, bolt: there is no shape 'bolt'. "
    "Shapes/List of shapes is 'block, hole, nut'.");
  CHECK(message_on(text, {"Bodies/cube/Of=block"}) ==
        "--set \"Bodies/cube/Of=block\": Bodies/cube/Of = block: it takes at least two names of "
        "Shapes/List of shapes, separated by commas.");
  CHECK(message_on(text,
                   {"Shapes/block/Shape=union",
                    "Shapes/block/Lower corner=",
                    "Shapes/block/Upper corner=",
                    "Shapes/block/Of=hole, nut"}) ==
        "--set \"Shapes/block/Of=hole, nut\": Shapes/block/Of = hole, nut: it is made of itself: "
        "block, nut, block.");
  CHECK(message_on(text, {"Bodies/cube/Of=block, block"}) ==
        "--set \"Bodies/cube/Of=block, block\": Bodies/cube/Of: nothing is left of it; move its "
        "parts.");
  CHECK(
    message_on(text, {"Shapes/hole/Radius="}) ==
    "--set \"Shapes/hole/Radius=\": Shapes/hole/Radius is not given: Shape = cylinder needs it.");
  CHECK(message_on(text, {"Shapes/hole/Shape=points"})
          .find("must be one of: box, sphere, ring, union, "
                "difference, intersection, cylinder, tube, mesh.") != std::string::npos);
  CHECK(message_on(text, {"Shapes/hole/Shape=tube"}) ==
        "cube.prm: Shapes/hole/Inner radius is not given: Shape = tube needs it.");
  CHECK(message_on(text, {"Shapes/hole/Shape=tube", "Shapes/hole/Inner radius=0.125"}) ==
        "--set \"Shapes/hole/Inner radius=0.125\": Shapes/hole/Inner radius = 0.125: it must be "
        "smaller "
        "than Shapes/hole/Radius (0.125 m).");
  CHECK(
    message_on(text,
               {"Shapes/block/Upper corner=0.75, 0.75, 1.5", "Shapes/hole/Centre=0.5, 0.5, 0.7"})
      .find("Bodies/cube/Of = block, hole: the body reaches to z = 1.5 m, outside of the box") !=
    std::string::npos);
}

// The cube begins at z = 0.5. Bars and a cylinder reach into it only as they are turned.
TEST_CASE("Messages on magnets inside of bodies", "[parameters]")
{
  const std::string magnet           = "Magnets/magnet/";
  const std::vector<std::string> bar = {
    magnet + "Radius=", magnet + "Size=0.5, 0.1, 0.1", magnet + "Position=0.5; 0.5; 0.3"};
  CHECK(message_with(magnet + "Type=cuboid", bar) == "");
  std::vector<std::string> upright = bar;
  upright.push_back(magnet + "Rotation=0; pi/2; 0");
  CHECK(
    without_place(message_with(magnet + "Type=cuboid", upright)) ==
    "Magnets/magnet/Position = 0.5; 0.5; 0.3: this solid magnet (at 0.5, 0.5, 0.3 m) overlaps the "
    "body 'cube' at the start. Move one of them, or set Magnets/magnet/Contact = none.");
  upright.push_back(magnet + "Contact=none");
  CHECK(message_with(magnet + "Type=cuboid", upright) == "");
  CHECK(
    without_place(message_with(magnet + "Type=point dipole",
                               {magnet + "Contact=none",
                                magnet + "Magnetization=",
                                magnet + "Moment=0; 0; 1",
                                magnet + "Position=0.5; 0.5; 0.49",
                                magnet + "Radius=0.02"})) ==
    "Magnets/magnet/Position = 0.5; 0.5; 0.49: the core of this dipole (radius 0.02 m, at 0.5, "
    "0.5, 0.49 m) overlaps the body 'cube' by 0.01 m at the start. Move one of them, or make its "
    "Radius smaller.");
}

// A fixed step beside the limits of a variable one, and steps that fit into no frame.
TEST_CASE("Messages on the time step", "[parameters]")
{
  CHECK(message_with("Time step/Time step=1") ==
        "Time step/Time step = 1: it must not be longer than Output/Frame interval (0.002 s).");
  CHECK(message_with("Time step/Time step=0") ==
        "Time step/Time step = 0: must be auto, or a number > 0 [s]. (dt of all steps; auto: each "
        "as long as the limits below allow.)");
  CHECK(message_with("Time step/Maximum=1e-3", {"Time step/Time step=1e-4"}) ==
        "Time step/Maximum = 1e-3: a given Time step/Time step does not use it; remove this line "
        "or change that.");
}

// A valid scene in the plane, changed into what has a meaning in space only.
TEST_CASE("Messages on what two dimensions do not have", "[parameters]")
{
  const std::string text = R"(set Dimension = 2
set End time = 1
subsection Box
  set Upper corner = 1, 1
  set Cell size = 0.0625
end
subsection Bodies
  set List of bodies = disc
  subsection disc
    set Material = gel
    set Density = 1000
    set Shape = sphere
    set Centre = 0.5, 0.5
    set Radius = 0.1
  end
end
subsection Materials
  set List of materials = gel
  subsection gel
    set Shear modulus = 1000
    set Lame lambda = 0
  end
end
)";
  CHECK(message_on(text) == "");
  CHECK(message_on(text, {"Bodies/disc/Shape=cylinder"}) ==
        "--set \"Bodies/disc/Shape=cylinder\": Bodies/disc/Shape = cylinder: must be one of: box, "
        "sphere, ring, union, difference, intersection, points. (Its shape; a sphere is a disc in "
        "2D, a ring is "
        "a torus, in 2D a disc with a hole; a cylinder, a tube and a mesh need "
        "Dimension = 3.)");
  CHECK(
    message_on(text, {"Bodies/disc/Length=1"}) ==
    "--set \"Bodies/disc/Length=1\": there is no parameter 'Length' in subsection Bodies/disc: a "
    "cylinder needs Dimension = 3.");
  const std::vector<std::string> wire = {"Magnets/List of magnets=w",
                                         "Magnets/w/Type=straight wire",
                                         "Magnets/w/Current=1",
                                         "Magnets/w/Conductor radius=0.01",
                                         "Magnets/w/Position=0.1; 0.1"};
  const auto with_wire                = [&](const std::string &more) {
    std::vector<std::string> all = wire;
    all.push_back(more);
    return message_on(text, all);
  };
  CHECK(message_on(text, wire) == "");
  CHECK(with_wire("Magnets/w/Length=1") ==
        "--set \"Magnets/w/Length=1\": there is no parameter 'Length' in subsection Magnets/w: a "
        "wire has no ends in 2D, and a cylinder needs Dimension = 3.");
  CHECK(with_wire("Magnets/w/Rotation=t")
          .find("Magnets/w/Rotation = t: a wire, which is along z in 2D, does not use it") !=
        std::string::npos);
  CHECK(with_wire("Magnets/w/Type=current loop")
          .find("must be one of: uniform field, point dipole, magnetized sphere, cuboid, straight "
                "wire. (Kind of source (doc/magnets.md).") != std::string::npos);
  CHECK(message_on(text, {"Walls/Lower z=slip"}) ==
        "--set \"Walls/Lower z=slip\": there is no parameter 'Lower z' in subsection Walls: this "
        "face needs Dimension = 3.");
  CHECK(message_on(text, {"Bodies/disc/Angular velocity=1, 2, 3"}) ==
        "--set \"Bodies/disc/Angular velocity=1, 2, 3\": Bodies/disc/Angular velocity = 1, 2, 3: "
        "must be a number [rad/s]. (Spin at the start about the centre of mass.)");
}

namespace
{
  /** The valid scene with a free rigid box above the cube. */
  std::string
  with_raft(const std::string &lines)
  {
    return std::string(valid_text) +
           "subsection Rigid bodies\n  set List of rigid bodies = raft\n  subsection raft\n"
           "    set Lower corner = 0.25, 0.25, 0.76\n    set Upper corner = 0.75, 0.75, 0.96\n" +
           lines + "  end\nend\n";
  }
} // namespace

TEST_CASE("a rigid body that is not what it should be", "[parameters]")
{
  // Each fault on its own; the scene itself is valid, free and scripted.
  CHECK(message_on(with_raft("set Density = 500\n")).empty());
  CHECK(message_on(with_raft("set Motion = scripted\nset Position = 0.5; 0.5; 0.86 + 0.1*t\n"))
          .empty());
  CHECK_THAT(message_on(with_raft("")),
             Catch::Contains(
               "with Motion = free exactly one of Density and Mass must be given, but "
               "none is."));
  CHECK_THAT(message_on(with_raft("set Density = 500\nset Mass = 1\n")),
             Catch::Contains("but both are."));
  CHECK_THAT(message_on(with_raft("set Motion = scripted\nset Density = 500\n")),
             Catch::Contains("Rigid bodies/raft/Density"));
  CHECK_THAT(message_on(with_raft("set Density = 500\nset Position = 0; 0; 0\n")),
             Catch::Contains("Rigid bodies/raft/Position"));
  CHECK_THAT(message_on(with_raft("set Density = 500\n"),
                        {"Rigid bodies/raft/Lower corner=0.25, 0.25, 0.7"}),
             Catch::Contains("it overlaps the body 'cube' at the start; move them apart."));
  CHECK_THAT(message_on(with_raft("set Density = 500\n"),
                        {"Rigid bodies/raft/Upper corner=0.75, 0.75, 1.2"}),
             Catch::Contains("outside of the box"));
  CHECK_THAT(message_on(with_raft("set Motion = scripted\nset Position = 0.5; 0.5\n")),
             Catch::Contains("has 2 components, not 3"));
  CHECK_THAT(message_on(with_raft("set Motion = scripted\nset Key frames = 0, 0.5, 0.5\n")),
             Catch::Contains("Rigid bodies/raft/Key frames: the row '0, 0.5, 0.5' has 3 numbers."));
  CHECK_THAT(message_on(with_raft("set Motion = scripted\nset Key frames = nowhere.csv\n")),
             Catch::Contains("Rigid bodies/raft/Key frames = nowhere.csv: there is no such file"));
}

TEST_CASE("a free magnet that cannot be one", "[parameters]")
{
  // A free magnet needs mass and a place at the start; a magnet that is not free must not have mass.
  CHECK(message_on(valid_text, {"Magnets/magnet/Free=true", "Magnets/magnet/Mass=1"}).empty());
  CHECK_THAT(message_with("Magnets/magnet/Mass=1"), Catch::Contains("Free = false"));
  CHECK_THAT(message_with("Magnets/magnet/Free=true"),
             Catch::Contains("with Free = true exactly one of Density and Mass must be given"));
  CHECK_THAT(message_on(valid_text,
                        {"Magnets/magnet/Free=true",
                         "Magnets/magnet/Mass=1",
                         "Magnets/magnet/Position=0.5; 0.5; 0.25 + t"}),
             Catch::Contains("it must not depend on t"));
  CHECK_THAT(message_on(valid_text,
                        {"Magnets/magnet/Free=true",
                         "Magnets/magnet/Mass=1",
                         "Magnets/magnet/Type=uniform field",
                         "Magnets/magnet/Field=0; 0; 1",
                         "Magnets/magnet/Position=",
                         "Magnets/magnet/Magnetization=",
                         "Magnets/magnet/Radius=",
                         "Magnets/magnet/Contact=none"}),
             Catch::Contains("a uniform field is nowhere; set it to false."));
}

// What cannot be hydrostatic: a solid, what has no shape, and what has no weight.
TEST_CASE("Messages on hydrostatic bodies", "[parameters]")
{
  const std::string hydrostatic = "Bodies/cube/Initial state=hydrostatic";
  CHECK(
    message_with(hydrostatic) ==
    "Bodies/cube/Initial state = hydrostatic: the material 'clay' is solid; hydrostatic are fluids "
    "alone. Set it to undeformed.");
  std::vector<std::string> fluid = {"Materials/clay/Mechanical law=viscoelastic fluid",
                                    "Materials/clay/Young's modulus=",
                                    "Materials/clay/Poisson ratio=",
                                    "Materials/clay/Viscosity=1",
                                    "Materials/clay/Bulk modulus=1e6"};
  CHECK(message_with(hydrostatic, fluid) == "");
  fluid.push_back("Gravity=0, 0, -9.81*sin(t)");
  CHECK(message_with(hydrostatic, fluid) == "Bodies/cube/Initial state = hydrostatic: Gravity is 0 "
                                            "at the start: nothing has weight. Set it "
                                            "to undeformed, or Gravity to another value.");
}

// What surface tension needs: a fluid, sound that is fast enough, a wall along which its line moves.
TEST_CASE("Surface tension and contact angles are checked", "[parameters]")
{
  const std::vector<std::string> fluid = {"Materials/clay/Mechanical law=viscoelastic fluid",
                                          "Materials/clay/Young's modulus=",
                                          "Materials/clay/Poisson ratio=",
                                          "Materials/clay/Viscosity=0.1",
                                          "Materials/clay/Bulk modulus=59",
                                          "Walls/Lower z=slip"};
  CHECK(message_with("Materials/clay/Surface tension=0.073", fluid) == "");
  CHECK_THAT(message_with("Materials/clay/Surface tension=0.075", fluid),
             Catch::Contains("Materials/clay/Surface tension = 0.075: sound is too slow for it") &&
               Catch::Contains("to at least 50 gamma/dx = 60 Pa"));
  CHECK(
    message_with("Materials/clay/Surface tension=0.07") ==
    "Materials/clay/Surface tension = 0.07: Mechanical law = neo-Hookean does not use it; remove "
    "this line or change that.");
  CHECK(message_with("Walls/Lower z contact angle=40", fluid) == "");
  CHECK_THAT(
    message_with("Walls/Lower x contact angle=40", fluid),
    Catch::Contains("Walls/Lower x contact angle = 40: it needs 'Lower x' = slip or separate"));
  CHECK_THAT(message_with("Walls/Lower z contact angle=181", fluid),
             Catch::Contains("a number from 0 to 180"));
}

namespace
{
  /** The valid scene with a second cube on top of the first, in contact group 1, and contacts. */
  std::string
  with_two_groups(const std::string &contacts)
  {
    std::string text = valid_text;
    text.replace(text.find("List of bodies = cube"), 21, "List of bodies = cube, lid");
    const std::string before = "end\nsubsection Materials";
    text.insert(text.find(before),
                "  subsection lid\n    set Material = clay\n    set Density = 1000\n"
                "    set Contact group = 1\n    set Lower corner = 0.25, 0.25, 0.75\n"
                "    set Upper corner = 0.75, 0.75, 0.875\n  end\n");
    return text + contacts;
  }

  std::string
  contact(const std::string &name, const std::string &lines)
  {
    return "  subsection " + name + "\n" + lines + "  end\n";
  }
} // namespace

TEST_CASE("a contact between groups that is not what it should be", "[parameters]")
{
  // The scene is valid with and without a contact; each fault on its own is named with what is allowed.
  const auto contacts = [](const std::string &list, const std::string &lines) {
    return message_on(with_two_groups("subsection Contacts\n  set List of contacts = " + list +
                                      "\n" + lines + "end\n"));
  };
  CHECK(message_on(with_two_groups("")) == "");
  CHECK(contacts(
          "a", contact("a", "set Groups = 1, 0\nset Condition = slip\nset Friction = 1\n")) == "");
  CHECK_THAT(contacts("a", contact("a", "set Condition = slip\n")),
             Catch::Contains("Contacts/a/Groups"));
  CHECK_THAT(contacts("a", contact("a", "set Groups = 0, 0\n")),
             Catch::Contains("the two are the same: bodies of one group stick together. Name two "
                             "groups."));
  CHECK_THAT(contacts("a", contact("a", "set Groups = 0, 0.5\n")),
             Catch::Contains("groups are whole numbers from 0 on"));
  CHECK_THAT(contacts("a, b",
                      contact("a", "set Groups = 0, 1\n") + contact("b", "set Groups = 1, 0\n")),
             Catch::Contains("Contacts/b/Groups = 1, 0: the contact 'a' is about the same two "
                             "groups. Leave one of them out."));
  CHECK_THAT(contacts("a", contact("a", "set Groups = 0, 1\nset Condition = weld\n")),
             Catch::Contains("must be one of: stick, slip, separate"));
}

TEST_CASE("fluids are in contact group 0", "[parameters]")
{
  // They flow around bodies of other groups; the message names the body and its material.
  std::string text        = with_two_groups("");
  const std::string solid = "set Young's modulus = 1e5\n    set Poisson ratio = 0.3\n";
  text.replace(text.find(solid),
               solid.size(),
               "set Mechanical law = viscoelastic fluid\nset Bulk modulus = 1e5\n"
               "set Viscosity = 1\n");
  CHECK_THAT(message_on(text),
             Catch::Contains(
               "Bodies/lid/Contact group = 1: the material 'clay' is a fluid, and fluids "
               "are in group 0. Leave it at 0; give what they are to slip along "
               "another group."));
  CHECK(message_on(text, {"Bodies/lid/Contact group=0"}) == "");
}
