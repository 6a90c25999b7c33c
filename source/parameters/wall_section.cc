#include <magmpm/parameters/face_names.h>
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
    declarations.add("Particles leaving the box",
                     walls.removes_leaving_particles,
                     {{"error", false}, {"remove", true}},
                     "What becomes of particles that pass an open face: they end the run, or they "
                     "are removed and counted.");
  }

  template void
  declare_walls(ParameterRegister &, WallParameters<2> &);
  template void
  declare_walls(ParameterRegister &, WallParameters<3> &);
} // namespace magmpm
