#pragma once

#include <verification/capillarity/cosine_elements.h>
#include <verification/capillarity/ferrofluid_layer.h>
#include <verification/capillarity/layered_matrix.h>
#include <verification/capillarity/minimize.h>

#include <vector>

namespace magmpm::verification
{
  enum class Pattern
  {
    ridges, ///< cos(n k y)
    hexagons ///< sums of the waves of each hexagon of wave vectors, with a crest in the corner x = y = 0
  };

  /**
   * The energy of a layer of any law in a vertical field by the height of its surface, in 3D, in the cell [0, lambda/sqrt(3)]
   * x [0, lambda] between mirrors, floor and ceiling shielded:
   *   E = int 1/2 rho g z^2 + gamma sqrt(1 + |grad z|^2) dx dy - mu_0 int |h|^2/2 + psi(H_0 + h) dV,
   * h = -grad phi such that the second integral is least, grad psi = M. Newton's method for the potential, conjugate
   * gradients in it. Columns are stretched from a layer of even depth.
   */
  class PatternEnergy
  {
  public:
    /**
     * @param k          wave number, 2 pi/lambda [1/m].
     * @param n_cosines  of the potential along the longer edge of the cell.
     */
    PatternEnergy(const FerrofluidLayer &layer,
                  const LayerField &state,
                  const double k,
                  const Pattern pattern,
                  const int n_modes,
                  const int n_cosines = 14);

    /** E less that of the flat surface, over gamma and the area, and its derivatives. @param modes  a_n k. */
    ValueAndGradient
    operator()(const std::vector<double> &modes) const;

    /** z [m] at a place of the cell [m]. */
    double
    height(const std::vector<double> &modes, const double x, const double y) const;

  private:
    /** A product of cosines in a mode. */
    struct Wave
    {
      double kx, ky, factor;
    };

    /** What height z and slopes at a place cost, derivatives of the energy over gamma and weights of quadrature. */
    struct Column
    {
      double x, y;
      std::array<double, 3> surface; ///< z [m] and its slopes
      std::array<double, 3> cost;    ///< derivatives by these
    };

    const FerrofluidLayer layer;
    const LayerField state;
    const double k;
    std::vector<std::vector<Wave>> modes_waves;
    const CosineElements elements;
    const LayeredMatrix flat_matrix;
    double flat = 0.;

    std::vector<Column>
    columns_of(const std::vector<double> &modes) const;

    double
    magnetic_energy(std::vector<Column> &columns) const;
  };

  struct PatternShape
  {
    std::vector<double> modes; ///< a_n k
    double crest, trough;      ///< [m] over the flat surface
    double energy;             ///< less that of the flat surface, over gamma and the area
  };

  /** The surface of least energy down the hill from @p start, a_n k. */
  PatternShape
  pattern_equilibrium(const PatternEnergy &energy,
                      const std::vector<double> &start,
                      const double k);
} // namespace magmpm::verification
