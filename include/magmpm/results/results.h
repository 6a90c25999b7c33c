#pragma once

#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/results/particle_output.h>
#include <magmpm/results/rigid_body_output.h>
#include <magmpm/results/run_log.h>
#include <magmpm/results/statistics_file.h>
#include <magmpm/results/surface_output.h>
#include <magmpm/simulation/run_state.h>

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
  class NodeField;
  template <int dim>
  class ExternalField;

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
   * frames particles.pvd, fields.pvd and surface.pvd. All functions are collective.
   */
  template <int dim>
  class Results
  {
  public:
    /**
     * Makes the folder and opens its files.
     *
     * @param phases    timer sections that are columns of the statistics.
     * @param progress  how far an earlier run got: its files go on from there, and what they say of later
     *                  times is taken back. Null: the files are new.
     * @throw RunError if the folder or a file cannot be made, or continued.
     */
    Results(const Parameters<dim> &parameters,
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
    write_header(const RunState &state, const std::vector<Body<dim>> &bodies);

    /** particles.pvd, if the scene wants it. */
    void
    write_particles(const RunState &state, const std::vector<Body<dim>> &bodies);

    /** surface.pvd, if the scene wants it. */
    void
    write_surface(const RunState &state, const std::vector<Body<dim>> &bodies);

    /** Whether the scene has a potential and wants its fields written. */
    bool
    writes_fields() const
    {
      return field_output != nullptr;
    }

    /** fields.pvd; only if writes_fields(). For the arguments see FieldOutput::write_frame(). */
    void
    write_fields(const RunState &state,
                 const PotentialProblem<dim> &potential,
                 const ExternalField<dim> &sources);

    /** rigid_bodies.pvd, where magnets and rigid bodies are now. */
    void
    write_rigid_bodies(const RunState &state,
                       const ExternalField<dim> &sources,
                       const RigidBodies<dim> &bodies);

    /** The line of a frame on the terminal. */
    void
    report_frame(const RunState &state);

    /**
     * One row of statistics.csv.
     *
     * @param sums                    of each body, over all ranks.
     * @param fewest_particles        held by a rank.
     * @param seconds                 of each phase so far, on this rank.
     * @param forces                  on each source.
     */
    void
    write_statistics(const RunState &state,
                     const std::vector<ParticleSums<dim>> &sums,
                     const double fewest_particles,
                     const std::map<std::string, double> &seconds,
                     const RigidBodies<dim> &rigid_bodies,
                     const std::vector<ForceAndTorque<dim>> &forces);

    /** How far the files got; what counts is that of rank 0. */
    ResultsProgress
    progress();

    /** Makes sure that what was written survives an early end. */
    void
    flush();

  private:
    const Parameters<dim> parameters;
    const MPI_Comm communicator;
    const std::vector<std::string> phases;

    RunLog run_log;
    StatisticsFile statistics;
    ParticleOutput<dim> particle_output;
    std::unique_ptr<FieldOutput<dim>> field_output;          ///< null without magnetic material
    std::unique_ptr<RigidBodyOutput<dim>> rigid_body_output; ///< null before the first frame
    std::vector<std::pair<double, std::string>> earlier_rigid_body_frames; ///< of a resumed run
    std::unique_ptr<SurfaceOutput<dim>> surface_output;                    ///< null if not wanted

    std::map<std::string, double> seconds_before; ///< the last row, by phase
    unsigned int solves_before = 0;               ///< the last line of the log
  };
} // namespace magmpm
