#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/base/version.h>
#include <magmpm/parallel/ranks.h>
#include <magmpm/simulation/parameter_changes.h>
#include <magmpm/simulation/run.h>

#include <algorithm>
#include <cstdio>

namespace magmpm
{
  namespace
  {
    using Scope = parallel::PhaseTimer::Scope;

    constexpr const char *run_section          = "run";
    constexpr unsigned int run_section_version = 1;

    template <int dim>
    ColumnsToWrite
    columns_of(const ParticleSet<dim> &particles)
    {
      ColumnsToWrite columns = {{particles.ids().data(), particles.size() * sizeof(std::uint64_t)}};
      for (int q = 0; q < n_particle_properties; ++q)
        for (int c = 0; c < particles.n_components(ParticleProperty(q)); ++c)
          columns.push_back(
            {particles.component(ParticleProperty(q), c), particles.size() * sizeof(double)});
      return columns;
    }

    /** Makes room for n more particles. */
    template <int dim>
    std::vector<Bytes>
    room_in(ParticleSet<dim> &particles, const std::size_t n)
    {
      const std::size_t first = particles.size();
      particles.resize(first + n);
      std::vector<Bytes> columns = {{particles.ids().data() + first, n * sizeof(std::uint64_t)}};
      for (int q = 0; q < n_particle_properties; ++q)
        for (int c = 0; c < particles.n_components(ParticleProperty(q)); ++c)
          columns.push_back(
            {particles.component(ParticleProperty(q), c) + first, n * sizeof(double)});
      return columns;
    }
  } // namespace

  template <int dim>
  Run<dim>::Run(const Parameters<dim> &run_parameters,
                const MPI_Comm communicator,
                const Start start)
    : parameters(run_parameters)
    , communicator(communicator)
    , lock(communicator, parameters.output.directory, start != Start::resume)
    , checkpoints(communicator, parameters.output.directory, parameters.checkpoint.n_kept)
    , resumed(checkpoint_for(start))
    , scene(parameters, communicator)
    , progress(load(resumed))
    , results(parameters,
              scene.columns(),
              scene.phases,
              communicator,
              resumed ? &progress.results : nullptr)
    , rest(parameters.rest)
    , control(parameters.checkpoint, parameters.output.directory, parallel::rank(communicator))
  {
    rest.since = progress.at_rest_since;
    if (!resumed)
      checkpoints.clear();
  }

  template <int dim>
  std::optional<Checkpoint>
  Run<dim>::checkpoint_for(const Start start) const
  {
    if (start == Start::resume)
      {
        Checkpoint checkpoint = checkpoints.read();
        check_resumable(parameters.complete_text, checkpoint.parameters);
        return checkpoint;
      }
    const std::string latest = checkpoints.latest();
    if (start == Start::afresh && !latest.empty())
      throw InputError("an earlier run left the checkpoint '" + latest +
                       "', which a run that starts anew would remove. Go on from it with --resume, "
                       "choose another 'Output directory', or replace that run with --overwrite.");
    return {};
  }

  template <int dim>
  typename Run<dim>::Progress
  Run<dim>::load(const std::optional<Checkpoint> &checkpoint)
  {
    Progress loaded;
    if (!checkpoint)
      return loaded;
    std::vector<SectionTitle> expected = scene.titles();
    expected.push_back({run_section, run_section_version});
    check_titles(checkpoint->titles(), expected);

    unpack(section_named(run_section, checkpoint->sections), loaded);
    scene.load(checkpoint->sections, [&](std::vector<Body<dim>> &bodies) {
      checkpoints.read_particles(*checkpoint, [&](const std::size_t body, const std::size_t n) {
        if (body >= bodies.size())
          throw RunError("there are particles of more bodies than the scene has");
        return room_in(bodies[body].particles, n);
      });
    });
    return loaded;
  }

  template <int dim>
  void
  Run<dim>::run(parallel::FailureLog &failures)
  {
    failures.append_to(results.log().path());
    try
      {
        begin();
        while (!is_at_end() && !is_stopped())
          advance_one_step();
      }
    catch (...)
      {
        tell_notices();
        results.flush();
        throw;
      }
    scene.timer().print(communicator, results.log().stream());
    tell_why_it_ended();
    results.log().end({checkpoint_output});
  }

  template <int dim>
  void
  Run<dim>::begin()
  {
    if (!resumed)
      scene.begin();
    results.write_header({scene.magnetics().state().report.n_unknowns, scene.progress().imbalance},
                         scene.bodies());
    tell_notices();
    if (!resumed)
      {
        write_row();
        write_frame();
        return;
      }
    results.log().message("resumed at frame " + std::to_string(progress.frame) + ", t = " +
                          three_digits(scene.time()) + " s, from " + checkpoints.latest());
    const std::string changes = check_resumable(parameters.complete_text, resumed->parameters);
    if (!changes.empty())
      results.log().message("parameters changed since the checkpoint:" + changes);
    if (resumed->version != version_string())
      results.log().warning("the checkpoint was written by another program: " + resumed->version);
  }

  template <int dim>
  void
  Run<dim>::advance_one_step()
  {
    const unsigned int next   = scene.progress().clock.step + 1;
    const bool rest_is_due    = rest.is_due(next);
    const bool row_is_due     = next % parameters.output.statistics_every == 0;
    RunControl::Request asked = control.request();
    scene.step({time_of_next_frame(), row_is_due || rest_is_due, [&](auto &reduction) {
                  reduction.max(asked);
                }});
    request = asked;
    tell_notices();

    if (rest_is_due)
      {
        const ParticleSums<dim> total = scene.total();
        rest.note_speed(2. * total.kinetic_energy / total.mass, scene.time());
      }
    if (row_is_due || rest.is_over(scene.time()))
      write_row();
    const bool frame_is_complete = rest.is_over(scene.time()) ||
                                   scene.time() >= (1. - 1e-9) * time_of_next_frame();
    if (frame_is_complete)
      {
        ++progress.frame;
        write_frame();
      }
    if (checkpoint_is_due(frame_is_complete))
      write_checkpoint();
  }

  template <int dim>
  double
  Run<dim>::time_of_next_frame() const
  {
    return std::min((progress.frame + 1) * parameters.output.frame_interval, parameters.end_time);
  }

  template <int dim>
  bool
  Run<dim>::is_at_end() const
  {
    return rest.is_over(scene.time()) || scene.time() >= (1. - 1e-12) * parameters.end_time;
  }

  template <int dim>
  bool
  Run<dim>::is_stopped() const
  {
    return request > RunControl::Request::checkpoint;
  }

  template <int dim>
  bool
  Run<dim>::checkpoint_is_due(const bool frame_is_complete) const
  {
    const CheckpointParameters &wanted = parameters.checkpoint;
    if (wanted.every_n_frames > 0 && frame_is_complete &&
        progress.frame % wanted.every_n_frames == 0)
      return true;
    return request != RunControl::Request::none || (is_at_end() && wanted.is_wanted());
  }

  template <int dim>
  void
  Run<dim>::write_frame()
  {
    const Scope timed(scene.timer(), "Output");
    const FrameTime frame = {progress.frame, scene.time()};
    if (progress.frame > 0)
      report_frame();
    results.write_particles(frame, scene.bodies());
    results.write_surface(frame, scene.bodies());
    if (results.writes_fields() && scene.magnetics().is_active())
      {
        scene.update_potential();
        results.write_fields(frame, scene.magnetics().potential(), scene.magnets());
      }
    scene.move_bodies_to_now();
    results.write_rigid_bodies(frame, scene.magnets(), scene.rigid_bodies());
    results.flush();
  }

  template <int dim>
  void
  Run<dim>::report_frame()
  {
    const SceneState<dim> &state = scene.progress();
    const NewtonReport &newton   = scene.magnetics().state().report.newton;
    RunLog::Frame frame;
    frame.number    = progress.frame;
    frame.time      = state.clock.time;
    frame.dt        = state.last_full_step.length;
    frame.limit     = state.last_full_step.limit;
    frame.newton    = newton.steps;
    frame.cg        = newton.linear_iterations;
    frame.max_speed = state.max_speed;
    results.report_frame(frame, scene.magnetics().state().n_solves);
  }

  template <int dim>
  void
  Run<dim>::write_row()
  {
    const Scope timed(scene.timer(), "Statistics");
    scene.prepare_row();
    results.write_row(scene.timer().seconds());
    scene.end_row();
  }

  template <int dim>
  void
  Run<dim>::write_checkpoint()
  {
    const Scope timed(scene.timer(), "Checkpoint");
    progress.at_rest_since = rest.since;
    progress.results       = results.progress();
    Checkpoint checkpoint;
    checkpoint.version    = version_string();
    checkpoint.parameters = parameters.complete_text;
    checkpoint.sections   = scene.save();
    checkpoint.sections.push_back({{run_section, run_section_version}, pack(progress)});
    std::vector<ColumnsToWrite> particles;
    for (const Body<dim> &body : scene.bodies())
      particles.push_back(columns_of(body.particles));

    char name[32];
    std::snprintf(name, sizeof(name), "step-%010u", scene.progress().clock.step);
    try
      {
        checkpoints.write(name, checkpoint, particles);
      }
    catch (const RunError &error)
      {
        // A run that has room to go on does so; one that ends here would lose everything.
        if (is_stopped())
          throw;
        results.log().warning(error.what());
      }
    control.restart_interval();
    control.clear_stop_file();
  }

  template <int dim>
  void
  Run<dim>::tell_notices()
  {
    for (const Notice &notice : scene.take_notices())
      if (notice.is_warning)
        results.log().warning(notice.text);
      else
        results.log().message(notice.text);
  }

  template <int dim>
  void
  Run<dim>::tell_why_it_ended()
  {
    if (is_stopped())
      results.log().message("stopped by " + RunControl::reason(request) +
                            "; go on with: magmpm --resume, and the same parameter file");
    else if (rest.is_over(scene.time()))
      results.log().message("ended since " + rest.reason());
    else
      results.log().message("ended at the end time");
  }

  template class Run<2>;
  template class Run<3>;
} // namespace magmpm
