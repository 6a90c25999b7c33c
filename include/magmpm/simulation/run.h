#pragma once

#include <magmpm/parallel/error_report.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/results/results.h>
#include <magmpm/simulation/checkpoint.h>
#include <magmpm/simulation/output_lock.h>
#include <magmpm/simulation/rest_check.h>
#include <magmpm/simulation/run_control.h>
#include <magmpm/simulation/scene.h>
#include <magmpm/simulation/start.h>

#include <mpi.h>

#include <optional>
#include <string>

namespace magmpm
{
  /**
   * A scene from its parameters to its results: frames and statistics, log, checkpoints, signals, and when
   * it ends.
   */
  template <int dim>
  class Run
  {
  public:
    /**
     * Takes the output directory, in which nothing is changed unless all is well.
     *
     * @throw InputError  if another run is at work there, if an earlier one left a checkpoint (afresh), or
     *                    if there is none or one of another scene (resume).
     * @throw RunError    if the checkpoint is damaged or of another version.
     */
    Run(const Parameters<dim> &parameters, const MPI_Comm communicator, const Start start);

    /**
     * Until the end time, or until somebody asks it to stop (see RunControl).
     *
     * @param failures  learns where the log is.
     * @throw RunError if a particle runs away or a solver fails.
     */
    void
    run(parallel::FailureLog &failures);

  private:
    /** What a run must remember besides its scene. */
    struct Progress
    {
      unsigned int frame   = 0;   ///< the last one written
      double at_rest_since = -1.; ///< RestCheck::since
      ResultsProgress results;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &frame;
        archive &at_rest_since;
        archive &results;
      }
    };

    /** The checkpoint to go on from; nothing if the run starts anew. Changes no file. */
    std::optional<Checkpoint>
    checkpoint_for(const Start start) const;

    /** Brings the scene to where the checkpoint, if there is one, was written. Changes no file. */
    Progress
    load(const std::optional<Checkpoint> &checkpoint);

    /** The first lines of the log, and, if the run starts anew, the first row and frame. */
    void
    begin();

    /** One step and what is told of it. */
    void
    advance_one_step();

    double
    time_of_next_frame() const; ///< or of the end [s]

    bool
    is_at_end() const;

    bool
    is_stopped() const;

    bool
    checkpoint_is_due(const bool frame_is_complete) const;

    void
    write_checkpoint();

    void
    write_frame();

    /** The line of a frame in the log. */
    void
    report_frame();

    void
    write_row();

    /** Hands what the scene has to say to the log. */
    void
    tell_notices();

    void
    tell_why_it_ended();

    const Parameters<dim> parameters;
    const MPI_Comm communicator;
    const OutputLock lock;
    const CheckpointFolder checkpoints;
    const std::optional<Checkpoint> resumed;

    Scene<dim> scene;
    Progress progress;
    Results<dim> results;
    RestCheck rest;
    RunControl control;
    RunControl::Request request = RunControl::Request::none; ///< of all ranks, in the last step
  };
} // namespace magmpm
