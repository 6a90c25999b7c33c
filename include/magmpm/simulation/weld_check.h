#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * Notices when solids of one contact group meet that were apart: on the lattice they have one velocity, and
   * so they weld, which a user may not have meant. Solids that are given face to face are one piece on purpose.
   *
   * Near are those of which particles at the surface come within dx, each taken as a ball with half the edge of the
   * cube of its volume as its radius.
   */
  template <int dim>
  class WeldCheck
  {
  public:
    WeldCheck(const Lattice<dim> &lattice, const MPI_Comm communicator);

    /**
     * Looks at where bodies are now. Nothing happens, and nothing is sent, if no two solids of a group may
     * still weld. Collective.
     *
     * @param time  [s]
     * @return a line for each pair that has come near since the last call; none the first time.
     */
    std::vector<std::string>
    find_welds(const std::vector<Body<dim>> &bodies, const double time);

  private:
    /** Two bodies, by their numbers. */
    struct Pair
    {
      std::size_t first, second;
    };

    /** A particle at the surface of a body. */
    struct SurfacePlace
    {
      std::size_t body;
      Vector<dim> position;
      double radius; ///< [m]
    };

    /** All pairs of solids of one group. */
    void
    watch(const std::vector<Body<dim>> &bodies);

    /** Boxes of all ranks' particles, by body. */
    std::vector<BoundingBox<dim>>
    find_boxes(const std::vector<Body<dim>> &bodies) const;

    /** The box in which one body may be near to the other: of @p a, enlarged, with @p b; empty if it is none. */
    BoundingBox<dim>
    common_box(const BoundingBox<dim> &a, const BoundingBox<dim> &b) const;

    /** Those of all ranks in the common box of the pair. */
    std::vector<SurfacePlace>
    gather_places(const std::vector<Body<dim>> &bodies,
                  const Pair &pair,
                  const BoundingBox<dim> &box) const;

    bool
    are_near(const std::vector<SurfacePlace> &places, const Pair &pair) const;

    const Lattice<dim> lattice;
    const MPI_Comm communicator;
    bool is_first = true;
    std::vector<Pair> watched;
  };
} // namespace magmpm
