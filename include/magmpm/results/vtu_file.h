#pragma once

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /** One quantity at the points of a grid. */
  struct VtuQuantity
  {
    std::string name;          ///< as ParaView shows it: "velocity [m/s]"
    int n_components = 1;      ///< 1 (scalar) or 3 (vector)
    std::vector<float> values; ///< by point, then by component
  };

  /** This rank's part of a grid of cells of one shape. */
  struct VtuPiece
  {
    std::vector<float> points; ///< three coordinates each [m]
    std::vector<int> cells;    ///< their points, in the order of VTK, one cell after the other
    int points_per_cell = 1;
    int cell_type       = 1; ///< the number that VTK gives the shape; 1 is a vertex

    /** The same names in the same order on all ranks. */
    std::vector<VtuQuantity> quantities;
  };

  /** Which frame of a run a file holds. */
  struct VtuFrame
  {
    unsigned int number = 0;
    double time         = 0.; ///< [s]
  };

  /**
   * Writes the file of a frame that VTK, thus ParaView, reads: all ranks together into one, with a
   * piece of each, and a .pvtu beside it. Numbers stand behind the XML as they are in memory: text,
   * base64 and zlib take longer than all else that output does, and zlib, the best of them, makes
   * such numbers shorter by no more than a third or a half. Collective.
   *
   * @param folder  that exists.
   * @param series  NAME of `NAME_<frame>.0.vtu` and `NAME_<frame>.pvtu`.
   * @return the name of the .pvtu file within the folder.
   * @throw RunError on all ranks if a file cannot be written.
   */
  std::string
  write_vtu(const MPI_Comm communicator,
            const std::string &folder,
            const std::string &series,
            const VtuFrame &frame,
            const VtuPiece &piece);
} // namespace magmpm
