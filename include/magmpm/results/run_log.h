#pragma once

#include <magmpm/materials/material_parameters.h>
#include <magmpm/results/run_output.h>

#include <mpi.h>

#include <chrono>
#include <deque>
#include <fstream>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace magmpm
{
  inline const RunOutput log_output = {"log.txt", "these lines"};

  /**
   * What a run says: on the terminal and, word for word, in `log.txt` of its output folder. First a
   * header, then a line a frame, at the end the timing table and where the results are. Rank 0
   * speaks; all functions may be called on every rank.
   */
  class RunLog
  {
  public:
    /** A body and what it is made of, for the header. */
    struct Body
    {
      std::string name;
      unsigned long n_particles = 0;  ///< of all ranks
      double density            = 0.; ///< undeformed [kg/m^3]
      MaterialParameters material;
      MagnetizationLaw magnetization_law = MagnetizationLaw::langevin; ///< of the scene
    };

    /** What the header tells of the scene. */
    struct Scene
    {
      int dimension                    = 3;
      double lattice_spacing           = 0.; ///< dx [m]
      unsigned long n_particles        = 0;  ///< of all ranks
      unsigned long potential_unknowns = 0;  ///< 0: no magnetic material
      double memory                    = 0.; ///< in use, of all ranks [bytes]; 0: not known
      double imbalance                 = 1.; ///< load of the most loaded rank over the mean
      std::vector<Body> bodies;
    };

    /** One frame, just finished. */
    struct Frame
    {
      unsigned int number = 0;   ///< from 1
      double time         = 0;   ///< t [s]
      double dt           = 0;   ///< of the last step [s]
      std::string limit;         ///< what bound dt: "elastic", "fixed", ...
      unsigned int n_solves = 0; ///< of the potential in this frame
      unsigned int newton   = 0; ///< steps of the latest solve
      unsigned int cg       = 0; ///< iterations of the latest solve, all its Newton steps together
      double max_speed      = 0; ///< [m/s]
    };

    /**
     * Opens log.txt in @p directory.
     *
     * @param n_frames        of the whole run, for percent and time left.
     * @param frame_interval  simulated time between frames [s]: tells the digits of t.
     * @param terminal        where the terminal's half goes (std::cout; tests listen elsewhere).
     * @param resumes         whether log.txt of an earlier run goes on.
     * @throw RunError on rank 0 if log.txt cannot be opened.
     */
    RunLog(const MPI_Comm communicator,
           const std::string &directory,
           const unsigned int n_frames,
           const double frame_interval,
           std::ostream &terminal,
           const bool resumes = false);
    ~RunLog();

    /** The first lines: versions (version_string()), ranks, lattice and particles, bodies. */
    void
    header(const Scene &scene);

    /** One line on a frame, with the wall time per frame and an estimate of what is left. */
    void
    frame(const Frame &frame);

    /** The ranks share the work anew: load of the most loaded one over the mean, before and now. */
    void
    rebalanced(const double imbalance_before, const double imbalance);

    /** A line of its own, for what is worth knowing once. */
    void
    message(const std::string &text);

    /** Like message(), but so that nobody overlooks it. */
    void
    warning(const std::string &text);

    /** log.txt, to whose end a rank that fails adds why (parallel::FailureLog). */
    std::string
    path() const;

    /**
     * The last lines: wall time of the run, and of run_outputs() and @p others what there is.
     *
     * @param others  outputs that are not those of this room.
     */
    void
    end(const std::vector<RunOutput> &others = {});

    /**
     * Terminal and log.txt in one stream, silent on all ranks but 0; for tables that others print
     * (PhaseTimer::print()).
     */
    std::ostream &
    stream();

  private:
    using Clock = std::chrono::steady_clock;

    /** Mean wall time of the recent frames [s]. */
    double
    seconds_per_frame() const;

    const unsigned int n_frames;
    const double frame_interval;
    const std::string directory;
    int n_ranks        = 1;
    bool has_potential = false; ///< whether the scene has one, as the header said

    class Splitter;
    std::ofstream file;
    std::unique_ptr<Splitter> splitter; ///< sends what is written to terminal and file
    std::unique_ptr<std::ostream> both;

    const Clock::time_point start;
    std::deque<Clock::time_point> frame_ends; ///< of recent frames, and the end before them
  };
} // namespace magmpm
