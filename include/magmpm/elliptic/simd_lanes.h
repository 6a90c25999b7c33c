#pragma once

#include <deal.II/base/vectorization.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>

/**
 * Bits of the SIMD registers that the potential solver fills with cells: those of the processor
 * that is compiled for, if MAGMPM_WIDE_SIMD is on and deal.II, which was compiled for another one,
 * brings no VectorizedArray of that width; zero where deal.II's own is taken. One program must be
 * compiled with one value of it (the build folder's).
 */
#if defined(MAGMPM_WIDE_SIMD) && defined(__AVX512F__) && DEAL_II_VECTORIZATION_WIDTH_IN_BITS < 512
#  define MAGMPM_SIMD_BITS 512
#elif defined(MAGMPM_WIDE_SIMD) && defined(__AVX2__) && DEAL_II_VECTORIZATION_WIDTH_IN_BITS < 256
#  define MAGMPM_SIMD_BITS 256
#else
#  define MAGMPM_SIMD_BITS 0
#endif

#if MAGMPM_SIMD_BITS > 0

namespace magmpm
{
  /**
   * What deal.II's VectorizedArray<Number, width> does, for a register of @p width numbers, in
   * terms of the compiler's vector types. The names and meanings are those of deal.II's class,
   * which calls them; see there.
   */
  template <typename Number, std::size_t width>
  class SimdArray
    : public dealii::VectorizedArrayBase<dealii::VectorizedArray<Number, width>, width>
  {
  public:
    using value_type = Number;
    using Array      = dealii::VectorizedArray<Number, width>;
    using Register __attribute__((vector_size(width * sizeof(Number)))) = Number;

    Register data;

    SimdArray() = default;

    SimdArray(const Number scalar)
      : data(Register{} + scalar)
    {
    }

    template <typename U>
    SimdArray(const std::initializer_list<U> &list)
      : dealii::VectorizedArrayBase<Array, width>(list)
    {
    }

    DEAL_II_ALWAYS_INLINE Number &
    operator[](const unsigned int lane)
    {
      AssertIndexRange(lane, width);
      return reinterpret_cast<Number *>(&data)[lane]; // a vector may alias its elements
    }

    DEAL_II_ALWAYS_INLINE const Number &
    operator[](const unsigned int lane) const
    {
      AssertIndexRange(lane, width);
      return reinterpret_cast<const Number *>(&data)[lane];
    }

    DEAL_II_ALWAYS_INLINE Array &
    operator+=(const Array &other)
    {
      data += other.data;
      return self();
    }

    DEAL_II_ALWAYS_INLINE Array &
    operator-=(const Array &other)
    {
      data -= other.data;
      return self();
    }

    DEAL_II_ALWAYS_INLINE Array &
    operator*=(const Array &other)
    {
      data *= other.data;
      return self();
    }

    DEAL_II_ALWAYS_INLINE Array &
    operator/=(const Array &other)
    {
      data /= other.data;
      return self();
    }

    DEAL_II_ALWAYS_INLINE void
    load(const Number *address)
    {
      std::memcpy(&data, address, sizeof(data));
    }

    DEAL_II_ALWAYS_INLINE void
    store(Number *address) const
    {
      std::memcpy(address, &data, sizeof(data));
    }

    DEAL_II_ALWAYS_INLINE void
    streaming_store(Number *address) const
    {
      store(address);
    }

    DEAL_II_ALWAYS_INLINE void
    gather(const Number *base, const unsigned int *offsets)
    {
      for (std::size_t lane = 0; lane < width; ++lane)
        data[lane] = base[offsets[lane]];
    }

    DEAL_II_ALWAYS_INLINE void
    scatter(const unsigned int *offsets, Number *base) const
    {
      for (std::size_t lane = 0; lane < width; ++lane)
        base[offsets[lane]] = data[lane];
    }

    /** Called by std::sqrt() of such an array; likewise the next ones. */
    Array
    get_sqrt() const
    {
      Array result;
      for (std::size_t lane = 0; lane < width; ++lane)
        result.data[lane] = std::sqrt(data[lane]);
      return result;
    }

    Array
    get_abs() const
    {
      Array result;
      for (std::size_t lane = 0; lane < width; ++lane)
        result.data[lane] = std::abs(data[lane]);
      return result;
    }

    Array
    get_max(const Array &other) const
    {
      Array result;
      result.data = data < other.data ? other.data : data;
      return result;
    }

    Array
    get_min(const Array &other) const
    {
      Array result;
      result.data = other.data < data ? other.data : data;
      return result;
    }

  private:
    DEAL_II_ALWAYS_INLINE Array &
    self()
    {
      return static_cast<Array &>(*this);
    }
  };
} // namespace magmpm

// Types of their own, with names that the compiled deal.II does not hold: its one-lane ones, which
// are the default argument everywhere, stay what they are.
DEAL_II_NAMESPACE_OPEN
#  define MAGMPM_SPECIALIZE(Number, width)                                         \
    template <>                                                                    \
    class VectorizedArray<Number, width> : public magmpm::SimdArray<Number, width> \
    {                                                                              \
    public:                                                                        \
      using magmpm::SimdArray<Number, width>::SimdArray;                           \
      VectorizedArray() = default;                                                 \
                                                                                   \
      DEAL_II_ALWAYS_INLINE VectorizedArray &                                      \
      operator=(const Number scalar)                                               \
      {                                                                            \
        data = Register{} + scalar;                                                \
        return *this;                                                              \
      }                                                                            \
    };
#  if MAGMPM_SIMD_BITS == 512
MAGMPM_SPECIALIZE(double, 8)
MAGMPM_SPECIALIZE(float, 16)
#  else
MAGMPM_SPECIALIZE(double, 4)
MAGMPM_SPECIALIZE(float, 8)
#  endif
#  undef MAGMPM_SPECIALIZE
DEAL_II_NAMESPACE_CLOSE

#endif

namespace magmpm
{
  /** Numbers of several cells in one SIMD register: a batch of deal.II's MatrixFree. */
  template <typename Number>
  using CellLanes =
#if MAGMPM_SIMD_BITS > 0
    dealii::VectorizedArray<Number, MAGMPM_SIMD_BITS / (8 * sizeof(Number))>;
#else
    dealii::VectorizedArray<Number>;
#endif
} // namespace magmpm
