#include <magmpm/parallel/exchange.h>
#include <magmpm/parallel/gather.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace magmpm::parallel::internal
{
  void
  broadcast(std::vector<char> &bytes, const unsigned int root, const MPI_Comm communicator)
  {
    std::uint64_t size = bytes.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, static_cast<int>(root), communicator);
    bytes.resize(size);
    for (std::size_t begin = 0; begin < size; begin += largest_message)
      MPI_Bcast(bytes.data() + begin,
                static_cast<int>(std::min<std::size_t>(largest_message, size - begin)),
                MPI_BYTE,
                static_cast<int>(root),
                communicator);
  }

  std::vector<std::vector<char>>
  gather(const std::vector<char> &bytes, const unsigned int root, const MPI_Comm communicator)
  {
    std::vector<std::vector<char>> of_ranks(rank(communicator) == root ? n_ranks(communicator) : 0);
    const auto make_room = [&of_ranks](const unsigned int rank,
                                       const std::size_t n_bytes) -> void * {
      const std::size_t begin = of_ranks[rank].size();
      of_ranks[rank].resize(begin + n_bytes);
      return of_ranks[rank].data() + begin;
    };
    exchange({{root, bytes.data(), bytes.size()}}, make_room, largest_message, communicator);
    return of_ranks;
  }

  std::vector<std::vector<char>>
  all_gather(const std::vector<char> &bytes, const MPI_Comm communicator)
  {
    const unsigned int n = n_ranks(communicator);
    std::uint64_t size   = bytes.size();
    std::vector<std::uint64_t> sizes(n);
    MPI_Allgather(&size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, communicator);

    std::vector<std::vector<char>> of_ranks(n);
    const std::uint64_t total = std::accumulate(sizes.begin(), sizes.end(), std::uint64_t(0));
    if (total > largest_message)
      {
        // More than one message can hold: rank after rank, in pieces.
        of_ranks[rank(communicator)] = bytes;
        for (unsigned int root = 0; root < n; ++root)
          broadcast(of_ranks[root], root, communicator);
        return of_ranks;
      }

    std::vector<int> counts(sizes.begin(), sizes.end()), begins(n, 0);
    std::partial_sum(counts.begin(), counts.end() - 1, begins.begin() + 1);
    std::vector<char> all(total);
    MPI_Allgatherv(bytes.data(),
                   static_cast<int>(size),
                   MPI_BYTE,
                   all.data(),
                   counts.data(),
                   begins.data(),
                   MPI_BYTE,
                   communicator);
    for (unsigned int r = 0; r < n; ++r)
      of_ranks[r].assign(all.begin() + begins[r], all.begin() + begins[r] + counts[r]);
    return of_ranks;
  }
} // namespace magmpm::parallel::internal
