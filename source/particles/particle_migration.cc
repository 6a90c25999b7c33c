#include <magmpm/parallel/exchange.h>
#include <magmpm/particles/particle_migration.h>

#include <map>

namespace magmpm
{
  namespace
  {
    /** What goes to a rank: of set after set its number, how many particles, and their records. */
    class Message
    {
    public:
      template <int dim>
      void
      append(const std::size_t set, const ParticleSet<dim> &particles, const std::size_t p)
      {
        if (numbers.empty() || set != last_set)
          {
            last_set       = set;
            place_of_count = numbers.size() + 1;
            numbers.insert(numbers.end(), {static_cast<double>(set), 0.});
          }
        particles.append_record(p, numbers);
        numbers[place_of_count] += 1.;
      }

      std::vector<double> numbers;

    private:
      std::size_t last_set       = 0;
      std::size_t place_of_count = 0;
    };

    /** Appends the particles of a message to their sets. */
    template <int dim>
    void
    take_in(const std::vector<double> &numbers, const std::vector<ParticleSet<dim> *> &sets)
    {
      for (std::size_t next = 0; next < numbers.size();)
        {
          ParticleSet<dim> &particles = *sets[static_cast<std::size_t>(numbers[next])];
          const std::size_t n         = static_cast<std::size_t>(numbers[next + 1]);
          particles.append_from_records(&numbers[next + 2], n);
          next += 2 + n * particles.record_size();
        }
    }
  } // namespace

  template <int dim>
  std::size_t
  migrate_particles(const MPI_Comm communicator,
                    const std::vector<std::vector<unsigned int>> &destinations,
                    const std::vector<ParticleSet<dim> *> &sets)
  {
    const unsigned int rank = parallel::rank(communicator);
    std::size_t n_sent      = 0;
    std::map<unsigned int, Message> messages;
    for (std::size_t s = 0; s < sets.size(); ++s)
      {
        ParticleSet<dim> &particles = *sets[s];
        std::vector<std::uint32_t> staying;
        staying.reserve(particles.size());
        for (std::size_t p = 0; p < particles.size(); ++p)
          if (destinations[s][p] == rank)
            staying.push_back(static_cast<std::uint32_t>(p));
          else
            messages[destinations[s][p]].append(s, particles, p);
        n_sent += particles.size() - staying.size();
        if (staying.size() < particles.size())
          particles.reorder(staying);
      }

    std::map<unsigned int, std::vector<double>> leaving;
    for (auto &[destination, message] : messages)
      leaving[destination] = std::move(message.numbers);
    for (const auto &arrived : parallel::exchange(leaving, communicator))
      take_in(arrived.second, sets);
    return n_sent;
  }

#define INSTANTIATE(dim)                                                                 \
  template std::size_t migrate_particles(const MPI_Comm,                                 \
                                         const std::vector<std::vector<unsigned int>> &, \
                                         const std::vector<ParticleSet<dim> *> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
