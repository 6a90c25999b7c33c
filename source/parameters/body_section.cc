#include <magmpm/base/number_text.h>
#include <magmpm/geometry/point_cloud_shape.h>
#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/parameters/body_section.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/parameter_names.h>
#include <magmpm/parameters/shape_section.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    const NumberRange fraction = {0., 1., false, false};

    template <int dim>
    void
    check_points(const ParameterRegister &declarations,
                 const std::string &section,
                 const BodyParameters<dim> &body,
                 const PointCloud<dim> &cloud,
                 const Lattice<dim> &lattice)
    {
      if (body.jitter > 0.)
        throw declarations.error(
          section + "/Jitter",
          "with Shape = points particles are where the file has them; set it "
          "to 0.");
      for (std::size_t i = 0; i < cloud.points.size(); ++i)
        for (int d = 0; d < dim; ++d)
          if (!(cloud.points[i][d] > lattice.lower_corner[d] &&
                cloud.points[i][d] < lattice.upper_corner()[d]))
            throw declarations.error(section + "/File",
                                     "the point of line " + std::to_string(cloud.lines[i]) +
                                       ", at " + components(cloud.points[i]) +
                                       " m in the scene, is not inside the box. Move the points "
                                       "with Scale, Rotation or Translation, or enlarge the box.");
    }
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
    declarations.add(
      "Initial state",
      body.initial_state,
      {{"undeformed", InitialState::undeformed}, {"hydrostatic", InitialState::hydrostatic}},
      "Of a fluid: hydrostatic, it is compressed by the weight of the fluids and solids "
      "that stand above it, in gravity of the start, and so fills its shape at rest; its "
      "mass is a little more than density times volume. Undeformed, it sinks at first.");
    declarations.add(
      "Contact group",
      body.contact_group,
      "-",
      "Bodies of one group that meet move together from then on, as one piece: what "
      "has no group of its own welds. Bodies of different groups touch and part, see "
      "Contacts. Fluids are in group 0. Each group takes its own memory for what is "
      "stored on the lattice.",
      {0., 1e6});
    declarations.add("Velocity", body.velocity, "m/s", "Velocity at the start.");
    declarations.add("Angular velocity",
                     body.angular_velocity,
                     "rad/s",
                     "Spin at the start about the centre of mass.");
  }

  template <int dim>
  std::vector<std::unique_ptr<Shape<dim>>>
  check_bodies(const ParameterRegister &declarations,
               const std::vector<std::string> &material_names,
               const NamedShapes<dim> &named_shapes,
               const Lattice<dim> &lattice,
               std::vector<BodyParameters<dim>> &bodies)
  {
    const std::string list = "Bodies/List of bodies";
    if (bodies.empty())
      throw declarations.error(list, "a scene needs at least one body.");

    std::vector<std::unique_ptr<Shape<dim>>> shapes;
    for (BodyParameters<dim> &body : bodies)
      {
        const std::string section = "Bodies/" + body.name;
        if (std::find(material_names.begin(), material_names.end(), body.material) ==
            material_names.end())
          throw declarations.error(section + "/Material",
                                   "there is no material of this name. Materials/List of "
                                   "materials is '" +
                                     comma_separated(material_names) + "'" +
                                     did_you_mean(body.material, material_names));
        if (body.arrangement == Arrangement::face_centred && body.particles_per_edge == 1)
          throw declarations.error(
            section + "/Arrangement",
            "with Particles per edge = 1 every other cell would be empty; it "
            "takes 2 or more.");
        shapes.push_back(check_shape(declarations, section, named_shapes, body.shape));
        if (body.shape.type == ShapeType::points)
          check_points(declarations,
                       section,
                       body,
                       static_cast<const PointCloudShape<dim> &>(*shapes.back()).cloud(),
                       lattice);
        check_inside_box(
          declarations, section, body.shape.type, shapes.back()->bounding_box(), lattice);
      }

    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (overlap(*shapes[i], *shapes[j], 0.5 * lattice.spacing))
          throw declarations.error(list,
                                   "the bodies '" + bodies[j].name + "' and '" + bodies[i].name +
                                     "' overlap at the start; move them apart.");
    return shapes;
  }

  template <int dim>
  void
  check_initial_states(const ParameterRegister &declarations, const Parameters<dim> &parameters)
  {
    for (const BodyParameters<dim> &body : parameters.bodies)
      {
        if (body.initial_state != InitialState::hydrostatic)
          continue;
        const std::string state = "Bodies/" + body.name + "/Initial state";
        if (parameters.material_of(body).law != MechanicalLaw::viscoelastic_fluid)
          throw declarations.error(state,
                                   "the material '" + body.material +
                                     "' is solid; hydrostatic are fluids alone. Set it to "
                                     "undeformed.");
        if (body.shape.type == ShapeType::points)
          throw declarations.error(state,
                                   "with Shape = points it is not known what stands above a "
                                   "particle. Set it to undeformed, or choose another shape.");
        if (norm(parameters.gravity(0.)) == 0.)
          throw declarations.error(state,
                                   "Gravity is 0 at the start: nothing has weight. Set it to "
                                   "undeformed, or Gravity to another value.");
      }
  }

#define INSTANTIATE(dim)                                                                  \
  template void declare_body(ParameterRegister &, BodyParameters<dim> &);                 \
  template void check_initial_states(const ParameterRegister &, const Parameters<dim> &); \
  template std::vector<std::unique_ptr<Shape<dim>>> check_bodies(                         \
    const ParameterRegister &,                                                            \
    const std::vector<std::string> &,                                                     \
    const NamedShapes<dim> &,                                                             \
    const Lattice<dim> &,                                                                 \
    std::vector<BodyParameters<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
