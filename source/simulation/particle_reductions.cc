#include <deal.II/base/mpi.h>
#include <deal.II/base/mpi.templates.h>

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
    using Sums = std::vector<ParticleSums<dim>>;
    return dealii::Utilities::MPI::all_reduce<Sums>(
      sums, communicator, [](const Sums &one, const Sums &other) {
        Sums both = one;
        for (std::size_t b = 0; b < both.size(); ++b)
          both[b] += other[b];
        return both;
      });
  }

  double
  maximize_over_ranks(std::vector<ParticleExtremes> &extremes,
                      const double number,
                      const MPI_Comm communicator)
  {
    constexpr int n_extremes = sizeof(ParticleExtremes) / sizeof(double);
    std::vector<double> largest;
    for (const ParticleExtremes &e : extremes)
      largest.insert(largest.end(),
                     {e.speed,
                      e.signal_speed,
                      e.affine_velocity,
                      e.max_volume_ratio,
                      e.max_inverse_volume_ratio});
    largest.push_back(number);
    dealii::Utilities::MPI::max(largest, communicator, largest);
    for (std::size_t b = 0; b < extremes.size(); ++b)
      {
        const double *e = &largest[n_extremes * b];
        extremes[b]     = {e[0], e[1], e[2], e[3], e[4]};
      }
    return largest.back();
  }

#define INSTANTIATE(dim)                                                                     \
  template std::vector<ParticleSums<dim>> sums_over_ranks(const std::vector<Body<dim>> &,    \
                                                          const Parameters<dim> &parameters, \
                                                          const MPI_Comm communicator);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
