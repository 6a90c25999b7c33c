#include <magmpm/base/constants.h>
#include <magmpm/magnetics/source_reaction.h>
#include <magmpm/magnets/continued_field.h>
#include <magmpm/parallel/reduce.h>

#include <cmath>

namespace magmpm
{
  template <int dim>
  std::vector<ForceAndTorque<dim>>
  reactions_on_sources(const std::vector<MaterialSample<dim>> &samples,
                       const ExternalField<dim> &sources,
                       const MPI_Comm communicator)
  {
    const ContinuedField<dim> continued(sources);
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
            const LocalField<dim> local =
              continued.of(*source, sample.position, std::pow(sample.weight, 1. / dim));
            const Vector<dim> force = local.gradient * moment;
            sum.force -= force;
            sum.torque -= cross(sample.position - source->pose().position, force) +
                          cross(moment, local.field);
          }
        reactions.push_back(sum);
      }

    return parallel::sum(reactions, communicator);
  }

#define MAGMPM_INSTANTIATE(dim)                                   \
  template std::vector<ForceAndTorque<dim>> reactions_on_sources( \
    const std::vector<MaterialSample<dim>> &, const ExternalField<dim> &, const MPI_Comm);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
