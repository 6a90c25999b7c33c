#pragma once

#include <magmpm/base/tensor.h>

#include <string>
#include <variant>
#include <vector>

namespace magmpm
{
  /**
   * A quantity that a run can write for every particle or node: what parameters and files call it, and
   * how it is read there. A table of these is all that is known of the quantities of a kind.
   *
   * @tparam Place  what is known of one particle or node.
   */
  template <int dim, typename Place>
  struct WrittenQuantity
  {
    std::string name;
    std::string unit; ///< "m/s"; "-" if it has none
    std::variant<double (*)(const Place &), Vector<dim> (*)(const Place &)> value;

    /** "velocity [m/s]", as files have it. */
    std::string
    heading() const
    {
      return name + " [" + unit + "]";
    }
  };

  template <int dim, typename Place>
  inline std::vector<std::string>
  names_of(const std::vector<WrittenQuantity<dim, Place>> &quantities)
  {
    std::vector<std::string> names;
    for (const auto &quantity : quantities)
      names.push_back(quantity.name);
    return names;
  }
} // namespace magmpm
