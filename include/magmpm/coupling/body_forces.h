#pragma once

#include <magmpm/coupling/attraction.h>
#include <magmpm/coupling/body_force.h>

#include <mpi.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace magmpm
{
  /** What the body forces of a scene are made of. Each is there, if only to do nothing. */
  template <int dim>
  struct BodyForceParameters
  {
    PointAttraction<dim> attraction;
  };

  /**
   * The body forces of a scene, other than gravity and that of magnets. A further one is added here, with
   * its parameters above and in the constructor, and in parameters/parameter_sections.cc: nothing else has
   * to know of it.
   */
  template <int dim>
  class BodyForces
  {
  public:
    explicit BodyForces(const BodyForceParameters<dim> &parameters)
    {
      forces.push_back(std::make_unique<Attraction<dim>>(parameters.attraction));
    }

    /** In the order in which they act, and tell of themselves. */
    const std::vector<std::unique_ptr<BodyForce<dim>>> &
    all() const
    {
      return forces;
    }

    /** Whether one of them takes the place of the magnets. */
    bool
    replace_magnets() const
    {
      return std::any_of(forces.begin(), forces.end(), [](const auto &force) {
        return force->replaces_magnets();
      });
    }

    /** Begins with a scene. @param magnetic_force  on all bodies together [N]. Collective. */
    void
    begin(const Vector<dim> &magnetic_force,
          const std::vector<Body<dim>> &bodies,
          const MPI_Comm communicator)
    {
      for (const auto &force : forces)
        force->begin(magnetic_force, bodies, communicator);
    }

    /** Gives the particles the impulse of a step. */
    void
    act(const Clock &clock, std::vector<Body<dim>> &bodies)
    {
      for (const auto &force : forces)
        force->act(clock, bodies);
    }

  private:
    std::vector<std::unique_ptr<BodyForce<dim>>> forces;
  };
} // namespace magmpm
