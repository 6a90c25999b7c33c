#pragma once

#include <verification/capillarity/ferrofluid_layer.h>
#include <verification/capillarity/minimize.h>
#include <verification/capillarity/tensor_elements.h>

#include <vector>

namespace magmpm::verification
{
  /**
   * The energy of a layer of linear law in a vertical field, in 2D and periodic, by the height of its surface
   *   z(x) = sum_n a_n cos(n k x),
   * between shielded floor, ceiling and mirrors at x = 0 and pi/k:
   *   E = int 1/2 rho g z^2 + gamma sqrt(1 + z'^2) dx + int B^2/(2 mu) dx dy,
   * with B = curl A, A = B_0 x + a, a = 0 on all faces, that makes E least. The space below and above the surface is
   * mapped onto two rectangles by stretching each column.
   */
  class SpikeEnergy
  {
  public:
    /**
     * @param layer  of finite depth, and with a ceiling at a finite height.
     * @param state  of the flat layer.
     * @param k      wave number [1/m].
     */
    SpikeEnergy(const FerrofluidLayer &layer, const LayerField &state, const double k);

    /**
     * E less that of the flat surface, over gamma pi/k, and its derivatives. @param modes  a_n k, n = 1, 2, ...; where
     * the surface leaves the space between floor and ceiling the energy is infinite.
     */
    ValueAndGradient
    operator()(const std::vector<double> &modes) const;

  private:
    const FerrofluidLayer layer;
    const double induction, k;
    const TensorElements elements;
    double flat;

    /** What the height z and the slope z' at a place cost, derivatives of the energy. */
    struct Column
    {
      double x, height, slope;              ///< z [m], z' [-]
      double by_height = 0., by_slope = 0.; ///< over weights of quadrature
    };

    /** The energy of the field [J/m]. Adds its derivatives. */
    double
    magnetic_energy(std::vector<Column> &columns) const;
  };

  /** The surface at rest. */
  struct SpikeShape
  {
    std::vector<double> modes; ///< a_n [m], n = 1, 2, ...
    double energy;             ///< less that of the flat surface, over gamma pi/k

    /** [m], over the flat surface. @param phase  k x. */
    double
    height(const double phase) const;
  };

  /** The surface of least energy down the hill from a wave of height 0.15 lambda. */
  SpikeShape
  spike_equilibrium(const FerrofluidLayer &layer,
                    const LayerField &state,
                    const double k,
                    const int n_modes = 6);
} // namespace magmpm::verification
