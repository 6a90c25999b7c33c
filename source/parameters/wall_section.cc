#include <magmpm/parameters/face_names.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/wall_section.h>

namespace magmpm
{
  template <int dim>
  void
  declare_walls(ParameterRegister &declarations, WallParameters<dim> &walls)
  {
    const auto section = declarations.enter("Walls");
    for (std::size_t face = 0; face < face_names.size(); ++face)
      if (face < walls.condition.size())
        declarations.add(face_names[face],
                         walls.condition[face],
                         {{"stick", WallCondition::stick},
                          {"slip", WallCondition::slip},
                          {"separate", WallCondition::separate},
                          {"open", WallCondition::open}},
                         "What material does at this face of the box; open: it passes.");
      else
        declarations.refuse(face_names[face], "this face needs Dimension = 3.");
    for (std::size_t face = 0; face < face_names.size(); ++face)
      if (face < walls.friction.size())
        declarations.add(face_names[face] + " friction",
                         walls.friction[face],
                         "-",
                         "Coulomb's coefficient of friction at this face, with slip or separate; "
                         "of rigid bodies there the larger of theirs and this.",
                         not_negative);
      else
        declarations.refuse(face_names[face] + " friction", "this face needs Dimension = 3.");
    for (std::size_t face = 0; face < face_names.size(); ++face)
      if (face < walls.contact_angle.size())
        declarations.add(
          face_names[face] + " contact angle",
          walls.contact_angle[face],
          "degrees",
          "Angle within the fluid between this face and the surface of a fluid with surface "
          "tension, with slip or separate; where fluids stick, the line stays where it is.",
          {0., 180.});
      else
        declarations.refuse(face_names[face] + " contact angle", "this face needs Dimension = 3.");
    declarations.add("Particles leaving the box",
                     walls.removes_leaving_particles,
                     {{"error", false}, {"remove", true}},
                     "What becomes of particles that pass an open face: they end the run, or they "
                     "are removed and counted.");
  }

  template <int dim>
  void
  check_walls(const ParameterRegister &declarations, const WallParameters<dim> &walls)
  {
    for (std::size_t face = 0; face < walls.condition.size(); ++face)
      {
        const bool moves = walls.condition[face] == WallCondition::slip ||
                           walls.condition[face] == WallCondition::separate;
        const std::string angle = "Walls/" + face_names[face] + " contact angle";
        if (!moves && walls.contact_angle[face] != 90.)
          throw declarations.error(
            angle,
            "it needs '" + face_names[face] +
              "' = slip or separate: where material sticks, the line at which "
              "its surface meets the wall stays where it is, and an open face "
              "has none.");
      }
  }

#define INSTANTIATE(dim)                                                   \
  template void declare_walls(ParameterRegister &, WallParameters<dim> &); \
  template void check_walls(const ParameterRegister &, const WallParameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
