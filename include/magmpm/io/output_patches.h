#pragma once

#include <deal.II/base/data_out_base.h>

#include <string>
#include <tuple>
#include <vector>

namespace magmpm
{
  /**
   * Pieces of geometry with named quantities, in the form deal.II writes: what the output of particles
   * and that of fields have in common. Quantities are called "name [unit]".
   */
  template <int patch_dim, int dim>
  class OutputPatches : public dealii::DataOutInterface<patch_dim, dim>
  {
  protected:
    using Patch = dealii::DataOutBase::Patch<patch_dim, dim>;

    /** Adds a quantity of one component, or a vector of dim. */
    void
    add_quantity(const std::string &name, const std::string &unit, const unsigned int n_components)
    {
      const std::string  written_name = name + " [" + unit + "]";
      const unsigned int first        = dataset_names.size();
      if (n_components > 1)
        nonscalar_ranges.emplace_back(
          first,
          first + n_components - 1,
          written_name,
          dealii::DataComponentInterpretation::component_is_part_of_vector);
      dataset_names.insert(dataset_names.end(), n_components, written_name);
    }

    /** Of all quantities together. */
    unsigned int
    n_components() const
    {
      return dataset_names.size();
    }

    std::vector<Patch> patches;

  private:
    using NonscalarRange =
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 dealii::DataComponentInterpretation::DataComponentInterpretation>;

    const std::vector<Patch> &
    get_patches() const override
    {
      return patches;
    }

    std::vector<std::string>
    get_dataset_names() const override
    {
      return dataset_names;
    }

    std::vector<NonscalarRange>
    get_nonscalar_data_ranges() const override
    {
      return nonscalar_ranges;
    }

    std::vector<std::string> dataset_names; ///< one for each component
    std::vector<NonscalarRange> nonscalar_ranges;
  };
} // namespace magmpm
