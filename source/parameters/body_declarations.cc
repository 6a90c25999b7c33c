#include <magmpm/parameters/parameter_sections.h>
#include <magmpm/parameters/shape_section.h>

namespace magmpm
{
  namespace
  {
    const NumberRange fraction = {0., 1., false, false};
  } // namespace

  template <int dim>
  void
  declare_body(ParameterRegister &declarations, BodyParameters<dim> &body)
  {
    const auto section = declarations.enter(body.name);
    declare_shape(declarations, body.shape, true);
    declarations.add(
      "Material", body.material, "-", "Name of one of the materials.", Presence::required);
    declarations.add("Density",
                     body.density,
                     "kg/m^3",
                     "Mass per undeformed volume.",
                     positive,
                     Presence::required);
    declarations.add("Particles per edge",
                     body.particles_per_edge,
                     "-",
                     "Particles along an edge of a lattice cell: 2 means 8 per cell in 3D.",
                     {1., 8.});
    declarations.add("Arrangement",
                     body.arrangement,
                     {{"cubic", Arrangement::cubic}, {"face-centred", Arrangement::face_centred}},
                     "Which places hold particles: all of them, or every other, as on a "
                     "chessboard: 4 per edge, face-centred, are 32 per cell in 3D, 8 in 2D.");
    declarations.add("Jitter",
                     body.jitter,
                     "-",
                     "Random offset of the particles at the start, as a fraction of their spacing.",
                     fraction);
    declarations.add("Velocity", body.velocity, "m/s", "Velocity at the start.");
    declarations.add("Angular velocity",
                     body.angular_velocity,
                     "rad/s",
                     "Spin at the start about the centre of mass.");
  }

  template void
  declare_body(ParameterRegister &, BodyParameters<2> &);
  template void
  declare_body(ParameterRegister &, BodyParameters<3> &);
} // namespace magmpm
