#include <magmpm/io/parameter_sections.h>

namespace magmpm
{
  namespace
  {
    const NumberRange fraction = {0., 1., false, false};

    template <int dim>
    void
    declare_shape(ParameterRegister &declarations, BodyParameters<dim> &body)
    {
      std::vector<std::pair<std::string, ShapeType>> shapes = {{"box", ShapeType::box},
                                                               {"sphere", ShapeType::sphere}};
      if (dim == 3)
        shapes.emplace_back("cylinder", ShapeType::cylinder);
      declarations.add(
        "Shape",
        body.shape,
        shapes,
        "Shape of the body; a sphere is a disc in 2D, a cylinder needs Dimension = 3.");
      declarations.add(
        "Lower corner", body.lower_corner, "m", "Of a box: its lower corner.", Presence::optional);
      declarations.add(
        "Upper corner", body.upper_corner, "m", "Of a box: its upper corner.", Presence::optional);
      declarations.add(
        "Centre", body.centre, "m", "Of a sphere or cylinder: its centre.", Presence::optional);
      declarations.add("Radius",
                       body.radius,
                       "m",
                       "Of a sphere or cylinder: its radius.",
                       positive,
                       Presence::optional);
      if constexpr (dim == 3)
        {
          declarations.add("Axis",
                           body.axis,
                           "-",
                           "Of a cylinder: direction of its axis, of any length.",
                           Presence::optional);
          declarations.add("Length",
                           body.length,
                           "m",
                           "Of a cylinder: its length along the axis.",
                           positive,
                           Presence::optional);
        }
      else
        for (const char *name : {"Axis", "Length"})
          declarations.refuse(name, "a cylinder needs Dimension = 3.");
    }
  } // namespace

  template <int dim>
  void
  declare_body(ParameterRegister &declarations, BodyParameters<dim> &body)
  {
    const auto section = declarations.enter(body.name);
    declare_shape(declarations, body);
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
