#pragma once

#include <magmpm/coupling/body_force.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * An artificial force in the place of a magnet's, the same on all matter (Fig. 9 of Sun et al.
   * 2021): the acceleration g0 (r0/r)^p towards a point, r the distance from it. Within the core
   * radius r_c it falls linearly to zero, g0 (r0/r_c)^p r/r_c, so that it stays finite for p > 0 and
   * continuous for every p.
   */
  template <int dim>
  struct PointAttraction
  {
    Vector<dim> point;                 ///< [m]
    double reference_distance = 1.;    ///< r0 [m]
    double exponent           = 2.;    ///< p
    double core_radius        = 0.;    ///< r_c [m], positive
    double acceleration       = 0.;    ///< g0 [m/s^2]
    bool matches_magnets      = false; ///< g0 is to be found from the force of the magnets
    std::vector<std::string> bodies;   ///< that it acts on; empty: all

    /** Whether there is any. */
    bool
    is_wanted() const
    {
      return matches_magnets || acceleration > 0.;
    }

    bool
    acts_on(const std::string &body) const;

    /** The acceleration at @p position [m/s^2]. */
    Vector<dim>
    at(const Vector<dim> &position) const;
  };

  /**
   * Adds the impulse of a step to the particles of a body: v <- v + dt a(x).
   *
   * @return the largest acceleration of this rank's particles [m/s^2].
   */
  template <int dim>
  double
  attract(const PointAttraction<dim> &attraction, const double time_step, Body<dim> &body);

  /** Sum of m a(x) over this rank's particles of a body [N]; in 2D per metre of depth. */
  template <int dim>
  Vector<dim>
  force_of(const PointAttraction<dim> &attraction, const Body<dim> &body);

  /** The artificial attraction in the time loop. A scene without it pays nothing. */
  template <int dim>
  class Attraction : public BodyForce<dim>
  {
  public:
    explicit Attraction(const PointAttraction<dim> &parameters);

    bool
    replaces_magnets() const override
    {
      return attraction.matches_magnets;
    }

    /**
     * Gives an attraction that is to match the magnets their total force, in size.
     *
     * @throw RunError  if that or the force of the attraction is zero.
     */
    void
    begin(const Vector<dim> &magnetic_force,
          const std::vector<Body<dim>> &bodies,
          const MPI_Comm communicator) override;

    void
    act(const Clock &clock, std::vector<Body<dim>> &bodies) override;

    std::string
    description() const override;

    void
    limit_step(StepConditions &conditions) const override;

    void
    reduce(parallel::Reduction &reduction) override;

    SectionTitle
    title() const override;

    std::string
    save() const override;

    void
    load(const std::string &bytes) override;

  private:
    PointAttraction<dim> attraction;
    double max_acceleration = 0.; ///< of a particle in the last step [m/s^2]
  };
} // namespace magmpm
