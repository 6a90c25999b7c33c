#pragma once

#include <magmpm/coupling/carried_reaction.h>
#include <magmpm/coupling/clock.h>
#include <magmpm/coupling/coupling.h>
#include <magmpm/coupling/solve_trigger_parameters.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/magnetics/magnetics_parameters.h>
#include <magmpm/magnetics/solve_report.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/mesh/background_mesh.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <memory>
#include <optional>
#include <vector>

namespace magmpm
{
  template <int dim>
  class PotentialProblem;

  /** What the magnetic coupling takes from the parameters of a scene. */
  template <int dim>
  struct MagneticCouplingParameters
  {
    Lattice<dim> lattice;
    MagneticsParameters<dim> magnetics;
    SolveTriggerParameters trigger;
    bool moves_magnets =
      false; ///< whether a magnet is free, so that each solve finds what moves it

    /**
     * Where no node around has this mass [kg], the heaviest ones alone take the magnetic force: so it is at the
     * tips of spikes, which would spray, but not at the edge of a flat surface.
     */
    double thin_mass = 0.;
  };

  /** How far the material has moved since the last solve, on which the carried force depends. */
  struct SolveAge
  {
    double drift       = 0.; ///< the longest way of magnetic particles, or more [m]
    double path        = 0.; ///< the sum of the steps of the fastest particles [m]
    double carried_way = 0.; ///< for which the carried force was advanced [m]

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &drift;
      archive &path;
      archive &carried_way;
    }
  };

  /** The interval from the last solve to the next. */
  struct SolveInterval
  {
    bool has_rate = false; ///< whether the force goes on changing in it
    double share  = 1.;    ///< of what is tolerated that it may take; see next_share()

    /** The age at which it is looked at next whether all stands still [s], and the change at the last look [m]. */
    double next_look      = 0.;
    double change_at_look = 0.;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &has_rate;
      archive &share;
      archive &next_look;
      archive &change_at_look;
    }
  };

  /** What the magnetic coupling must remember from step to step. */
  template <int dim>
  struct MagneticState
  {
    bool is_over               = false; ///< the magnets act no more (MagneticCoupling::end())
    unsigned int n_solves      = 0;     ///< of the potential, so far
    bool solved_this_step      = false;
    unsigned int step_of_solve = 0;  ///< the last one
    double time_of_solve       = 0.; ///< [s]
    SolveReport report;              ///< of the last one
    Vector<dim> dropped_force;       ///< at the last solve, on no mass: reaches no particle [N]
    SolveAge age;
    SolveInterval interval;
    CarriedReactions<dim> reactions; ///< empty until somebody asks for them
    double max_wave_speed   = 0.;    ///< that magnetization adds [m/s]
    double max_acceleration = 0.;    ///< of a particle by magnets [m/s^2]

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &is_over;
      archive &n_solves;
      archive &solved_this_step;
      archive &step_of_solve;
      archive &time_of_solve;
      archive &report;
      archive &dropped_force;
      archive &age;
      archive &interval;
      archive &reactions;
      archive &max_wave_speed;
      archive &max_acceleration;
    }
  };

  /**
   * The potential problem and the particles that make its material and carry its force: when it is
   * solved, and what happens to the force between two solves. Without magnetic material it costs nothing.
   */
  template <int dim>
  class MagneticCoupling : public Coupling
  {
  public:
    /** @param external_field, timer  must outlive this object. */
    MagneticCoupling(const MagneticCouplingParameters<dim> &parameters,
                     ExternalField<dim> &external_field,
                     parallel::PhaseTimer &timer,
                     const MPI_Comm communicator);
    ~MagneticCoupling() override;

    /** Prepares the potential problem of a scene with magnetic material; both must outlive its solves. */
    void
    set_up(const BackgroundMesh<dim> &mesh, const BlockPartition<dim> &partition);

    /** Lets go of mesh and partition, which may end after this; until set_up() nothing is solved. */
    void
    reset();

    /**
     * Brings the force that particles carry to the present step: solves the potential if it no longer
     * serves, Eqs. (25)-(33) of Sun et al. 2021. Collective.
     */
    void
    update(const Clock &clock, std::vector<Body<dim>> &bodies);

    /** The fastest particle went this way in a step [m]. */
    void
    note_motion(const double way);

    /** Finds what the carried force did since the last solve, for this step's row; reduce() sums it. */
    void
    find_work(const std::vector<Body<dim>> &bodies);

    void
    reduce(parallel::Reduction &reduction) override;

    /** Makes an end of the magnets: particles carry no force of them, and the potential is not solved again. */
    void
    end(std::vector<Body<dim>> &bodies);

    /** Finds the potential on the present mesh, if that changed since the last solve. Collective. */
    void
    solve_for_output(std::vector<Body<dim>> &bodies);

    /** Whether there is a potential, and potential() may be asked for. */
    bool
    is_active() const
    {
      return problem != nullptr;
    }

    const PotentialProblem<dim> &
    potential() const
    {
      return *problem;
    }

    const MagneticState<dim> &
    state() const
    {
      return memory;
    }

    void
    limit_step(StepConditions &conditions) const override;

    /** Finds what the material does to the sources, if the last solve did not and its mesh is still there. */
    void
    prepare_row() override;

    void
    add_columns(ColumnTable &table) const override;

    SectionTitle
    title() const override;

    std::string
    save() const override;

    void
    load(const std::string &bytes) override;

  private:
    /** The way of the material and the sources since the last solve, per which the force changes [m]. */
    double
    way_of_force() const;

    /** The part of the sources in it [m]. */
    double
    change_of_sources() const;

    /** Lets the carried force follow the motion since the last solve. */
    void
    advance_force(std::vector<Body<dim>> &bodies);

    /** Finds the drift exactly. Collective. */
    void
    find_drift(const std::vector<Body<dim>> &bodies);

    /**
     * Finds the drift exactly, if its upper bound is beyond what is tolerated. Lets the force rest at its
     * last value if the material only vibrates. Collective.
     */
    void
    update_age(std::vector<Body<dim>> &bodies);

    /** Whether the force that particles carry no longer serves. */
    bool
    is_due(const Clock &clock) const;

    /**
     * Whether motion has stopped before the next solve was due, so that the force stays that of another place:
     * looked at when it is as old as the interval of the last two solves, and 2, 4, 8, .. times as old. It has
     * where material and sources are noticeably from where they were at the solve and hardly further than at the
     * look before. What vibrates for ever is so solved for at intervals that at least double. Collective.
     */
    bool
    has_stopped(const Clock &clock, const std::vector<Body<dim>> &bodies);

    /** The share of what the parameters tolerate that may change before the next solve. */
    double
    tolerated_share() const;

    /** By how much material may move between two solves [m]. */
    double
    tolerated_drift() const;

    /** What changed since the last solve over what the parameters tolerate. */
    double
    taken_share() const;

    /**
     * Solves the potential and lets the particles carry the force.
     *
     * @param way  since the solve before, for the rate of the force; 0: none [m].
     */
    void
    solve(const Clock &clock, const double way, std::vector<Body<dim>> &bodies);

    /** Finds the potential of the present material, Eqs. (25)-(30). */
    void
    solve_potential(std::vector<Body<dim>> &bodies);

    /** The densities of grains on the nodes, summed over the ranks, ghosts up to date. */
    NodeField<dim, NodeContent>
    magnetic_content(std::vector<Body<dim>> &bodies) const;

    /** The masses of nodes that take a force. @param masses  ghosts up to date. Collective. */
    NodeField<dim, SingleScalar>
    taking_masses(const NodeField<dim, SingleScalar> &masses) const;

    /**
     * Finds the magnetic force on the nodes, and lets particles carry it, with its rate of change.
     *
     * @param way  since the solve before, or 0 [m].
     */
    void
    find_force(const double way, std::vector<Body<dim>> &bodies);

    /** What the material does to the sources at the last solve. @param has_rate  whether it goes on changing. */
    void
    find_reactions(const bool has_rate);

    /** The extremes over all particles that limit the time step. */
    void
    find_limits(const std::vector<Body<dim>> &bodies);

    const MagneticCouplingParameters<dim> parameters;
    ExternalField<dim> &external_field;
    parallel::PhaseTimer &timer;
    const MPI_Comm communicator;

    const BackgroundMesh<dim> *mesh      = nullptr;
    const BlockPartition<dim> *partition = nullptr;
    std::unique_ptr<PotentialProblem<dim>> problem; ///< null without magnetic material
    std::optional<unsigned int> mesh_of_last_solve; ///< its revision

    MagneticState<dim> memory;
    double work = 0.; ///< of the carried force since the last solve, if this step has a row [J]
  };
} // namespace magmpm
