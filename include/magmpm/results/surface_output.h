#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>
#include <magmpm/results/frame_series.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  inline const FrameKind surface_frames = {"surface", "surfaces of the bodies (ParaView)"};

  /**
   * Writes a surface around the particles of each body for ParaView: `surface/surface_<frame>.vtp` of
   * all bodies together, told apart by the cell quantity "body [-]", and `surface.pvd`, which lists
   * the frames so far.
   *
   * The surface is where half of the lattice is full of the body (BodyVolume): triangles, in 2D
   * lines. VTK finds it and smooths it by a windowed sinc filter (Taubin 1996), which keeps volumes.
   * It is closed. What is thinner than about a cell, and single particles, have none. One rank does it,
   * slab by slab as all add up the fractions, so the surface has no seams and no rank holds the lattice.
   */
  template <int dim>
  class SurfaceOutput
  {
  public:
    /**
     * Makes the folder `surface` in @p directory, which must exist. Collective.
     *
     * @param n_nodes_at_once  of the lattice that the writing rank holds, about.
     * @throw RunError if the folder cannot be made.
     */
    SurfaceOutput(const MPI_Comm communicator,
                  const std::string &directory,
                  const Lattice<dim> &lattice,
                  const std::size_t n_nodes_at_once = 1 << 23);

    /**
     * Writes one frame; ranks and bodies may be without particles. Collective.
     *
     * @param time        [s].
     * @throw RunError if the file cannot be written.
     */
    void
    write_frame(const unsigned int frame, const double time, const std::vector<Body<dim>> &bodies);

    /** The frames written so far, surface.pvd. */
    FrameSeries &
    frames()
    {
      return series;
    }

  private:
    const MPI_Comm communicator;
    const Lattice<dim> lattice;
    const std::size_t n_nodes_at_once;
    FrameSeries series;
  };
} // namespace magmpm
