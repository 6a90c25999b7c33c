#include <magmpm/base/number_text.h>
#include <magmpm/motion/expression.h>
#include <magmpm/parameters/attraction_section.h>
#include <magmpm/parameters/body_section.h>
#include <magmpm/parameters/checkpoint_section.h>
#include <magmpm/parameters/contact_section.h>
#include <magmpm/parameters/face_names.h>
#include <magmpm/parameters/magnetics_section.h>
#include <magmpm/parameters/output_section.h>
#include <magmpm/parameters/parallel_section.h>
#include <magmpm/parameters/parameter_sections.h>
#include <magmpm/parameters/rest_section.h>
#include <magmpm/parameters/rigid_body_section.h>
#include <magmpm/parameters/runaway_section.h>
#include <magmpm/parameters/time_step_section.h>
#include <magmpm/parameters/wall_section.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    template <int dim>
    void
    declare_scene(ParameterRegister &declarations,
                  ParameterInput<dim> &input,
                  Parameters<dim> &parameters)
    {
      declarations.add(
        "Dimension",
        input.dimension,
        "-",
        "Dimension of the scene. In 2D (plane strain, per metre of depth) vectors have "
        "two components, spins one.",
        {2., 3.});
      declarations.add("End time",
                       parameters.end_time,
                       "s",
                       "Simulated time at which the run ends.",
                       positive,
                       Presence::required);
      input.gravity = (dim == 2 ? "0, -9.81" : "0, 0, -9.81");
      declarations.add(
        "Gravity",
        input.gravity,
        "m/s^2",
        "Acceleration of gravity g(t); in a tank that is shaken less the tank's own. "
        "Numbers or expressions of t [s], separated by commas or semicolons.");
      declarations.add("Output directory",
                       parameters.output.directory,
                       "-",
                       "Folder for all results; not given: output-<name of the parameter file>.",
                       Presence::optional);
      declare_checkpoint(declarations, parameters.checkpoint);
      declare_box(declarations, input.box);
    }

    void
    declare_list(ParameterRegister &declarations,
                 const std::string &name,
                 std::vector<std::string> &names,
                 const std::string &text)
    {
      // The lists were read before, to know what to declare: applying the file fills them again.
      std::vector<std::string> known;
      known.swap(names);
      declarations.add(name, names, {}, text);
      names.swap(known);
    }

    /** The sections with a list of names, and a subsection for each of them. */
    template <int dim>
    void
    declare_lists(ParameterRegister &declarations,
                  ParameterInput<dim> &input,
                  Parameters<dim> &parameters)
    {
      {
        const auto section = declarations.enter("Shapes");
        declare_list(
          declarations,
          "List of shapes",
          input.shapes.names,
          "Names of shapes of which bodies and rigid bodies are made by union, difference "
          "and intersection; each has a subsection of its name here.");
        declare_shapes(declarations, input.shapes);
      }
      {
        const auto section = declarations.enter("Bodies");
        declare_list(declarations,
                     "List of bodies",
                     input.body_names,
                     "Names of the bodies; each has a subsection of its name here.");
        for (std::size_t i = 0; i < parameters.bodies.size(); ++i)
          {
            parameters.bodies[i].name = input.body_names[i];
            declare_body(declarations, parameters.bodies[i]);
          }
      }
      {
        const auto section = declarations.enter("Materials");
        declare_list(declarations,
                     "List of materials",
                     input.material_names,
                     "Names of the materials; each has a subsection of its name here.");
        for (std::size_t i = 0; i < input.materials.size(); ++i)
          declare_material(declarations, input.material_names[i], input.materials[i]);
      }
      {
        const auto section = declarations.enter("Magnets");
        declare_list(
          declarations,
          "List of magnets",
          input.magnet_names,
          "Names of the sources of the external field; each has a subsection of its name "
          "here. Their fields add up.");
        for (std::size_t i = 0; i < input.magnets.size(); ++i)
          declare_magnet(declarations, input.magnet_names[i], input.magnets[i]);
      }
      {
        const auto section = declarations.enter("Rigid bodies");
        declare_list(declarations,
                     "List of rigid bodies",
                     input.rigid_body_names,
                     "Names of the rigid bodies that are not magnets; each has a subsection of its "
                     "name here. Solid and free magnets are rigid bodies, too.");
        for (std::size_t i = 0; i < parameters.rigid_bodies.size(); ++i)
          {
            parameters.rigid_bodies[i].name = input.rigid_body_names[i];
            declare_rigid_body(
              declarations, parameters.rigid_bodies[i], input.rigid_body_motions[i]);
          }
      }
      {
        const auto section = declarations.enter("Contacts");
        declare_list(declarations,
                     "List of contacts",
                     input.contact_names,
                     "Names of contacts between two groups of bodies; each has a subsection of its "
                     "name here. Groups of which none is listed separate, without friction.");
        for (std::size_t i = 0; i < input.contacts.size(); ++i)
          declare_contact(declarations, input.contact_names[i], input.contacts[i]);
      }
    }

    /** What the cells of the potential do not resolve, whatever the shape (doc/accuracy.md). */
    template <int dim>
    void
    warn_of_permeable(const ParameterRegister &declarations, Parameters<dim> &parameters)
    {
      constexpr double well_resolved = 50.;
      for (const MaterialParameters &material : parameters.materials)
        if (material.magnetic.initial_susceptibility > well_resolved)
          parameters.warnings.push_back(
            declarations.where("Materials/List of materials") +
            ": the initial susceptibility of '" + material.name + "' is " +
            to_text(material.magnetic.initial_susceptibility) +
            ". Its moments and forces are too large where a body is not many cells thick: for a "
            "radius of 8 cells by 3 % at 100 and 13 % at 1000, at small gaps by more. A smaller "
            "'Cell size' helps, or 'Potential cell size = dx'.");
    }

    /** Contact angles of nothing. */
    template <int dim>
    void
    warn_of_angles(const ParameterRegister &declarations, Parameters<dim> &parameters)
    {
      const auto has_tension = [](const MaterialParameters &material) {
        return material.surface_tension > 0.;
      };
      if (std::any_of(parameters.materials.begin(), parameters.materials.end(), has_tension))
        return;
      for (std::size_t face = 0; face < parameters.walls.contact_angle.size(); ++face)
        if (parameters.walls.contact_angle[face] != 90.)
          parameters.warnings.push_back(
            declarations.where("Walls/" + face_names[face] + " contact angle") +
            " does nothing: no material has a 'Surface tension'.");
    }

    /** What is allowed but probably not meant. */
    template <int dim>
    void
    collect_warnings(const ParameterRegister &declarations, Parameters<dim> &parameters)
    {
      const bool magnetic                      = parameters.mesh.carries_potential;
      const std::vector<std::string> &left_out = declarations.warnings();
      parameters.warnings.insert(parameters.warnings.begin(), left_out.begin(), left_out.end());
      if (magnetic && parameters.sources.empty())
        parameters.warnings.push_back(
          declarations.where("Magnets/List of magnets") +
          " is empty: there are magnetic bodies, but nothing magnetizes "
          "them.");
      const bool any_is_free = std::any_of(parameters.magnet_bodies.begin(),
                                           parameters.magnet_bodies.end(),
                                           [](const auto &magnet) { return magnet.is_free; });
      if (!magnetic && !parameters.sources.empty() && !any_is_free)
        parameters.warnings.push_back(declarations.where("Magnets/List of magnets") +
                                      " is not empty, but no body is magnetic: no magnet pulls.");
      for (const MaterialParameters &material : parameters.materials)
        if (std::none_of(parameters.bodies.begin(),
                         parameters.bodies.end(),
                         [&](const BodyParameters<dim> &body) {
                           return body.material == material.name;
                         }))
          parameters.warnings.push_back(declarations.where("Materials/List of materials") +
                                        ": no body is made of '" + material.name + "'.");
      warn_of_permeable(declarations, parameters);
      warn_of_angles(declarations, parameters);
    }
  } // namespace

  template <int dim>
  void
  declare_parameters(ParameterRegister &declarations,
                     ParameterInput<dim> &input,
                     Parameters<dim> &parameters)
  {
    parameters.bodies.resize(input.body_names.size());
    input.shapes.shapes.resize(input.shapes.names.size());
    input.magnets.resize(input.magnet_names.size());
    parameters.rigid_bodies.resize(input.rigid_body_names.size());
    input.materials.resize(input.material_names.size());
    input.rigid_body_motions.resize(input.rigid_body_names.size());
    input.contacts.resize(input.contact_names.size());

    declare_scene(declarations, input, parameters);
    declare_lists(declarations, input, parameters);
    declare_walls(declarations, parameters.walls);
    declare_magnetics(declarations,
                      input.temperature,
                      parameters.magnetics,
                      parameters.mesh,
                      parameters.solve_trigger);
    declare_attraction(declarations, parameters.forces.attraction);
    declare_rest(declarations, parameters.rest);
    declare_time_step(declarations, parameters.time_step);
    declare_runaway_limits(declarations, parameters.runaway_limits);
    declare_ranks(declarations, parameters.mesh.imbalance_threshold);
    declare_output(declarations, parameters.output);
  }

  template <int dim>
  void
  validate(const ParameterRegister &declarations,
           ParameterInput<dim> &input,
           Parameters<dim> &parameters)
  {
    parameters.lattice = lattice_of_box(declarations, input.box);
    parameters.gravity = read_expression<dim>(input.gravity, declarations.where("Gravity"));
    convert_magnetization_curve(declarations, parameters.magnetics);
    for (std::size_t i = 0; i < input.materials.size(); ++i)
      parameters.materials.push_back(convert_material(declarations,
                                                      input.material_names[i],
                                                      input.materials[i],
                                                      {parameters.lattice.spacing,
                                                       parameters.magnetics.law,
                                                       parameters.magnetics.curve.get(),
                                                       input.temperature}));
    check_walls(declarations, parameters.walls);
    check_shapes(declarations, input.shapes);
    const auto body_shapes = check_bodies(
      declarations, input.material_names, input.shapes, parameters.lattice, parameters.bodies);
    check_initial_states(declarations, parameters);
    check_contacts(declarations, input.contact_names, input.contacts, parameters);
    check_magnets(declarations, input.magnet_names, input.magnets, body_shapes, parameters);
    check_rigid_bodies(
      declarations, input.rigid_body_motions, input.shapes, body_shapes, parameters);
    check_time_step(declarations, parameters.time_step, parameters.output.frame_interval);
    convert_checkpoint(declarations, parameters.checkpoint);

    parameters.magnetics.shielded = parameters.mesh.shielded;
    parameters.mesh.carries_potential =
      std::any_of(parameters.bodies.begin(), parameters.bodies.end(), [&](const auto &body) {
        return parameters.material_of(body).magnetic.is_magnetic();
      });
    check_potential_box(declarations, parameters.lattice, parameters.mesh);
    convert_attraction(declarations,
                       {input.body_names,
                        parameters.lattice.spacing,
                        !parameters.sources.empty(),
                        parameters.mesh.carries_potential},
                       parameters.forces.attraction);
    if (parameters.forces.attraction.matches_magnets)
      parameters.output.write_fields = false; // there will be none
    check_rest(declarations, parameters.rest);
    collect_warnings(declarations, parameters);
  }

#define INSTANTIATE(dim)                                                                           \
  template void declare_parameters(ParameterRegister &, ParameterInput<dim> &, Parameters<dim> &); \
  template void validate(const ParameterRegister &, ParameterInput<dim> &, Parameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
