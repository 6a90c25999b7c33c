#pragma once

#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/results/frame_series.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  inline const FrameKind rigid_body_frames = {"rigid_bodies",
                                              "surfaces of magnets and rigid bodies (ParaView)"};

  /**
   * The surfaces of magnets and rigid bodies as ParaView shows them: rigid_bodies.pvd and a file a frame,
   * with the number of the thing at each point: magnets first, in the order of their list, then the
   * rigid bodies in theirs. Magnets without a surface (fields, wires, loops) are not there.
   */
  template <int dim>
  class RigidBodyOutput
  {
  public:
    /**
     * Makes the folder. Collective.
     *
     * @param spacing  of the points on round surfaces, about [m].
     * @throw RunError if it cannot be made.
     */
    RigidBodyOutput(const MPI_Comm communicator,
                    const std::string &directory,
                    const ExternalField<dim> &sources,
                    const RigidBodies<dim> &bodies,
                    const double spacing);

    /** Where all is now. Collective. */
    void
    write_frame(const unsigned int frame, const double time);

    /** The frames so far, for a run that is resumed. */
    FrameSeries &
    frames()
    {
      return series;
    }

  private:
    /** Something with a surface, in the frame of its shape. */
    struct Thing
    {
      int number;
      SurfaceMesh<dim> surface;
    };

    Pose<dim>
    pose_of(const Thing &thing) const;

    const MPI_Comm communicator;
    const ExternalField<dim> &sources;
    const RigidBodies<dim> &bodies;
    FrameSeries series;
    std::vector<Thing> things;
    std::vector<std::size_t> body_numbers; ///< in bodies, of those that are not magnets
  };
} // namespace magmpm
