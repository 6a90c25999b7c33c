#pragma once

#include <magmpm/base/exceptions.h>
#include <magmpm/base/written_quantity.h>
#include <magmpm/parameters/parameter_names.h>
#include <magmpm/results/vtu_file.h>

#include <algorithm>
#include <type_traits>

namespace magmpm
{
  /**
   * Those of @p quantities that are to be written, in their order.
   *
   * @param kind        of quantity, for the message: "field".
   * @throw InputError  if one of @p names is unknown.
   */
  template <int dim, typename Place>
  inline std::vector<WrittenQuantity<dim, Place>>
  chosen_quantities(const std::vector<WrittenQuantity<dim, Place>> &quantities,
                    const std::vector<std::string> &names,
                    const std::string &kind)
  {
    const std::vector<std::string> known = names_of(quantities);
    for (const std::string &name : names)
      if (std::count(known.begin(), known.end(), name) == 0)
        throw InputError("The " + kind + " quantity '" + name +
                         "' is unknown. Allowed are: " + comma_separated(known) + ".");
    std::vector<WrittenQuantity<dim, Place>> chosen;
    for (const auto &quantity : quantities)
      if (std::count(names.begin(), names.end(), quantity.name) > 0)
        chosen.push_back(quantity);
    return chosen;
  }

  /**
   * A quantity at @p n places, in single precision. A vector has three components in 2D too (the third
   * is zero), so that ParaView takes it for one.
   *
   * @param for_each_place  calls a function with each of the places.
   */
  template <int dim, typename Place, typename ForEachPlace>
  inline VtuQuantity
  written_values(const WrittenQuantity<dim, Place> &quantity,
                 const std::size_t n,
                 const ForEachPlace &for_each_place)
  {
    const auto values_of = [&](const auto value) {
      constexpr bool is_vector =
        std::is_same_v<std::invoke_result_t<decltype(value), const Place &>, Vector<dim>>;
      VtuQuantity written = {quantity.heading(), is_vector ? 3 : 1, {}};
      written.values.assign(written.n_components * n, 0.f);
      float *to = written.values.data();
      for_each_place([&](const Place &place) {
        const auto at_place = value(place);
        if constexpr (is_vector)
          for (int d = 0; d < dim; ++d)
            to[d] = static_cast<float>(at_place[d]);
        else
          *to = static_cast<float>(at_place);
        to += written.n_components;
      });
      return written;
    };
    return std::visit(values_of, quantity.value);
  }
} // namespace magmpm
