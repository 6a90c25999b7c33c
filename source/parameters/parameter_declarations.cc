#include <magmpm/magnetics/field_quantities.h>
#include <magmpm/parameters/parameter_sections.h>
#include <magmpm/parameters/rigid_body_section.h>
#include <magmpm/particles/particle_quantities.h>

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
      output.particle_quantities = names_of(particle_quantities<3>());
      output.field_quantities    = names_of(field_quantities<3>());
      declarations.add("Frame interval",
                       output.frame_interval,
                       "s",
                       "Simulated time between two frames.",
                       positive);
      declarations.add("Particles", output.write_particles, "Whether particles are written.");
      declarations.add("Fields", output.write_fields, "Whether magnetic fields are written.");
      declarations.add("Rigid bodies",
                       output.write_rigid_bodies,
                       "Whether the surfaces of magnets and rigid bodies are written.");
      declarations.add("Surface",
                       output.write_surface,
                       "Whether a surface around the particles of each body is written.");
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
    input.magnets.resize(input.magnet_names.size());
    parameters.rigid_bodies.resize(input.rigid_body_names.size());
    input.materials.resize(input.material_names.size());
    input.rigid_body_motions.resize(input.rigid_body_names.size());

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
          declare_rigid_body(declarations, parameters.rigid_bodies[i], input.rigid_body_motions[i]);
        }
    }
    declare_walls(declarations, parameters.walls);
    declare_magnetics(declarations, input, parameters);
    declare_attraction(declarations, input, parameters.attraction);
    declare_rest(declarations, parameters.rest);
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
