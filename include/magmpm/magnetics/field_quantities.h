#pragma once

#include <magmpm/base/written_quantity.h>

namespace magmpm
{
  /** The magnetic fields at one point. */
  template <int dim>
  struct FieldValues
  {
    double potential;                     ///< phi [A]
    double number_density;                ///< of grains [1/m^3]
    Vector<dim> self_field;               ///< -grad phi [A/m], the field that the material makes
    Vector<dim> field;                    ///< H, that of the magnets included [A/m]
    Vector<dim> magnetization;            ///< of material [A/m]
    Vector<dim> magnetization_of_magnets; ///< inside solid ones [A/m]
  };

  template <int dim>
  using FieldQuantity = WrittenQuantity<dim, FieldValues<dim>>;

  /** What can be written of the fields. */
  template <int dim>
  const std::vector<FieldQuantity<dim>> &
  field_quantities();
} // namespace magmpm
