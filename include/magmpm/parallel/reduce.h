#pragma once

#include <magmpm/parallel/numbers.h>
#include <magmpm/parallel/ranks.h>

#include <cstdint>
#include <type_traits>
#include <vector>

/** Sums and extremes over the ranks of whatever lists its numbers (numbers.h). */
namespace magmpm::parallel
{
  /**
   * Things of all ranks that are to be summed, maximized or minimized, number by number, in one
   * exchange:
   *
   *   Reduction reduction;
   *   reduction.sum(n_held);
   *   reduction.max(speeds);
   *   reduction.carry_out(communicator);   // now n_held and speeds are those of all ranks
   *
   * All ranks name as many numbers in the same order. Integers (also of 64 bits), Booleans and
   * enumerations are combined as integers, exactly; sums of real numbers are added in the order of
   * MPI_SUM. A NaN is both the largest and the smallest of all numbers, on all ranks, so that it
   * survives.
   */
  class Reduction
  {
  public:
    /** Adds up the numbers in @p x, which stays where it is, and as long as it is, until carry_out(). */
    template <typename T>
    void
    sum(T &x)
    {
      add(Operation::sum, x);
    }

    /** Finds the largest of each number in @p x. */
    template <typename T>
    void
    max(T &x)
    {
      add(Operation::max, x);
    }

    /** Finds the smallest of each number in @p x. */
    template <typename T>
    void
    min(T &x)
    {
      add(Operation::min, x);
    }

    /** Replaces the numbers by those of all ranks, and forgets about them. One MPI_Allreduce. Collective. */
    void
    carry_out(const MPI_Comm communicator);

    enum class Operation : std::int32_t
    {
      sum,
      max,
      min
    };

    /** A number on its way, with what to do with it. */
    struct Parcel
    {
      Operation operation;
      std::int32_t is_integer;
      union
      {
        double real;
        std::int64_t integer;
      };
    };

  private:
    /** A number that takes part. */
    struct Entry
    {
      Operation operation;
      void *number;
      void (*send)(const void *number, Parcel &parcel);
      void (*receive)(const Parcel &parcel, void *number);
    };

    template <typename Number>
    static void
    send(const void *number, Parcel &parcel)
    {
      parcel.is_integer = !std::is_floating_point_v<Number>;
      if constexpr (std::is_floating_point_v<Number>)
        parcel.real = *static_cast<const Number *>(number);
      else
        parcel.integer = static_cast<std::int64_t>(*static_cast<const Number *>(number));
    }

    template <typename Number>
    static void
    receive(const Parcel &parcel, void *number)
    {
      if constexpr (std::is_floating_point_v<Number>)
        *static_cast<Number *>(number) = static_cast<Number>(parcel.real);
      else
        *static_cast<Number *>(number) = static_cast<Number>(parcel.integer);
    }

    template <typename T>
    void
    add(const Operation operation, T &x)
    {
      for_each_number(x, [&](auto &number) {
        using Number = std::remove_reference_t<decltype(number)>;
        entries.push_back({operation, &number, &send<Number>, &receive<Number>});
      });
    }

    std::vector<Entry> entries;
  };

  /** The sum over the ranks of each number in @p x. Collective, as all of these. */
  template <typename T>
  T
  sum(T x, const MPI_Comm communicator)
  {
    Reduction reduction;
    reduction.sum(x);
    reduction.carry_out(communicator);
    return x;
  }

  /** The largest of the ranks of each number in @p x; NaN if one is. */
  template <typename T>
  T
  max(T x, const MPI_Comm communicator)
  {
    Reduction reduction;
    reduction.max(x);
    reduction.carry_out(communicator);
    return x;
  }

  /** The smallest of the ranks of each number in @p x; NaN if one is. */
  template <typename T>
  T
  min(T x, const MPI_Comm communicator)
  {
    Reduction reduction;
    reduction.min(x);
    reduction.carry_out(communicator);
    return x;
  }

  /** Whether it is so on any rank. */
  inline bool
  any(const bool is_so, const MPI_Comm communicator)
  {
    return max(is_so, communicator);
  }
} // namespace magmpm::parallel
