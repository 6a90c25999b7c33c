#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/parallel/together.h>
#include <magmpm/results/field_output.h>
#include <magmpm/results/results.h>
#include <magmpm/results/run_outputs.h>

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

    std::vector<StatisticsColumn>
    statistics_columns(const ColumnTable &table, const std::vector<std::string> &phases)
    {
      std::vector<StatisticsColumn> columns;
      for (const Column &column : table.all())
        columns.push_back({column.name, column.unit});
      for (const std::string &phase : phases)
        columns.push_back({phase_column(phase), "s"});
      return columns;
    }
  } // namespace

  template <int dim>
  Results<dim>::Results(const Parameters<dim> &parameters,
                        const ColumnTable &columns,
                        const std::vector<std::string> &phases,
                        const MPI_Comm communicator,
                        const ResultsProgress *progress)
    : parameters(parameters)
    , communicator(communicator)
    , columns(columns)
    , phases(phases)
    , statistics(communicator,
                 parameters.output.directory + "/statistics.csv",
                 statistics_columns(columns, phases),
                 progress != nullptr ? progress->statistics_size : 0)
    , run_log(communicator,
              parameters.output.directory,
              static_cast<unsigned int>(
                std::ceil(parameters.end_time / parameters.output.frame_interval - 1e-9)),
              parameters.output.frame_interval,
              std::cout,
              progress != nullptr)
    , particle_output(communicator,
                      parameters.output.directory,
                      parameters.output.particle_quantities,
                      parameters.magnetics.model())
  {
    parallel::on_first_rank(communicator, [&]() {
      if (progress == nullptr)
        remove_earlier_frames(parameters.output.directory);
      write_text(parameters.output.directory + "/original.prm", parameters.original_text);
      write_text(parameters.output.directory + "/parameters.prm", parameters.complete_text);
    });
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
  Results<dim>::write_header(const SceneSize &size, const std::vector<Body<dim>> &bodies)
  {
    RunLog::Scene scene;
    scene.dimension          = dim;
    scene.lattice_spacing    = parameters.lattice.spacing;
    scene.potential_unknowns = size.potential_unknowns;
    scene.memory             = parallel::sum(resident_memory(), communicator);
    scene.imbalance          = size.imbalance;
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
  Results<dim>::write_particles(const FrameTime &frame, const std::vector<Body<dim>> &bodies)
  {
    if (!parameters.output.write_particles)
      return;
    particle_output.write_frame(frame.number, frame.time, bodies);
  }

  template <int dim>
  void
  Results<dim>::write_surface(const FrameTime &frame, const std::vector<Body<dim>> &bodies)
  {
    if (surface_output != nullptr)
      surface_output->write_frame(frame.number, frame.time, bodies);
  }

  template <int dim>
  void
  Results<dim>::write_fields(const FrameTime &frame,
                             const PotentialProblem<dim> &potential,
                             const ExternalField<dim> &sources)
  {
    field_output->write_frame(frame.number, frame.time, potential, sources);
  }

  template <int dim>
  void
  Results<dim>::write_rigid_bodies(const FrameTime &frame,
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
    rigid_body_output->write_frame(frame.number, frame.time);
  }

  template <int dim>
  void
  Results<dim>::report_frame(RunLog::Frame frame, const unsigned int n_solves)
  {
    frame.n_solves = n_solves - solves_before;
    run_log.frame(frame);
    solves_before = n_solves;
  }

  template <int dim>
  void
  Results<dim>::write_row(const std::map<std::string, double> &seconds)
  {
    for (const Column &column : columns.all())
      if (column.number)
        statistics.set(column.name, column.number());
      else
        statistics.set(column.name, column.text());
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
