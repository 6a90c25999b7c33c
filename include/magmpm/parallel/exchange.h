#pragma once

#include <magmpm/parallel/ranks.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <type_traits>
#include <vector>

namespace magmpm::parallel
{
  /** Bytes of the longest message: MPI counts in int, up to 2^31. */
  inline constexpr std::size_t largest_message = std::size_t(1) << 30;

  namespace internal
  {
    /** What goes to a rank. */
    struct Outgoing
    {
      unsigned int rank;
      const void *data;
      std::size_t n_bytes;
    };

    /**
     * Sends in pieces of up to @p n_bytes_of_piece and gives what comes, piece by piece in order, to
     * the memory that make_room(rank, n_bytes) says.
     */
    void
    exchange(const std::vector<Outgoing> &outgoing,
             const std::function<void *(unsigned int, std::size_t)> &make_room,
             const std::size_t n_bytes_of_piece,
             const MPI_Comm communicator);
  } // namespace internal

  /**
   * Some ranks send to some: @p outgoing by the rank that shall have it, also this rank itself, and also
   * without entries. Collective.
   *
   * @param n_bytes_of_piece  longer vectors go in several messages of up to this many bytes.
   * @return what came, by the rank that sent it.
   */
  template <typename T>
  std::map<unsigned int, std::vector<T>>
  exchange(const std::map<unsigned int, std::vector<T>> &outgoing,
           const MPI_Comm communicator,
           const std::size_t n_bytes_of_piece = largest_message)
  {
    static_assert(std::is_trivially_copyable_v<T>, "Only plain values can be sent.");
    std::vector<internal::Outgoing> memory;
    for (const auto &[rank, values] : outgoing)
      memory.push_back({rank, values.data(), values.size() * sizeof(T)});

    std::map<unsigned int, std::vector<T>> incoming;
    const auto make_room = [&incoming](const unsigned int rank,
                                       const std::size_t n_bytes) -> void * {
      std::vector<T> &values  = incoming[rank];
      const std::size_t begin = values.size();
      values.resize(begin + n_bytes / sizeof(T));
      return values.data() + begin;
    };
    // A piece holds whole values.
    const std::size_t n_of_piece = std::max<std::size_t>(n_bytes_of_piece / sizeof(T), 1);
    internal::exchange(memory, make_room, n_of_piece * sizeof(T), communicator);
    return incoming;
  }
} // namespace magmpm::parallel
