#include <deal.II/base/mpi.h>

#include <magmpm/base/constants.h>
#include <magmpm/magnetics/source_reaction.h>

namespace magmpm
{
  namespace
  {
    /** Force and torque as numbers that add up over ranks. */
    template <int dim, typename Reactions, typename Action>
    void
    for_numbers(Reactions &reactions, const Action &action)
    {
      for (auto &reaction : reactions)
        {
          for (int d = 0; d < dim; ++d)
            action(reaction.force[d]);
          for (int k = 0; k < n_axial_components<dim>; ++k)
            action(reaction.torque[k]);
        }
    }
  } // namespace

  template <int dim>
  std::vector<ForceAndTorque<dim>>
  reactions_on_sources(const std::vector<MaterialSample<dim>> &samples,
                       const ExternalField<dim> &sources,
                       const MPI_Comm communicator)
  {
    std::vector<ForceAndTorque<dim>> reactions;
    for (const auto &source : sources.sources())
      {
        ForceAndTorque<dim> sum = {};
        for (const MaterialSample<dim> &sample : samples)
          {
            if (!source->has_place())
              break;
            const Vector<dim> moment = (constants::vacuum_permeability * sample.weight) *
                                       sample.magnetization;
            const Vector<dim> force = source->field_gradient(sample.position) * moment;
            sum.force -= force;
            sum.torque -= cross(sample.position - source->pose().position, force) +
                          cross(moment, source->field(sample.position));
          }
        reactions.push_back(sum);
      }

    std::vector<double> numbers;
    for_numbers<dim>(reactions, [&](const double number) { numbers.push_back(number); });
    dealii::Utilities::MPI::sum(
      dealii::ArrayView<const double>(numbers), communicator, dealii::ArrayView<double>(numbers));
    std::size_t next = 0;
    for_numbers<dim>(reactions, [&](double &number) { number = numbers[next++]; });
    return reactions;
  }

#define MAGMPM_INSTANTIATE(dim)                                   \
  template std::vector<ForceAndTorque<dim>> reactions_on_sources( \
    const std::vector<MaterialSample<dim>> &, const ExternalField<dim> &, const MPI_Comm);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
