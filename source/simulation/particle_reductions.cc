#include <magmpm/parallel/reduce.h>
#include <magmpm/simulation/particle_reductions.h>

namespace magmpm
{
  template <int dim>
  std::vector<ParticleSums<dim>>
  sums_over_ranks(const std::vector<Body<dim>> &bodies,
                  const Parameters<dim> &parameters,
                  const MPI_Comm communicator)
  {
    const MagnetizationModel model = parameters.magnetics.model();
    std::vector<ParticleSums<dim>> sums;
    for (const Body<dim> &body : bodies)
      sums.push_back(particle_sums(body, parameters.lattice, parameters.gravity, model));
    parallel::Reduction reduction;
    for (ParticleSums<dim> &of_body : sums)
      of_body.for_each_member(reduction);
    reduction.carry_out(communicator);
    return sums;
  }

  double
  maximize_over_ranks(std::vector<ParticleExtremes> &extremes,
                      const double number,
                      const MPI_Comm communicator)
  {
    double largest = number;
    parallel::Reduction reduction;
    reduction.max(extremes);
    reduction.max(largest);
    reduction.carry_out(communicator);
    return largest;
  }

#define INSTANTIATE(dim)                                                                     \
  template std::vector<ParticleSums<dim>> sums_over_ranks(const std::vector<Body<dim>> &,    \
                                                          const Parameters<dim> &parameters, \
                                                          const MPI_Comm communicator);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
