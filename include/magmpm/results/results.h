#pragma once

#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/coupling/column_table.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/results/particle_output.h>
#include <magmpm/results/rigid_body_output.h>
#include <magmpm/results/run_log.h>
#include <magmpm/results/statistics_file.h>
#include <magmpm/results/surface_output.h>

#include <mpi.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace magmpm
{
  template <int dim>
  class FieldOutput;
  template <int dim>
  class PotentialProblem;
  template <int dim>
  class BlockPartition;
  template <int dim>
  class ExternalField;

  /** A frame's number and time [s]. */
  struct FrameTime
  {
    unsigned int number;
    double time;
  };

  /** What the first lines of the log tell besides particles. */
  struct SceneSize
  {
    unsigned long long potential_unknowns; ///< 0: no magnetic material
    double imbalance;                      ///< load of the most loaded rank over the mean
  };

  /** How far the files of a run got, for a checkpoint. */
  struct ResultsProgress
  {
    std::uintmax_t statistics_size = 0; ///< [bytes]
    /** Time [s] and file of each. */
    std::vector<std::pair<double, std::string>> particle_frames, field_frames, rigid_body_frames,
      surface_frames;
    unsigned int n_solves = 0; ///< of the potential, until the last line of the log

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &statistics_size;
      archive &particle_frames;
      archive &field_frames;
      archive &rigid_body_frames;
      archive &surface_frames;
      archive &n_solves;
    }
  };

  /**
   * The output folder of a run: original.prm, parameters.prm, log.txt, statistics.csv, and the
   * frames particles.pvd, fields.pvd, surface.pvd and rigid_bodies.pvd. All functions are collective.
   */
  template <int dim>
  class Results
  {
  public:
    /**
     * Opens the files of the folder of results, which must be there.
     *
     * @param columns   of statistics.csv, before those of the phases.
     * @param phases    timer sections that are columns of the statistics.
     * @param progress  how far an earlier run got: its files go on from there, and what they say of later
     *                  times is taken back. Null: the files are new.
     * @throw RunError if the folder or a file cannot be made, or continued.
     */
    Results(const Parameters<dim> &parameters,
            const ColumnTable &columns,
            const std::vector<std::string> &phases,
            const MPI_Comm communicator,
            const ResultsProgress *progress = nullptr);
    ~Results();

    RunLog &
    log()
    {
      return run_log;
    }

    /** The first lines of the log. */
    void
    write_header(const SceneSize &size, const std::vector<Body<dim>> &bodies);

    /** particles.pvd, if the scene wants it. */
    void
    write_particles(const FrameTime &frame, const std::vector<Body<dim>> &bodies);

    /** surface.pvd, if the scene wants it. */
    void
    write_surface(const FrameTime &frame, const std::vector<Body<dim>> &bodies);

    /** Whether the scene has a potential and wants its fields written. */
    bool
    writes_fields() const
    {
      return field_output != nullptr;
    }

    /** fields.pvd; only if writes_fields(). For the arguments see FieldOutput::write_frame(). */
    void
    write_fields(const FrameTime &frame,
                 const PotentialProblem<dim> &potential,
                 const ExternalField<dim> &sources);

    /** rigid_bodies.pvd, where magnets and rigid bodies are now. */
    void
    write_rigid_bodies(const FrameTime &frame,
                       const ExternalField<dim> &sources,
                       const RigidBodies<dim> &bodies);

    /** The line of a frame on the terminal. @param n_solves  of the potential, so far. */
    void
    report_frame(RunLog::Frame frame, const unsigned int n_solves);

    /** One row of statistics.csv. @param seconds  of each phase so far, on this rank. */
    void
    write_row(const std::map<std::string, double> &seconds);

    /** How far the files got; what counts is that of rank 0. */
    ResultsProgress
    progress();

    /** Makes sure that what was written survives an early end. */
    void
    flush();

  private:
    const Parameters<dim> parameters;
    const MPI_Comm communicator;
    const ColumnTable columns;
    const std::vector<std::string> phases;

    StatisticsFile statistics; ///< first: it may refuse to go on, before anything is changed
    RunLog run_log;
    ParticleOutput<dim> particle_output;
    std::unique_ptr<FieldOutput<dim>> field_output;          ///< null without magnetic material
    std::unique_ptr<RigidBodyOutput<dim>> rigid_body_output; ///< null before the first frame
    std::vector<std::pair<double, std::string>> earlier_rigid_body_frames; ///< of a resumed run
    std::unique_ptr<SurfaceOutput<dim>> surface_output;                    ///< null if not wanted

    std::map<std::string, double> seconds_before; ///< the last row, by phase
    unsigned int solves_before = 0;               ///< the last line of the log
  };
} // namespace magmpm
