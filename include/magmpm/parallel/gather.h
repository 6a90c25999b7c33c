#pragma once

#include <magmpm/parallel/ranks.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/**
 * Values of one rank for all, and of all for one or all. A value is anything that can be copied byte
 * by byte, a text, or a vector of such; it may be of another length on each rank, and of any length:
 * what is more than MPI can count goes in pieces. All functions are collective.
 */
namespace magmpm::parallel
{
  namespace internal
  {
    void
    broadcast(std::vector<char> &bytes, const unsigned int root, const MPI_Comm communicator);

    /** By rank; empty on all ranks but @p root. */
    std::vector<std::vector<char>>
    gather(const std::vector<char> &bytes, const unsigned int root, const MPI_Comm communicator);

    std::vector<std::vector<char>>
    all_gather(const std::vector<char> &bytes, const MPI_Comm communicator);

    /** Where the bytes of a value are, and how many. */
    template <typename T>
    std::pair<void *, std::size_t>
    memory_of(T &value)
    {
      if constexpr (std::is_trivially_copyable_v<T>)
        return {&value, sizeof(T)};
      else
        {
          static_assert(std::is_trivially_copyable_v<typename T::value_type>,
                        "Only texts and vectors of plain values can be sent.");
          return {value.data(), value.size() * sizeof(typename T::value_type)};
        }
    }

    template <typename T>
    std::vector<char>
    bytes_of(T value)
    {
      const auto memory = memory_of(value);
      const char *begin = static_cast<const char *>(memory.first);
      return std::vector<char>(begin, begin + memory.second);
    }

    template <typename T>
    T
    value_of(const std::vector<char> &bytes)
    {
      T value = {};
      if constexpr (!std::is_trivially_copyable_v<T>)
        value.resize(bytes.size() / sizeof(typename T::value_type));
      if (!bytes.empty())
        std::memcpy(memory_of(value).first, bytes.data(), bytes.size());
      return value;
    }

    template <typename T>
    std::vector<T>
    values_of(const std::vector<std::vector<char>> &bytes)
    {
      std::vector<T> values;
      for (const std::vector<char> &of_rank : bytes)
        values.push_back(value_of<T>(of_rank));
      return values;
    }
  } // namespace internal

  /** The value that rank @p root has, on all ranks. */
  template <typename T>
  T
  broadcast(const T &value, const MPI_Comm communicator, const unsigned int root = 0)
  {
    std::vector<char> bytes;
    if (rank(communicator) == root)
      bytes = internal::bytes_of(value);
    internal::broadcast(bytes, root, communicator);
    return internal::value_of<T>(bytes);
  }

  /** The values of all ranks, by rank, on rank @p root; nothing on the others. */
  template <typename T>
  std::vector<T>
  gather(const T &value, const MPI_Comm communicator, const unsigned int root = 0)
  {
    return internal::values_of<T>(internal::gather(internal::bytes_of(value), root, communicator));
  }

  /** The values of all ranks, by rank, on all of them. */
  template <typename T>
  std::vector<T>
  all_gather(const T &value, const MPI_Comm communicator)
  {
    return internal::values_of<T>(internal::all_gather(internal::bytes_of(value), communicator));
  }
} // namespace magmpm::parallel
