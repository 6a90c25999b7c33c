#include <magmpm/parallel/reduce.h>
#include <magmpm/parallel/together.h>
#include <magmpm/results/field_output.h>
#include <magmpm/results/results.h>
#include <magmpm/results/rigid_body_columns.h>
#include <magmpm/results/statistics_columns.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace magmpm
{
  namespace
  {
    void
    write_text(const std::string &path, const std::string &text)
    {
      std::ofstream file(path);
      file << text << std::flush;
      if (!file)
        throw RunError("cannot write '" + path +
                       "'; is the disk full, or the folder not writable?");
    }

    /** Makes the folder with its .prm files on rank 0; returns its name when all ranks can use it. */
    template <int dim>
    std::string
    prepare_folder(const Parameters<dim> &parameters, const MPI_Comm communicator)
    {
      const std::string directory = parameters.output.directory;
      parallel::on_first_rank(communicator, [&]() {
        try
          {
            std::filesystem::create_directories(directory);
            write_text(directory + "/original.prm", parameters.original_text);
            write_text(directory + "/parameters.prm", parameters.complete_text);
          }
        catch (const std::exception &exception)
          {
            throw RunError("the output folder '" + directory +
                           "' cannot be made: " + exception.what());
          }
      });
      return directory;
    }

    /** The memory that this process takes now [B]; zero where Linux does not say. */
    double
    resident_memory()
    {
      std::ifstream status("/proc/self/status");
      for (std::string word; status >> word;)
        if (double kilobytes = 0.; word == "VmRSS:" && status >> kilobytes)
          return 1024. * kilobytes;
      return 0.;
    }

    template <int dim>
    std::vector<std::string>
    names_of_bodies(const Parameters<dim> &parameters)
    {
      std::vector<std::string> names;
      for (const auto &body : parameters.bodies)
        names.push_back(body.name);
      return names;
    }
  } // namespace

  template <int dim>
  Results<dim>::Results(const Parameters<dim> &parameters,
                        const std::vector<std::string> &phases,
                        const MPI_Comm communicator,
                        const ResultsProgress *progress)
    : parameters(parameters)
    , communicator(communicator)
    , phases(phases)
    , run_log(communicator,
              prepare_folder(parameters, communicator),
              static_cast<unsigned int>(
                std::ceil(parameters.end_time / parameters.output.frame_interval - 1e-9)),
              parameters.output.frame_interval,
              std::cout,
              progress != nullptr)
    , statistics(communicator,
                 parameters.output.directory + "/statistics.csv",
                 statistics_columns<dim>(names_of_bodies(parameters),
                                         phases,
                                         rigid_body_columns(parameters)),
                 progress != nullptr ? progress->statistics_size : 0)
    , particle_output(communicator,
                      parameters.output.directory,
                      parameters.output.particle_quantities,
                      parameters.magnetics.model())
  {
    if (parameters.mesh.carries_potential && parameters.output.write_fields)
      field_output = std::make_unique<FieldOutput<dim>>(
        communicator, parameters.output.directory, parameters.output.field_quantities);
    if (parameters.output.write_surface)
      surface_output = std::make_unique<SurfaceOutput<dim>>(
        communicator, parameters.output.directory, parameters.lattice);
    if (progress == nullptr)
      return;
    particle_output.frames().resume(progress->particle_frames);
    if (field_output != nullptr)
      field_output->frames().resume(progress->field_frames);
    if (surface_output != nullptr)
      surface_output->frames().resume(progress->surface_frames);
    earlier_rigid_body_frames = progress->rigid_body_frames;
    solves_before             = progress->n_solves;
  }

  template <int dim>
  ResultsProgress
  Results<dim>::progress()
  {
    ResultsProgress progress;
    progress.statistics_size = statistics.size();
    progress.particle_frames = particle_output.frames().frames();
    if (field_output != nullptr)
      progress.field_frames = field_output->frames().frames();
    if (surface_output != nullptr)
      progress.surface_frames = surface_output->frames().frames();
    progress.rigid_body_frames = rigid_body_output != nullptr ? rigid_body_output->frames().frames()
                                                              : earlier_rigid_body_frames;
    progress.n_solves          = solves_before;
    return progress;
  }

  template <int dim>
  Results<dim>::~Results() = default;

  template <int dim>
  void
  Results<dim>::write_header(const RunState &state, const std::vector<Body<dim>> &bodies)
  {
    RunLog::Scene scene;
    scene.dimension          = dim;
    scene.lattice_spacing    = parameters.lattice.spacing;
    scene.potential_unknowns = state.last_solve.n_unknowns;
    scene.memory             = parallel::sum(resident_memory(), communicator);
    scene.imbalance          = state.imbalance;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        const BodyParameters<dim> &body = parameters.bodies[b];
        const unsigned long n_particles = parallel::sum<unsigned long>(bodies[b].particles.size(),
                                                                       communicator);
        scene.n_particles += n_particles;
        scene.bodies.push_back({body.name,
                                n_particles,
                                body.density,
                                parameters.material_of(body),
                                parameters.magnetics.law});
      }
    run_log.header(scene);
    for (const std::string &warning : parameters.warnings)
      run_log.warning(warning);
  }

  template <int dim>
  void
  Results<dim>::write_particles(const RunState &state, const std::vector<Body<dim>> &bodies)
  {
    if (!parameters.output.write_particles)
      return;
    particle_output.write_frame(state.frame, state.time, bodies);
  }

  template <int dim>
  void
  Results<dim>::write_surface(const RunState &state, const std::vector<Body<dim>> &bodies)
  {
    if (surface_output != nullptr)
      surface_output->write_frame(state.frame, state.time, bodies);
  }

  template <int dim>
  void
  Results<dim>::write_fields(const RunState &state,
                             const PotentialProblem<dim> &potential,
                             const ExternalField<dim> &sources)
  {
    field_output->write_frame(state.frame, state.time, potential, sources);
  }

  template <int dim>
  void
  Results<dim>::write_rigid_bodies(const RunState &state,
                                   const ExternalField<dim> &sources,
                                   const RigidBodies<dim> &bodies)
  {
    if (!parameters.output.write_rigid_bodies)
      return;
    if (rigid_body_output == nullptr)
      {
        rigid_body_output =
          std::make_unique<RigidBodyOutput<dim>>(communicator,
                                                 parameters.output.directory,
                                                 sources,
                                                 bodies,
                                                 0.5 * parameters.lattice.spacing);
        rigid_body_output->frames().resume(earlier_rigid_body_frames);
      }
    rigid_body_output->write_frame(state.frame, state.time);
  }

  template <int dim>
  void
  Results<dim>::report_frame(const RunState &state)
  {
    RunLog::Frame frame;
    frame.number    = state.frame;
    frame.time      = state.time;
    frame.dt        = state.full_time_step;
    frame.limit     = state.full_limit;
    frame.n_solves  = state.n_solves - solves_before;
    frame.newton    = state.last_solve.newton.steps;
    frame.cg        = state.last_solve.newton.linear_iterations;
    frame.max_speed = state.max_speed;
    run_log.frame(frame);
    solves_before = state.n_solves;
  }

  template <int dim>
  void
  Results<dim>::write_statistics(const RunState &state,
                                 const std::vector<ParticleSums<dim>> &sums,
                                 const double fewest_particles,
                                 const std::map<std::string, double> &seconds,
                                 const RigidBodies<dim> &rigid_bodies,
                                 const std::vector<ForceAndTorque<dim>> &forces)
  {
    ParticleSums<dim> total;
    for (const ParticleSums<dim> &sum : sums)
      total += sum;
    const SolveReport &solve = state.last_solve;

    statistics.set("step", state.step);
    statistics.set("time", state.time);
    statistics.set("dt", state.time_step);
    statistics.set("limit of dt", state.limit);
    statistics.set("particles", total.n_particles);
    statistics.set("lost particles", state.lost_particles);
    statistics.set("held particles", state.held_particles);
    statistics.set("migrated particles", state.migrated_particles);
    statistics.set("fewest particles of a rank", fewest_particles);
    statistics.set("load imbalance", state.imbalance);
    statistics.set("mesh changes", state.mesh_changes);
    statistics.set("kinetic energy", total.kinetic_energy);
    statistics.set("elastic energy", total.elastic_energy);
    statistics.set("gravitational energy", total.gravitational_energy);
    statistics.set("magnetic energy", solve.energy);
    statistics.set("momentum", total.momentum);
    statistics.set("angular momentum", total.angular_momentum);
    statistics.set("centre of mass",
                   (total.mass > 0. ? 1. / total.mass : 0.) * total.mass_times_position);
    statistics.set("max |v|", total.max_speed);
    statistics.set("min J", std::min(total.min_volume_ratio, total.max_volume_ratio));
    statistics.set("max J", total.max_volume_ratio);
    statistics.set("density error", state.density_error);
    statistics.set("max |H|", total.max_field);
    statistics.set("max |M|", total.max_magnetization);
    for (std::size_t b = 0; b < sums.size(); ++b)
      {
        const std::string &body = parameters.bodies[b].name;
        statistics.set(body_column(body, "magnetic force"), sums[b].magnetic_force);
        statistics.set(body_column(body, "magnetic moment"), sums[b].magnetic_moment);
      }
    set_rigid_body_columns(parameters, rigid_bodies, forces, state, statistics);
    const bool solved = state.solved_this_step;
    statistics.set("magnetic solves", state.n_solves);
    statistics.set("Newton steps", solved ? solve.newton.steps : 0);
    statistics.set("line search steps", solved ? solve.newton.line_search_steps : 0);
    statistics.set("CG iterations", solved ? solve.newton.linear_iterations : 0);
    statistics.set("Newton residual", solved ? solve.relative_final_residual() : 0.);
    statistics.set("dropped magnetic force", state.dropped_magnetic_force);
    statistics.set("clipped fractions", static_cast<double>(solve.clipped_fractions));
    statistics.set("clipped corrections", static_cast<double>(solve.clipped_corrections));
    statistics.set("potential unknowns", static_cast<double>(solve.n_unknowns));
    for (const std::string &phase : phases)
      {
        const auto found = seconds.find(phase);
        const double now = (found == seconds.end() ? 0. : found->second);
        statistics.set(phase_column(phase), now - seconds_before[phase]);
        seconds_before[phase] = now;
      }
    statistics.write_row();
  }

  template <int dim>
  void
  Results<dim>::flush()
  {
    statistics.flush();
  }

  template class Results<2>;
  template class Results<3>;
} // namespace magmpm
