#include <magmpm/parallel/exchange.h>
#include <magmpm/particles/particle_migration.h>

#include <map>

namespace magmpm
{
  template <int dim>
  std::size_t
  migrate_particles(const MPI_Comm communicator,
                    const std::vector<unsigned int> &destination,
                    ParticleSet<dim> &particles)
  {
    const unsigned int rank = parallel::rank(communicator);
    std::map<unsigned int, std::vector<double>> leaving;
    std::vector<std::uint32_t> staying;
    staying.reserve(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p)
      if (destination[p] == rank)
        staying.push_back(static_cast<std::uint32_t>(p));
      else
        particles.append_record(p, leaving[destination[p]]);

    const std::size_t n_sent = particles.size() - staying.size();
    if (n_sent > 0)
      particles.reorder(staying);
    for (const auto &arrived : parallel::exchange(leaving, communicator))
      particles.append_from_records(arrived.second);
    return n_sent;
  }

  template std::size_t
  migrate_particles(const MPI_Comm, const std::vector<unsigned int> &, ParticleSet<2> &);
  template std::size_t
  migrate_particles(const MPI_Comm, const std::vector<unsigned int> &, ParticleSet<3> &);
} // namespace magmpm
