// What the log says of bodies that meet without being asked to, and of bodies that start in one another.

#include <magmpm/parallel/ranks.h>
#include <magmpm/simulation/scene.h>

#include <magmpm/parameters/parameter_file.h>

#include "../catch.h"

using namespace magmpm;

namespace
{
  /** Three blocks in a row; the first flies onto the second, to which the third is given face to face. */
  Parameters<2>
  three_blocks(const std::vector<std::string> &changes = {})
  {
    const std::string text = R"(
set Dimension = 2
set End time  = 1
set Gravity   = 0, 0
subsection Box
  set Upper corner = 1, 0.5
  set Cell size    = 0.03125
end
subsection Bodies
  set List of bodies = first, second, third
  subsection first
    set Material     = rubber
    set Density      = 1000
    set Lower corner = 0.1, 0.2
    set Upper corner = 0.3, 0.3
    set Velocity     = 2, 0
  end
  subsection second
    set Material     = rubber
    set Density      = 1000
    set Lower corner = 0.36, 0.2
    set Upper corner = 0.5, 0.3
  end
  subsection third
    set Material     = rubber
    set Density      = 1000
    set Lower corner = 0.5, 0.2
    set Upper corner = 0.6, 0.3
  end
end
subsection Materials
  set List of materials = rubber
  subsection rubber
    set Young's modulus = 1e5
    set Poisson ratio   = 0.3
  end
end
)";
    return read_parameters<2>(parse_parameter_text(text, "blocks.prm", changes));
  }

  /** The warnings of a scene in its first 40 ms. */
  std::vector<std::string>
  warnings_of(const Parameters<2> &parameters, const MPI_Comm communicator)
  {
    Scene<2> scene(parameters, communicator);
    scene.begin();
    while (scene.time() < 0.04)
      scene.step({0.04, false, {}});
    std::vector<std::string> warnings;
    for (const Notice &notice : scene.take_notices())
      if (notice.is_warning)
        warnings.push_back(notice.text);
    return warnings;
  }
} // namespace

TEST_CASE("Bodies of one group that meet are named once", "[simulation][mpi]")
{
  // The gap of 0.06 m is less than a cell, 0.031 m, after 14 ms; the time of the message is that of the next sort of the
  // particles. The second and third, given face to face, are one piece on purpose.
  const auto warnings = warnings_of(three_blocks(), MPI_COMM_WORLD);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Catch::StartsWith("the bodies 'first' and 'second' have come within a cell of one "
                               "another by t = 0.0"));
  CHECK_THAT(warnings[0],
             Catch::EndsWith(
               " s. Both are in contact group 0, so they stick together from now on. If "
               "they are to touch and part, set 'Contact group' in Bodies/second to "
               "another number than 0."));
}

TEST_CASE("Bodies of different groups, and fluids, meet without a word", "[simulation]")
{
  // They do what they were asked to: part, or flow together.
  CHECK(warnings_of(three_blocks({"Bodies/first/Contact group=1"}), MPI_COMM_SELF).empty());
  Parameters<2> fluids             = three_blocks();
  fluids.materials[0].law          = MechanicalLaw::viscoelastic_fluid;
  fluids.materials[0].bulk_modulus = 1e5;
  CHECK(warnings_of(fluids, MPI_COMM_SELF).empty());
}

TEST_CASE("Bodies of different groups that start in one another are named", "[simulation][mpi]")
{
  // By 3 mm, 0.096 cells, which is found from the particles to some per cent; a hundredth of a cell is let pass, and so
  // are bodies face to face. Shapes that overlap are refused, so the particles are moved.
  const auto found = [](const double overlap) {
    Parameters<2> parameters = three_blocks({"Bodies/third/Contact group=1"});
    parameters.bodies[2].shape.lower_corner[0] -= overlap;
    return warnings_of(parameters, MPI_COMM_WORLD);
  };
  CHECK(found(0.).size() == 1); // the weld of the first
  CHECK(found(0.0003).size() == 1);
  const auto warnings = found(0.003);
  REQUIRE(warnings.size() == 2);
  CHECK_THAT(warnings[0],
             Catch::StartsWith(
               "the bodies 'first', 'second' (contact group 0) and 'third' (contact "
               "group 1) overlap at the start by 0.00"));
  CHECK_THAT(warnings[0],
             Catch::EndsWith(" cells: contact throws them apart. Move them apart by as much."));
  CHECK_THAT(warnings[0], Catch::Contains(" that is 0.09"));
}
