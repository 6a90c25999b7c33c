#include <magmpm/base/constants.h>
#include <magmpm/magnetics/field_quantities.h>

namespace magmpm
{
  template <int dim>
  const std::vector<FieldQuantity<dim>> &
  field_quantities()
  {
    using At                                          = FieldValues<dim>;
    static const std::vector<FieldQuantity<dim>> list = {
      {"potential", "A", [](const At &at) { return at.potential; }},
      {"H_int", "A/m", [](const At &at) { return at.self_field; }},
      {"H", "A/m", [](const At &at) { return at.field; }},
      {"M", "A/m", [](const At &at) { return at.magnetization; }},
      {"B",
       "T",
       [](const At &at) {
         return constants::vacuum_permeability *
                (at.field + at.magnetization + at.magnetization_of_magnets);
       }},
      {"number_density", "1/m^3", [](const At &at) { return at.number_density; }}};
    return list;
  }

  template const std::vector<FieldQuantity<2>> &
  field_quantities<2>();
  template const std::vector<FieldQuantity<3>> &
  field_quantities<3>();
} // namespace magmpm
