#include <magmpm/io/parameter_declarations.h>

namespace magmpm
{
  namespace
  {
    const NumberRange poisson_ratio_range = {-1., 0.5, true, true};
    const NumberRange fraction            = {0., 1., false, false};
    const NumberRange at_least_one        = {1., any_number.maximum, false, false};

    /** Names of the faces of a box in the order of WallParameters. */
    const std::vector<std::string> face_names =
      {"Lower x", "Upper x", "Lower y", "Upper y", "Lower z", "Upper z"};

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
      parameters.gravity[dim - 1] = -9.81;
      declarations.add("Gravity", parameters.gravity, "m/s^2", "Acceleration of gravity.");
      declarations.add("Output directory",
                       parameters.output.directory,
                       "-",
                       "Folder for all results; not given: output-<name of the parameter file>.",
                       Presence::optional);
      declarations.add(
        "Checkpoint every",
        input.checkpoint_every,
        "s, min, h or frames",
        "When a checkpoint is written, from which 'magmpm --resume' goes on: after so much "
        "wall time (10 min, 2 h), after every so many frames (20 frames; then the same run "
        "gives the same numbers again), or never.");
      declarations.add("Checkpoints kept",
                       parameters.checkpoint.n_kept,
                       "-",
                       "Checkpoints that stay on the disk, the latest included.",
                       at_least_one);
      declarations.add(
        "End wall time",
        input.end_wall_time,
        "s, min or h",
        "Wall time after which the run finishes its step, writes a checkpoint and ends (11.5 h), "
        "or never. So do a file 'stop' in the output directory, SIGUSR1 and SIGTERM.");

      const auto section = declarations.enter("Box");
      declarations.add("Lower corner",
                       input.lower_corner,
                       "m",
                       "Lower corner of the box whose faces are the walls.");
      declarations.add("Upper corner",
                       input.upper_corner,
                       "m",
                       "Upper corner of the box. Its edges are multiples of 4 cells.",
                       Presence::required);
      declarations.add("Cell size",
                       input.cell_size,
                       "m",
                       "Edge dx of the lattice cells.",
                       positive,
                       Presence::required);
    }

    template <int dim>
    void
    declare_shape(ParameterRegister &declarations, BodyParameters<dim> &body)
    {
      std::vector<std::pair<std::string, Shape>> shapes = {{"box", Shape::box},
                                                           {"sphere", Shape::sphere}};
      if (dim == 3)
        shapes.emplace_back("cylinder", Shape::cylinder);
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
      declarations.add(
        "Jitter",
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

    void
    declare_moduli(ParameterRegister &declarations, MaterialInput &material)
    {
      declarations.add("Young's modulus",
                       material.youngs_modulus,
                       "Pa",
                       "Stiffness of a solid, together with the Poisson ratio.",
                       positive,
                       Presence::optional);
      declarations.add("Poisson ratio",
                       material.poisson_ratio,
                       "-",
                       "Transverse contraction of a solid, together with Young's modulus.",
                       poisson_ratio_range,
                       Presence::optional);
      declarations.add(
        "Shear modulus",
        material.shear_modulus,
        "Pa",
        "First Lame modulus mu of a solid, together with lambda, instead of E and nu.",
        positive,
        Presence::optional);
      declarations.add("Lame lambda",
                       material.lame_lambda,
                       "Pa",
                       "Second Lame modulus lambda of a solid, together with the shear modulus.",
                       any_number,
                       Presence::optional);
      declarations.add("Bulk modulus",
                       material.bulk_modulus,
                       "Pa",
                       "Resistance K of a fluid to compression.",
                       positive,
                       Presence::optional);
      declarations.add("Viscosity",
                       material.viscosity,
                       "Pa s",
                       "Shear viscosity mu_N of a fluid.",
                       not_negative,
                       Presence::optional);
    }

    void
    declare_magnetization(ParameterRegister &declarations, MaterialInput &material)
    {
      declarations.add("Saturation magnetization",
                       material.saturation_magnetization,
                       "A/m",
                       "M_s, together with the initial susceptibility; the linear law needs none.",
                       positive,
                       Presence::optional);
      declarations.add("Initial susceptibility",
                       material.initial_susceptibility,
                       "-",
                       "chi_0 = dM/dH without field; not given, nor grains: not magnetic.",
                       positive,
                       Presence::optional);
      declarations.add("Grain moment",
                       material.grain_moment,
                       "A m^2",
                       "Magnetic moment m of one grain, together with the grain number density, "
                       "instead of M_s = n m and chi_0 = mu_0 n m^2/(3 k_B T).",
                       positive,
                       Presence::optional);
      declarations.add(
        "Grain number density",
        material.grain_number_density,
        "1/m^3",
        "Grains n per volume of undeformed material, together with the grain moment.",
        positive,
        Presence::optional);
    }

    void
    declare_material(ParameterRegister &declarations,
                     const std::string &name,
                     MaterialInput &material)
    {
      const auto section = declarations.enter(name);
      declarations.add("Mechanical law",
                       material.law,
                       {{"neo-Hookean", MechanicalLaw::neo_hookean},
                        {"viscoelastic fluid", MechanicalLaw::viscoelastic_fluid}},
                       "What the material does when it is deformed.");
      declare_moduli(declarations, material);
      declare_magnetization(declarations, material);
    }

    template <int dim>
    void
    declare_source(ParameterRegister &declarations, SourceParameters<dim> &source)
    {
      const auto section           = declarations.enter(source.name);
      const std::string components = " Expressions of t [s], separated by semicolons.";
      declarations.add("Type",
                       source.type,
                       {{"uniform field", SourceType::uniform_field},
                        {"magnetized sphere", SourceType::magnetized_sphere}},
                       "Kind of source; in 2D a sphere is a cylinder magnetized across its axis.");
      declarations.add(
        "Field", source.field, "A/m", "Of a uniform field: H(t)." + components, Presence::optional);
      declarations.add("Position",
                       source.position,
                       "m",
                       "Of a magnetized sphere: its centre x(t)." + components,
                       Presence::optional);
      declarations.add("Magnetization",
                       source.magnetization,
                       "A/m",
                       "Of a magnetized sphere: M(t)." + components,
                       Presence::optional);
      declarations.add("Radius",
                       source.radius,
                       "m",
                       "Of a magnetized sphere: its radius.",
                       positive,
                       Presence::optional);
      declarations.add("Contact",
                       source.contact,
                       {{"none", ContactCondition::none},
                        {"stick", ContactCondition::stick},
                        {"slip", ContactCondition::slip},
                        {"separate", ContactCondition::separate}},
                       "Of a magnetized sphere: what material does at its surface; none: it has no "
                       "surface.");
    }

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
      declarations.add(
        "Particles leaving the box",
        walls.removes_leaving_particles,
        {{"error", false}, {"remove", true}},
        "What becomes of particles that pass an open face: they end the run, or they "
        "are removed and counted.");
    }

    template <int dim>
    void
    declare_potential_mesh(ParameterRegister &declarations, MeshParameters<dim> &mesh)
    {
      declarations.add("Potential cell size",
                       mesh.cell_edge,
                       {{"2 dx", 2}, {"dx", 1}},
                       "Edge of the cells of the potential where material is. dx takes eight times "
                       "the unknowns there (four times in 2D) and is more accurate at "
                       "susceptibilities of 10 and more and in gaps under 6 dx.");
      declarations.add(
        "Potential box factor",
        mesh.potential_box_factor,
        "-",
        "Edge of the box of the potential over that of the mechanical box, at least, "
        "where its faces are open.",
        at_least_one);
      declarations.add(
        "Potential band width",
        mesh.band_width,
        "-",
        "Blocks (of 4 cells) around those next to particles, now or soon, where the "
        "mesh is fine too: a wider band costs unknowns and saves changes of the mesh.",
        {0., 1000.});
      const auto section = declarations.enter("Potential box");
      for (std::size_t face = 0; face < face_names.size(); ++face)
        if (face < mesh.shielded.size())
          declarations.add(face_names[face],
                           mesh.shielded[face],
                           {{"open", false}, {"shielded", true}},
                           "Free space beyond this face, or a shield (mirror) at the wall.");
        else
          declarations.refuse(face_names[face], "this face needs Dimension = 3.");
    }

    void
    declare_solve_trigger(ParameterRegister &declarations, SolveTriggerParameters &trigger)
    {
      const auto section = declarations.enter("Solve");
      declarations.add("When",
                       trigger.trigger,
                       {{"changed", SolveTriggerParameters::Trigger::when_changed},
                        {"every step", SolveTriggerParameters::Trigger::every_step},
                        {"every n steps", SolveTriggerParameters::Trigger::every_n_steps}},
                       "When the potential is solved again.");
      declarations.add("Moved fraction",
                       trigger.moved_fraction,
                       "-",
                       "With When = changed: after material moved by this fraction of dx.",
                       not_negative);
      declarations.add("Changed fraction",
                       trigger.changed_fraction,
                       "-",
                       "With When = changed: after the external field changed by this fraction.",
                       not_negative);
      declarations.add("Steps", trigger.n_steps, "-", "With When = every n steps: n.", {1., 1e9});
    }

    template <int dim>
    void
    declare_magnetics(ParameterRegister &declarations,
                      ParameterInput<dim> &input,
                      Parameters<dim> &parameters)
    {
      MagneticsParameters<dim> &magnetics = parameters.magnetics;
      const auto section                  = declarations.enter("Magnetics");
      declarations.add("Magnetization law",
                       magnetics.law,
                       {{"Langevin", MagnetizationLaw::langevin},
                        {"linear", MagnetizationLaw::linear}},
                       "How all magnetic materials of the scene answer to the field.");
      declarations.add(
        "Temperature",
        input.temperature,
        "K",
        "Of the grains; it relates their moment and number density to M_s and chi_0.",
        {1., 1e4});
      declarations.add(
        "Material indicator",
        magnetics.indicator,
        {{"sharp", MaterialIndicator::sharp}, {"smeared", MaterialIndicator::smeared}},
        "Where material is: with a sharp surface that the particles tell, or as far as "
        "their B-splines reach, as in the paper (first order only, to compare).");
      declarations.add(
        "Preconditioner",
        magnetics.preconditioner,
        {{"GMG", Preconditioner::gmg},
         {"ML", Preconditioner::ml},
         {"MueLu", Preconditioner::muelu}},
        "Of the linear solver: geometric multigrid without a matrix, or algebraic multigrid on the "
        "assembled matrix, by Trilinos ML or MueLu (on the GPU, where Trilinos was built for it).");
      declarations.add("Newton tolerance",
                       magnetics.newton_tolerance,
                       "-",
                       "Residual at which Newton stops, relative to that of zero potential.",
                       {1e-15, 1., false, true});
      declarations.add("Maximum Newton steps",
                       magnetics.max_newton_steps,
                       "-",
                       "More than these fail the run.",
                       {1., 1000.});
      declarations.add("Maximum CG iterations",
                       magnetics.max_cg_iterations,
                       "-",
                       "In one Newton step; more than these fail the run.",
                       {1., 1e6});
      declare_potential_mesh(declarations, parameters.mesh);
      declare_solve_trigger(declarations, parameters.solve_trigger);
    }

    void
    declare_ranks(ParameterRegister &declarations, double &imbalance_threshold)
    {
      const auto section = declarations.enter("Parallel");
      declarations.add(
        "Imbalance threshold",
        imbalance_threshold,
        "-",
        "Load of the most loaded rank over the mean above which cells and particles "
        "are dealt out anew. The load is an estimate: a cell of the potential counts "
        "as 30 particles.",
        at_least_one);
    }

    void
    declare_time_step(ParameterRegister &declarations, TimeStepParameters &time_step)
    {
      const auto section = declarations.enter("Time step");
      declarations.add_or_auto("Time step",
                               time_step.fixed_step,
                               "s",
                               "dt of all steps; auto: each as long as the limits below allow.",
                               positive);
      declarations.add("Allow unstable time step",
                       time_step.allow_unstable,
                       "Whether a given dt may be longer than the limits below: such a run may go "
                       "astray. Otherwise it ends where a limit falls below dt.");
      declarations.add("Maximum",
                       time_step.maximum,
                       "s",
                       "With Time step = auto: dt is never longer; not given: no such limit.",
                       positive,
                       Presence::optional);
      declarations.add("Elastic factor",
                       time_step.elastic_factor,
                       "-",
                       "dt <= factor dx/(c + |v|), c the wave speed.",
                       positive);
      declarations.add(
        "Viscous factor", time_step.viscous_factor, "-", "dt <= factor rho dx^2/mu_N.", positive);
      declarations.add("Force factor",
                       time_step.force_factor,
                       "-",
                       "dt <= factor sqrt(dx/|a|), a the acceleration.",
                       positive);
      declarations.add("Affine factor",
                       time_step.affine_factor,
                       "-",
                       "dt <= factor/|C|, C the velocity gradient.",
                       positive);
    }

    void
    declare_runaway_limits(ParameterRegister &declarations, RunawayLimits &limits)
    {
      const auto section = declarations.enter("Runaway limits");
      declarations.add("Minimum volume ratio",
                       limits.min_volume_ratio,
                       "-",
                       "A particle with a J below this has failed the run.",
                       {0., 1., false, true});
      declarations.add("Maximum volume ratio",
                       limits.max_volume_ratio,
                       "-",
                       "A particle with a J above this has failed the run.",
                       {1., any_number.maximum, true, false});
      declarations.add(
        "Maximum speed ratio",
        limits.max_speed_ratio,
        "-",
        "A particle faster than this, times the wave speed of its undeformed material, "
        "has failed the run.",
        positive);
    }

    void
    declare_output(ParameterRegister &declarations, OutputParameters &output)
    {
      const auto section         = declarations.enter("Output");
      output.frame_interval      = 2e-3;
      output.particle_quantities = {"velocity", "J", "von_mises_stress", "magnetization", "body"};
      output.field_quantities    = {"potential", "H_int", "H", "M", "B", "number_density"};
      declarations.add("Frame interval",
                       output.frame_interval,
                       "s",
                       "Simulated time between two frames.",
                       positive);
      declarations.add("Particles", output.write_particles, "Whether particles are written.");
      declarations.add("Fields", output.write_fields, "Whether magnetic fields are written.");
      declarations.add("Particle quantities",
                       output.particle_quantities,
                       std::vector<std::string>(output.particle_quantities),
                       "What is written of the particles.");
      declarations.add("Field quantities",
                       output.field_quantities,
                       std::vector<std::string>(output.field_quantities),
                       "What is written of the fields.");
      declarations.add("Statistics every",
                       output.statistics_every,
                       "steps",
                       "Steps from one row of statistics.csv to the next.",
                       {1., 1e9});
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
  } // namespace

  template <int dim>
  void
  declare_parameters(ParameterRegister &declarations,
                     ParameterInput<dim> &input,
                     Parameters<dim> &parameters)
  {
    parameters.bodies.resize(input.body_names.size());
    parameters.sources.resize(input.magnet_names.size());
    input.materials.resize(input.material_names.size());

    declare_scene(declarations, input, parameters);
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
      declare_list(declarations,
                   "List of magnets",
                   input.magnet_names,
                   "Names of the sources of the external field; each has a subsection of its name "
                   "here. Their fields add up.");
      for (std::size_t i = 0; i < parameters.sources.size(); ++i)
        {
          parameters.sources[i].name = input.magnet_names[i];
          declare_source(declarations, parameters.sources[i]);
        }
    }
    declare_walls(declarations, parameters.walls);
    declare_magnetics(declarations, input, parameters);
    declare_time_step(declarations, parameters.time_step);
    declare_runaway_limits(declarations, parameters.runaway_limits);
    declare_ranks(declarations, parameters.mesh.imbalance_threshold);
    declare_output(declarations, parameters.output);
  }

  template void
  declare_parameters<2>(ParameterRegister &, ParameterInput<2> &, Parameters<2> &);
  template void
  declare_parameters<3>(ParameterRegister &, ParameterInput<3> &, Parameters<3> &);
} // namespace magmpm
