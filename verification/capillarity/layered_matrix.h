#pragma once

#include <verification/capillarity/band_matrix.h>
#include <verification/capillarity/cosine_elements.h>

#include <vector>

namespace magmpm::verification
{
  /**
   * The matrix of int across (u_x^2 + u_y^2) + along u_s^2 with coefficients of s alone: a band for each pair of cosines.
   * Preconditions what has been deformed.
   */
  class LayeredMatrix
  {
  public:
    /** @param across, along  at the points of a column. */
    LayeredMatrix(const CosineElements &elements,
                  const std::vector<double> &across,
                  const std::vector<double> &along);

    /** Constants, which the integral does not see, weigh a little. */
    std::vector<double>
    solve(const std::vector<double> &right) const;

  private:
    const std::size_t n_nodes;
    std::vector<BandMatrix> bands;
  };
} // namespace magmpm::verification
