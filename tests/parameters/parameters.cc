#include "../catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/parameters/parameter_names.h>
#include <magmpm/parameters/parameter_sections.h>
#include <magmpm/parameters/parameters.h>

#include <verification/program/paths.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace magmpm;

namespace
{
  const char *const cube_text = R"(
set Dimension = 3
set End time  = 0.3   # s
subsection Box
  set Upper corner = 1, 1, 0.5
  set Cell size    = 0.0078125
end
subsection Bodies
  set List of bodies = cube, ball
  subsection cube
    set Material     = clay
    set Lower corner = 0.25, 0.25, 0.25
    set Upper corner = 0.5, 0.5, 0.5
    set Density      = 2500
    set Velocity     = 1, 2, -3
  end
  subsection ball
    set Material         = water
    set Shape            = sphere
    set Centre           = 0.7, 0.7, 0.25
    set Radius           = 0.1
    set Density          = 1000
    set Angular velocity = 0, 0, 5
  end
end
subsection Materials
  set List of materials = clay, water
  subsection clay
    set Young's modulus      = 1e6
    set Poisson ratio        = 0.25
    set Grain moment         = 1.09e-19
    set Grain number density = 7.55e23
  end
  subsection water
    set Mechanical law = viscoelastic fluid
    set Bulk modulus   = 1e5
    set Viscosity      = 0.1
  end
end
subsection Magnets
  set List of magnets = magnet
  subsection magnet
    set Type          = magnetized sphere
    set Position      = 0.4; 0.4; \
                        0.1 - 0.1*t
    set Magnetization = 0; 0; 2e6
    set Radius        = 0.1
    set Contact       = slip
  end
end
subsection Magnetics
  subsection Potential box
    set Lower z = shielded
  end
end
)";

  template <int dim>
  Parameters<dim>
  read(const std::string &text, const std::vector<std::string> &overrides = {})
  {
    return read_parameters<dim>(parse_parameter_text(text, "scene.prm", overrides));
  }

  std::vector<std::filesystem::path>
  example_files()
  {
    std::vector<std::filesystem::path> files;
    for (const auto &file :
         std::filesystem::directory_iterator(verification::source_folder() + "/parameter_files"))
      if (file.path().extension() == ".prm")
        files.push_back(file.path());
    return files;
  }
} // namespace

// Solids have FMPM and fluids APIC by default. A solid may have APIC; a fluid has no F that FMPM is for.
TEST_CASE("The transfer is that of the law unless it is given", "[parameters]")
{
  const auto transfer_of = [](const std::string &material, const std::string &value) {
    const Parameters<3> scene = read<3>(cube_text,
                                        {"Materials/" + material + "/Transfer=" + value});
    for (const MaterialParameters &one : scene.materials)
      if (one.name == material)
        return one.transfer;
    throw std::runtime_error("no material " + material);
  };
  CHECK(transfer_of("clay", "auto") == Transfer::fmpm);
  CHECK(transfer_of("clay", "APIC") == Transfer::apic);
  CHECK(transfer_of("water", "auto") == Transfer::apic);
  CHECK(transfer_of("water", "APIC") == Transfer::apic);
  CHECK_THROWS_WITH(
    transfer_of("water", "FMPM"),
    Catch::Matchers::Contains("FMPM is for solids; a fluid has APIC. Leave it out."));
}

// What a parameter file says arrives in the structs of the rooms. The numbers are those of the text.
TEST_CASE("A parameter file fills the parameters of all rooms", "[parameters]")
{
  const Parameters<3> scene = read<3>(cube_text);

  CHECK(scene.end_time == 0.3);
  CHECK(scene.gravity.is_constant());
  CHECK(scene.gravity(0.)[2] == -9.81);
  CHECK(scene.lattice.spacing == 1. / 128.);
  CHECK(scene.lattice.n_cells == Index<3>{{128, 128, 64}});
  CHECK(scene.output.directory == "output-scene");
  CHECK(scene.mesh.shielded == std::array<bool, 6>{{false, false, false, false, true, false}});
  CHECK(scene.magnetics.shielded == scene.mesh.shielded);
  CHECK(scene.mesh.carries_potential);
  CHECK(scene.warnings.empty());

  REQUIRE(scene.bodies.size() == 2);
  CHECK(scene.bodies[0].name == "cube");
  CHECK(scene.bodies[0].shape.upper_corner[1] == 0.5);
  CHECK(scene.bodies[0].velocity[2] == -3.);
  CHECK(scene.bodies[1].shape.type == ShapeType::sphere);
  CHECK(scene.bodies[1].angular_velocity[2] == 5.);
  CHECK(scene.material_of(scene.bodies[1]).law == MechanicalLaw::viscoelastic_fluid);
  CHECK(scene.material_of(scene.bodies[1]).viscosity == 0.1);

  REQUIRE(scene.sources.size() == 1);
  CHECK(std::holds_alternative<MagnetizedSphereParameters<3>>(scene.sources[0].kind));
  CHECK(norm(scene.sources[0].pose(2.).position - Vector<3>{{0.4, 0.4, -0.1}}) < 1e-15);
  CHECK(scene.sources[0].is_solid);
  CHECK(scene.magnet_bodies[0].contact.condition == ContactCondition::slip);
}

// Gravity is given in numbers, as ever, or as what it is at each time.
TEST_CASE("Gravity may be expressions of t", "[parameters]")
{
  CHECK(read<3>(cube_text, {"Gravity=1, 0, -2"}).gravity.is_constant());
  const Parameters<3> scene = read<3>(cube_text, {"Gravity=max(0, t); 0; -9.81 + 2*t"});
  CHECK(scene.gravity(0.5)[0] == 0.5);
  CHECK(scene.gravity(0.5)[2] == Approx(-8.81));
}

// Names of shapes become these shapes, also where one is made of another that is listed later: a union of a
// ring and a block less a hole, in 2D, has the area of its parts.
TEST_CASE("Bodies and rigid bodies may be made of named shapes", "[parameters]")
{
  const Parameters<2> scene =
    read<2>(R"(
set Dimension = 2
set End time  = 1
subsection Box
  set Upper corner = 2, 2
  set Cell size    = 0.125
end
subsection Shapes
  set List of shapes = both, drilled, block, hole, hoop
  subsection both
    set Shape = union
    set Of    = drilled, hoop
  end
  subsection drilled
    set Shape = difference
    set Of    = block, hole
  end
  subsection block
    set Lower corner = 0.25, 0.25
    set Upper corner = 0.75, 0.75
  end
  subsection hole
    set Shape  = sphere
    set Centre = 0.5, 0.5
    set Radius = 0.125
  end
  subsection hoop
    set Shape        = ring
    set Centre       = 1.5, 1.5
    set Radius       = 0.25
    set Inner radius = 0.125
  end
end
subsection Bodies
  set List of bodies = body
  subsection body
    set Shape    = union
    set Of       = both, hole
    set Material = clay
    set Density  = 1000
  end
end
subsection Rigid bodies
  set List of rigid bodies = inside
  subsection inside
    set Shape    = intersection
    set Of       = plug, hoop_hole
    set Mass     = 1
  end
end
subsection Materials
  set List of materials = clay
  subsection clay
    set Young's modulus = 1e6
    set Poisson ratio   = 0.25
  end
end
)",
            {"Shapes/List of shapes=both, drilled, block, hole, hoop, plug, hoop_hole",
             "Shapes/plug/Lower corner=1.4, 1.4",
             "Shapes/plug/Upper corner=1.6, 1.6",
             "Shapes/hoop_hole/Shape=sphere",
             "Shapes/hoop_hole/Centre=1.5, 1.5",
             "Shapes/hoop_hole/Radius=0.12"});
  const double of_hoop = constants::pi * (0.0625 - 0.015625);
  CHECK(make_shape(scene.bodies[0].shape)->volume_moments().volume ==
        Approx(0.25 + of_hoop).epsilon(1e-3));
  CHECK(scene.rigid_bodies[0].shape.parts.size() == 2);
}

// Either way of giving moduli and magnetization ends in the same numbers. E = 1e6 Pa and nu = 1/4
// make both Lame moduli 0.4e6 Pa, and the grains of Sun et al. 2021 have M_s = n m and
// chi_0 = mu_0 n m^2/(3 k_B T).
TEST_CASE("Materials may be given in either way", "[parameters]")
{
  const double moment = 1.09e-19, density = 7.55e23;
  const double saturation     = moment * density;
  const double susceptibility = constants::vacuum_permeability * density * moment * moment /
                                (3. * constants::boltzmann * 300.);

  const MaterialParameters first = read<3>(cube_text).materials[0];
  CHECK(first.shear_modulus == Approx(0.4e6).epsilon(1e-14));
  CHECK(first.lame_lambda == Approx(0.4e6).epsilon(1e-14));
  CHECK(first.magnetic.saturation_magnetization == Approx(saturation).epsilon(1e-14));
  CHECK(first.magnetic.initial_susceptibility == Approx(susceptibility).epsilon(1e-14));
  CHECK(susceptibility == Approx(0.91).epsilon(5e-3));

  std::ostringstream chi;
  chi.precision(17);
  chi << "Materials/clay/Initial susceptibility=" << susceptibility;
  const MaterialParameters second = read<3>(cube_text,
                                            {"Materials/clay/Young's modulus=",
                                             "Materials/clay/Poisson ratio=",
                                             "Materials/clay/Shear modulus=4e5",
                                             "Materials/clay/Lame lambda=4e5",
                                             "Materials/clay/Grain moment=",
                                             "Materials/clay/Grain number density=",
                                             "Materials/clay/Saturation magnetization=82295",
                                             chi.str()})
                                      .materials[0];
  CHECK(second.shear_modulus == 4e5);
  CHECK(second.lame_lambda == 4e5);
  CHECK(second.magnetic.number_density == Approx(density).epsilon(1e-12));
}

TEST_CASE("remanence is mu_0 times the magnetization", "[parameters]")
{
  const Parameters<3> scene = read<3>(
    cube_text, {"Magnets/magnet/Magnetization=", "Magnets/magnet/Remanence=0; 0; 1.25663706212*t"});
  const auto &sphere = std::get<MagnetizedSphereParameters<3>>(scene.sources[0].kind);
  CHECK(sphere.magnetization(1.)[2] == Approx(1e6));
  CHECK(!sphere.magnetization.is_constant());
}

// The linear law needs no saturation, and a scene without magnetic material needs no potential.
TEST_CASE("What a scene does not need, it need not give", "[parameters]")
{
  const std::vector<std::string> no_grains = {"Materials/clay/Grain moment=",
                                              "Materials/clay/Grain number density="};
  std::vector<std::string> linear          = no_grains;
  linear.push_back("Magnetics/Magnetization law=linear");
  linear.push_back("Materials/clay/Initial susceptibility=3");
  CHECK(read<3>(cube_text, linear).materials[0].magnetic.initial_susceptibility == 3.);

  const Parameters<3> scene = read<3>(cube_text, no_grains);
  CHECK_FALSE(scene.mesh.carries_potential);
  REQUIRE(scene.warnings.size() == 1);
  CHECK(scene.warnings[0] ==
        "scene.prm, line 41: Magnets/List of magnets is not empty, but no body is magnetic: no "
        "magnet pulls.");
}

// What the cells cannot resolve, however the bodies are shaped, is said before a run: steel, but no rubber
// or ferrofluid.
TEST_CASE("A susceptibility that is not resolved is warned of", "[parameters]")
{
  const auto warnings = [](const std::string &susceptibility) {
    return read<3>(cube_text,
                   {"Materials/clay/Grain moment=",
                    "Materials/clay/Grain number density=",
                    "Magnetics/Magnetization law=linear",
                    "Materials/clay/Initial susceptibility=" + susceptibility})
      .warnings;
  };
  CHECK(warnings("50").empty());
  REQUIRE(warnings("1000").size() == 1);
  CHECK_THAT(warnings("1000")[0],
             Catch::Matchers::Contains("the initial susceptibility of 'clay' is 1000") &&
               Catch::Matchers::Contains("Potential cell size = dx"));
}

// A magnet that is taken off its list is left out with a warning, and that nothing magnetizes is a
// second one. Both are allowed, so that a magnet can be switched off on the command line.
TEST_CASE("Magnets can be switched off in their list", "[parameters]")
{
  const Parameters<3> scene = read<3>(cube_text, {"Magnets/List of magnets="});
  CHECK(scene.sources.empty());
  REQUIRE(scene.warnings.size() == 2);
  CHECK(scene.warnings[0] ==
        "scene.prm, line 42: the subsection Magnets/magnet is not used, because it is not in "
        "'Magnets/List of magnets'.");
  CHECK(scene.warnings[1] ==
        "--set \"Magnets/List of magnets=\": Magnets/List of magnets is empty: there are magnetic "
        "bodies, but nothing magnetizes them.");
}

// --set overrides the file, the last one wins, and original.prm with its appended lines is the same
// scene again. That the complete values agree shows it for every parameter at once.
TEST_CASE("Values from the command line override the file and are kept", "[parameters]")
{
  const Parameters<3> scene =
    read<3>(cube_text,
            {"End time=1", "End time = 2", "Bodies/cube/Density=1234", "Time step/Time step=1e-5"});
  CHECK(scene.end_time == 2.);
  CHECK(scene.bodies[0].density == 1234.);
  CHECK(scene.time_step.fixed_step == 1e-5);

  CHECK(scene.original_text.rfind(cube_text, 0) == 0);
  CHECK(scene.original_text.find("# Set on the command line:\nset End time = 1\n") !=
        std::string::npos);
  CHECK(read<3>(scene.original_text).complete_text == scene.complete_text);
}

// In two dimensions the same language has vectors of two components and spins of one.
TEST_CASE("A scene in two dimensions", "[parameters]")
{
  const std::string text   = R"(
set Dimension = 2
set End time = 1
subsection Box
  set Lower corner = -1, 0
  set Upper corner = 1, 0.5
  set Cell size = 0.125
end
subsection Bodies
  set List of bodies = disc
  subsection disc
    set Material = gel
    set Shape = sphere
    set Centre = 0, 0.25
    set Radius = 0.1
    set Density = 1000
    set Angular velocity = 7
  end
end
subsection Materials
  set List of materials = gel
  subsection gel
    set Shear modulus = 1000
    set Lame lambda = 2000
  end
end
subsection Walls
  set Upper y = separate
end
)";
  const ParameterFile file = parse_parameter_text(text, "disc.prm");
  REQUIRE(read_dimension(file) == 2);
  const Parameters<2> scene = read_parameters<2>(file);
  CHECK(scene.lattice.n_cells == Index<2>{{16, 4}});
  CHECK(scene.gravity(0.)[1] == -9.81);
  CHECK(scene.bodies[0].angular_velocity[0] == 7.);
  CHECK(scene.walls.condition[3] == WallCondition::separate);
}

// Every file in parameter_files is valid, and so is the parameters.prm that a run writes of it, which
// gives the same values: nothing is lost or changed on the way.
TEST_CASE("All parameter files are valid and survive a round trip", "[parameters]")
{
  const auto round_trip = [](const auto &scene, const auto &read_again) {
    CHECK(scene.warnings.empty());
    const auto again = read_again(scene.complete_text);
    CHECK(again.complete_text == scene.complete_text);
    CHECK(again.output.directory == scene.output.directory);
  };

  const auto files = example_files();
  CHECK(files.size() >= 5);
  for (const std::filesystem::path &path : files)
    {
      INFO(path.filename());
      const ParameterFile file = read_parameter_file(path.string());
      if (read_dimension(file) == 2)
        round_trip(read_parameters<2>(file), [&](const std::string &text) {
          return read_parameters<2>(parse_parameter_text(text, path.string()));
        });
      else
        round_trip(read_parameters<3>(file), [&](const std::string &text) {
          return read_parameters<3>(parse_parameter_text(text, path.string()));
        });
    }
}

// Every parameter has a range, a unit ("-" if it has none) and a sentence about it. A number with a
// default must itself lie in its range, or declaring it throws.
TEST_CASE("Every parameter is explained", "[parameters]")
{
  ParameterInput<3> input;
  input.body_names     = {"a"};
  input.material_names = {"b"};
  input.magnet_names   = {"c"};
  Parameters<3> parameters;
  ParameterRegister declarations;
  declare_parameters(declarations, input, parameters);

  CHECK(declarations.declared_parameters().size() > 60);
  for (const DeclaredParameter &parameter : declarations.declared_parameters())
    {
      INFO(parameter.section << "/" << parameter.name);
      CHECK(!parameter.range.empty());
      CHECK(!parameter.unit.empty());
      REQUIRE(!parameter.text.empty());
      CHECK(parameter.text.back() == '.');
    }
}

// The distance counts inserted, deleted, replaced and swapped letters. These words are one such step
// apart, except the last pair, whose known distance is 3.
TEST_CASE("The edit distance between names", "[parameters]")
{
  CHECK(edit_distance("Density", "density") == 0);
  CHECK(edit_distance("Densty", "Density") == 1);
  CHECK(edit_distance("Densitty", "Density") == 1);
  CHECK(edit_distance("Dencity", "Density") == 1);
  CHECK(edit_distance("Denisty", "Density") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);

  const std::vector<std::string> known = {"Radius", "Density", "Jitter"};
  CHECK(closest_name("radios", known) == "Radius");
  CHECK(closest_name("Temperature", known) == "");
}
