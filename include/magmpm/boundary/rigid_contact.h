#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/lattice/lattice.h>

#include <vector>

namespace magmpm
{
  /** A point where a free body touches a wall or another body, or may do so within a step. */
  template <int dim>
  struct RigidContact
  {
    int body;           ///< number of a free body
    int other;          ///< number of another free body; or none: nothing moves the other
    Vector<dim> point;  ///< [m]
    Vector<dim> normal; ///< out of the other surface, of length 1
    double gap;         ///< negative if they overlap [m]
    double friction;    ///< Coulomb's coefficient; infinite if one of them sticks
    Vector<dim>
      surface_velocity; ///< of a wall or kinematic body at the point; zero otherwise [m/s]

    static constexpr int none = -1;
  };

  /** Finds the contacts of free bodies with walls, kinematic bodies and each other. */
  template <int dim>
  class RigidContactSearch
  {
  public:
    /**
     * Bodies touch where a point of the surface of one, of those at most @p spacing [m] apart, is
     * inside the other.
     */
    RigidContactSearch(const Lattice<dim> &lattice,
                       const WallParameters<dim> &walls,
                       const std::vector<RigidBody<dim>> &bodies,
                       const double spacing);

    /** Contacts with gaps that can close within @p time_step [s]. @param bodies  as they were given. */
    std::vector<RigidContact<dim>>
    find(const std::vector<RigidBody<dim>> &bodies, const double time_step) const;

  private:
    /** With the walls that surface points of the body come near to. */
    void
    find_walls(const std::vector<RigidBody<dim>> &bodies,
               const int body,
               const double reach,
               std::vector<RigidContact<dim>> &contacts) const;

    /** Of surface points of @p sampled with the surface of @p surface; one of them is free. */
    void
    find_pair(const std::vector<RigidBody<dim>> &bodies,
              const int sampled,
              const int surface,
              const double reach,
              std::vector<RigidContact<dim>> &contacts) const;

    const Lattice<dim> lattice;
    const WallParameters<dim> walls;
    const double spacing;                         ///< of the points [m]
    std::vector<std::vector<Vector<dim>>> points; ///< by body, in its frame [m]
  };

  /** The equation A V = b for the motion V of a free body at the end of a step. */
  template <int dim>
  struct RigidEquation
  {
    RigidMatrix<dim> inertia;  ///< A: symmetric, positive definite
    RigidVector<dim> momentum; ///< b

    /** b and the lower triangle of A, which say it all. */
    template <typename F>
    void
    for_each_number(F &&f)
    {
      for (int i = 0; i < n_rigid_components<dim>; ++i)
        {
          f(momentum.values[i]);
          for (int j = 0; j <= i; ++j)
            f(inertia.values[i][j]);
        }
    }
  };

  /**
   * Motions of the free bodies at the end of a step: A V = b + impulses of the contacts, which do
   * not pull, leave no contact with a gap that closes further than to zero in @p time_step, and keep
   * to Coulomb's law. Sequential impulses (projected Gauss-Seidel) until they change no more, or 200
   * times. Impulses between two free bodies are equal and opposite.
   *
   * @param equations  by body; those of kinematic ones are not looked at.
   * @return by body.
   */
  template <int dim>
  std::vector<RigidVector<dim>>
  solve_contacts(const std::vector<RigidBody<dim>> &bodies,
                 const std::vector<RigidContact<dim>> &contacts,
                 const std::vector<RigidEquation<dim>> &equations,
                 const double time_step);

  /** Moves free bodies apart that overlap something by more than @p tolerance [m]; no motion changes. */
  template <int dim>
  void
  separate_overlaps(const std::vector<RigidContact<dim>> &contacts,
                    const double tolerance,
                    std::vector<RigidBody<dim>> &bodies);
} // namespace magmpm
