// What the sections Attraction and Rest and a magnetization curve become, and the wording of the
// messages on wrong ones.

#include "../catch.h"
#include "../test_folder.h"

#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameters.h>

#include <fstream>

using namespace magmpm;

namespace
{
  const std::string scene = R"(set End time = 1
set Dimension = 2
subsection Box
  set Upper corner = 1, 1
  set Cell size = 0.0625
end
subsection Bodies
  set List of bodies = drop
  subsection drop
    set Material = fluid
    set Lower corner = 0.25, 0.25
    set Upper corner = 0.75, 0.75
    set Density = 1000
  end
end
subsection Materials
  set List of materials = fluid
  subsection fluid
    set Mechanical law = viscoelastic fluid
    set Bulk modulus = 1e5
    set Viscosity = 1
  end
end
)";

  const std::string magnet = R"(subsection Magnets
  set List of magnets = coil
  subsection coil
    set Field = 0; 1e4
  end
end
)";

  Parameters<2>
  read(const std::string &more, const std::vector<std::string> &overrides = {})
  {
    return read_parameters<2>(parse_parameter_text(scene + more, "drop.prm", overrides));
  }

  std::string
  message_on(const std::string &more, const std::vector<std::string> &overrides = {})
  {
    try
      {
        read(more, overrides);
      }
    catch (const InputError &error)
      {
        const std::string text = error.what();
        return text.substr(text.find(": ") + 2);
      }
    return "";
  }

  /** The curve M = 2 H to 1e4 A/m, then level, in a file. */
  std::string
  curve_file(const std::string &folder)
  {
    const std::string name = folder + "/emg.csv";
    std::ofstream(name) << "H, M\n0, 0\n5e3, 1e4\n1e4, 2e4\n5e4, 2e4\n";
    return name;
  }
} // namespace

// Given, left away, and to match magnets: the values read are those written, and a missing one has
// the default that the manual names.
TEST_CASE("an attraction is there if its strength is", "[parameters]")
{
  CHECK_FALSE(read("").forces.attraction.is_wanted());
  const auto given = read("subsection Attraction\nset Strength = 12.5\nset Point = 0.5, 2\n"
                          "set Bodies = drop\nset Exponent = 4\nend\n")
                       .forces.attraction;
  CHECK(given.is_wanted());
  CHECK_FALSE(given.matches_magnets);
  CHECK(given.acceleration == 12.5);
  CHECK(given.point[1] == 2.);
  CHECK(given.exponent == 4.);
  CHECK(given.core_radius == 0.0625); // dx
  CHECK(given.bodies == std::vector<std::string>{"drop"});

  const std::string matched = "subsection Attraction\nset Strength = match magnets\n"
                              "set Point = 0.5, 2\nend\n";
  const std::string linear  = "Magnetics/Magnetization law=linear";
  const std::string chi     = "Materials/fluid/Initial susceptibility=1";
  const auto parameters     = read(matched + magnet, {linear, chi});
  CHECK(parameters.forces.attraction.matches_magnets);
  CHECK_FALSE(parameters.output.write_fields);
  CHECK(message_on(matched, {linear, chi}).find("there are no magnets to match") !=
        std::string::npos);
  CHECK(message_on(matched + magnet).find("no body is magnetic") != std::string::npos);
}

// Strengths that are none, and parameters that are missing or useless: messages in the words that
// a user meets.
TEST_CASE("a wrong attraction is refused", "[parameters]")
{
  const auto attraction = [](const std::string &lines) {
    return message_on("subsection Attraction\n" + lines + "end\n");
  };
  for (const std::string strength : {"strong", "-1", "0", "5 m/s^2"})
    CHECK(attraction("set Strength = " + strength + "\nset Point = 0, 0\n") ==
          "Attraction/Strength = " + strength +
            ": must be a number > 0 [m/s^2], or 'match magnets'. To have none, remove this line.");
  CHECK(attraction("set Strength = 5\n").find("an Attraction needs it.") != std::string::npos);
  CHECK(attraction("set Point = 0, 0\n").find("an Attraction without Strength does not use it") !=
        std::string::npos);
  CHECK(attraction("set Strength = 5\nset Point = 0, 0\nset Bodies = drip\n")
          .find("there is no body 'drip'. Bodies/List of bodies is 'drop'; did you mean 'drop'?") !=
        std::string::npos);
}

// The values read are those written; a speed without the stop, or the stop without its time, is a
// mistake.
TEST_CASE("rest ends a run only with a speed and a time", "[parameters]")
{
  const auto rest = read("subsection Rest\nset Damping rate = 3\nset Stop when at rest = true\n"
                         "set Speed = 1e-3\nset Time = 0.1\nend\n")
                      .rest;
  CHECK(rest.stops);
  CHECK(rest.damping_rate == 3.);
  CHECK(rest.speed == 1e-3);
  CHECK(rest.duration == 0.1);
  CHECK_FALSE(read("").rest.stops);
  CHECK(message_on("subsection Rest\nset Stop when at rest = true\nset Speed = 1\nend\n")
          .find("Stop when at rest = true needs it.") != std::string::npos);
  CHECK(message_on("subsection Rest\nset Speed = 1\nend\n")
          .find("Stop when at rest = false does not use it") != std::string::npos);
}

// The curve of the file rises as 2 H and saturates at 2e4 A/m, so a factor of 0.5 gives chi_0 = 1
// and 1e4 A/m; without a factor a material is not magnetic.
TEST_CASE("a table needs a file, a material a factor", "[parameters]")
{
  const std::string folder = testing::fresh_folder("magnetization-curve");
  const std::string table  = "Magnetics/Magnetization law=table";
  const std::string file   = "Magnetics/Magnetization curve=" + curve_file(folder);
  const std::string factor = "Materials/fluid/Curve factor=0.5";
  const auto parameters    = read(magnet, {table, file, factor});
  REQUIRE(parameters.magnetics.curve != nullptr);
  CHECK(parameters.magnetics.curve->initial_susceptibility() == Approx(2.));
  CHECK(parameters.materials[0].magnetic.initial_susceptibility == Approx(1.));
  CHECK(parameters.materials[0].magnetic.saturation_magnetization == Approx(1e4));
  CHECK_FALSE(read(magnet, {table, file}).materials[0].magnetic.is_magnetic());

  CHECK(message_on(magnet, {table, factor}).find("Magnetization law = table needs it.") !=
        std::string::npos);
  CHECK(message_on(magnet, {file}).find("Magnetization law is not table") != std::string::npos);
  CHECK(message_on(magnet, {factor}).find("(not table)") != std::string::npos);
  CHECK(message_on(magnet, {table, file, "Materials/fluid/Initial susceptibility=1"})
          .find("Magnetization law = table does not use it") != std::string::npos);
  CHECK(message_on(magnet, {table, "Magnetics/Magnetization curve=nowhere.csv"})
          .find("there is no such file") != std::string::npos);
}
