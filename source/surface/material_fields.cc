#include <magmpm/surface/material_fields.h>

namespace magmpm
{
  template <int dim>
  MaterialFields<dim>::MaterialFields(const BlockPartition<dim> &partition,
                                      const Lattice<dim> &lattice,
                                      const std::vector<Body<dim>> &bodies)
    : partition(partition)
    , lattice(lattice)
    , bodies(bodies)
  {
  }

  template <int dim>
  const NodeField<dim, SingleScalar> &
  MaterialFields<dim>::volume_fraction(const MaterialSelection &selection)
  {
    for (const Answer &answer : answers)
      if (answer.selection == selection)
        return answer.field;
    answers.push_back({selection, magmpm::volume_fraction(bodies, selection, partition, lattice)});
    return answers.back().field;
  }

  template <int dim>
  void
  MaterialFields<dim>::forget()
  {
    answers.clear();
  }

  template class MaterialFields<2>;
  template class MaterialFields<3>;
} // namespace magmpm
