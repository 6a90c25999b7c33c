#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/coupling/clock.h>
#include <magmpm/coupling/coupling.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /**
   * A force that acts on each particle by itself, where it is: in a step it changes the velocities before
   * P2G. See BodyForces for those that there are.
   */
  template <int dim>
  class BodyForce : public Coupling
  {
  public:
    /** Whether it takes the place of the magnets: they act no more once it has begun. */
    virtual bool
    replaces_magnets() const
    {
      return false;
    }

    /**
     * Begins with a scene, of which the magnets exert a force [N] on all bodies together; in 2D per metre
     * of depth. Not called if the scene goes on from a checkpoint. Collective.
     */
    virtual void
    begin(const Vector<dim> & /*magnetic_force*/,
          const std::vector<Body<dim>> & /*bodies*/,
          const MPI_Comm /*communicator*/)
    {
    }

    /** Gives the particles the impulse of a step. */
    virtual void
    act(const Clock &clock, std::vector<Body<dim>> &bodies) = 0;
  };
} // namespace magmpm
