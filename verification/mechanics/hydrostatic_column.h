#pragma once

namespace magmpm::verification
{
  /** What the fluid stands on: the wall, or an elastic slab a quarter of the fluid's depth thick. */
  enum class ColumnFloor
  {
    wall,
    elastic_slab,
    separate_slab ///< the same in a contact group of its own
  };

  /** Errors of the pressure over rho g H. */
  struct HydrostaticErrors
  {
    double inside;     ///< the largest of all layers but the one on the floor
    double floor_cell; ///< of the layer on the floor, with its sign
  };

  /**
   * Pressure in a fluid at rest between slip walls: in each layer one cell thick, the mean of
   * p = K (1 - J) over its particles against the weight of what is above the middle of the layer.
   *
   * @param cells  of the lattice over the depth H of the fluid, a multiple of eight.
   * @param dim    in 3D four cells across.
   */
  HydrostaticErrors
  hydrostatic_errors(const int cells,
                     const int dim           = 2,
                     const ColumnFloor floor = ColumnFloor::wall);
} // namespace magmpm::verification
