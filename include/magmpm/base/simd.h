#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

/**
 * SIMD for the rooms that must not include deal.II, by the vector types of the compiler: it turns
 * them into the registers that there are, so the same source runs on every processor. The potential
 * solver's lanes are those of deal.II (elliptic/simd_lanes.h).
 */
namespace magmpm
{
  // Bytes of the registers that are compiled for, and their name.
#if defined(__AVX512F__) && defined(__AVX512VL__)
  inline constexpr std::size_t simd_bytes           = 64;
  inline constexpr const char *simd_instruction_set = "AVX-512";
#elif defined(__AVX2__) && defined(__FMA__)
  inline constexpr std::size_t simd_bytes           = 32;
  inline constexpr const char *simd_instruction_set = "AVX2";
#elif defined(__SSE2__)
  inline constexpr std::size_t simd_bytes           = 16;
  inline constexpr const char *simd_instruction_set = "SSE2";
#else
  inline constexpr std::size_t simd_bytes           = 16;
  inline constexpr const char *simd_instruction_set = "generic SIMD";
#endif

  /**
   * Several numbers, the lanes, that every operation acts on one by one. A number in their place
   * stands for itself in each lane.
   *
   * @tparam width  how many, a power of two.
   */
  template <typename Number, int width>
  class Simd
  {
  public:
    using Register __attribute__((vector_size(width * sizeof(Number)))) = Number;
    using Mask = decltype(Register{} < Register{}); ///< all bits of a lane, or none
    using Integer __attribute__((vector_size(width * sizeof(int))))        = int;
    using Bits __attribute__((vector_size(width * sizeof(std::uint64_t)))) = std::uint64_t;

    static constexpr int n_lanes = width;

    Register lanes;

    Simd() = default;

    Simd(const Number number)
      : lanes(Register{} + number)
    {
    }

    Simd(const Register &lanes)
      : lanes(lanes)
    {
    }

    static Simd
    load(const Number *address)
    {
      Simd numbers;
      std::memcpy(&numbers.lanes, address, sizeof(Register));
      return numbers;
    }

    /** The first @p n lanes, 0 < n <= width; the others repeat the last of them. */
    [[gnu::noinline]] static Simd
    load(const Number *address, const int n)
    {
      Simd numbers;
      for (int lane = 0; lane < width; ++lane)
        numbers.lanes[lane] = address[lane < n ? lane : n - 1];
      return numbers;
    }

    void
    store(Number *address) const
    {
      std::memcpy(address, &lanes, sizeof(Register));
    }

    /** The first @p n lanes. */
    [[gnu::noinline]] void
    store(Number *address, const int n) const
    {
      for (int lane = 0; lane < n; ++lane)
        address[lane] = lanes[lane];
    }

    Number
    operator[](const int lane) const
    {
      return lanes[lane];
    }

    Simd &
    operator+=(const Simd &other)
    {
      lanes += other.lanes;
      return *this;
    }

    Simd &
    operator-=(const Simd &other)
    {
      lanes -= other.lanes;
      return *this;
    }

    Simd &
    operator*=(const Simd &other)
    {
      lanes *= other.lanes;
      return *this;
    }

    friend Simd
    operator+(const Simd &a, const Simd &b)
    {
      return a.lanes + b.lanes;
    }

    friend Simd
    operator-(const Simd &a, const Simd &b)
    {
      return a.lanes - b.lanes;
    }

    friend Simd
    operator-(const Simd &a)
    {
      return -a.lanes;
    }

    friend Simd
    operator*(const Simd &a, const Simd &b)
    {
      return a.lanes * b.lanes;
    }

    friend Simd
    operator/(const Simd &a, const Simd &b)
    {
      return a.lanes / b.lanes;
    }

    friend Mask
    operator<(const Simd &a, const Simd &b)
    {
      return a.lanes < b.lanes;
    }

    friend Mask
    operator<=(const Simd &a, const Simd &b)
    {
      return a.lanes <= b.lanes;
    }

    friend Mask
    operator>(const Simd &a, const Simd &b)
    {
      return a.lanes > b.lanes;
    }

    /** @p a where @p mask is set, otherwise @p b. */
    static Simd
    select(const Mask &mask, const Simd &a, const Simd &b)
    {
      return mask ? a.lanes : b.lanes;
    }

    /** As std::max(): @p a where the two cannot be compared. */
    friend Simd
    max(const Simd &a, const Simd &b)
    {
      return select(a < b, b, a);
    }

    friend Simd
    sqrt(const Simd &a)
    {
      Simd root;
      for (int lane = 0; lane < width; ++lane)
        root.lanes[lane] = std::sqrt(a.lanes[lane]);
      return root;
    }

    /** Rounded towards zero; of numbers that an int can hold. */
    Integer
    truncated() const
    {
      return __builtin_convertvector(lanes, Integer);
    }

    static Simd
    from_integer(const Integer &integer)
    {
      return __builtin_convertvector(integer, Register);
    }

    /** The bits of doubles. */
    Bits
    bits() const
    {
      return reinterpret_cast<Bits>(lanes);
    }

    static Simd
    from_bits(const Bits &bits)
    {
      return reinterpret_cast<Register>(bits);
    }
  };

  /** As many doubles as a register has room for. */
  using SimdDouble = Simd<double, simd_bytes / sizeof(double)>;

  /** Lanes first to first + 3. */
  template <int first, typename Number, int width>
  inline Simd<Number, 4>
  four_lanes(const Simd<Number, width> &a)
  {
    return Simd<Number, 4>(
      __builtin_shufflevector(a.lanes, a.lanes, first, first + 1, first + 2, first + 3));
  }

  template <typename Number>
  inline Simd<Number, 8>
  join(const Simd<Number, 4> &a, const Simd<Number, 4> &b)
  {
    return Simd<Number, 8>(__builtin_shufflevector(a.lanes, b.lanes, 0, 1, 2, 3, 4, 5, 6, 7));
  }

  /** Turns four vectors of four lanes around: lane i of vector j becomes lane j of vector i. */
  template <typename Number>
  inline void
  transpose(Simd<Number, 4> (&rows)[4])
  {
    const auto low_01  = __builtin_shufflevector(rows[0].lanes, rows[1].lanes, 0, 4, 2, 6);
    const auto high_01 = __builtin_shufflevector(rows[0].lanes, rows[1].lanes, 1, 5, 3, 7);
    const auto low_23  = __builtin_shufflevector(rows[2].lanes, rows[3].lanes, 0, 4, 2, 6);
    const auto high_23 = __builtin_shufflevector(rows[2].lanes, rows[3].lanes, 1, 5, 3, 7);
    rows[0].lanes      = __builtin_shufflevector(low_01, low_23, 0, 1, 4, 5);
    rows[1].lanes      = __builtin_shufflevector(high_01, high_23, 0, 1, 4, 5);
    rows[2].lanes      = __builtin_shufflevector(low_01, low_23, 2, 3, 6, 7);
    rows[3].lanes      = __builtin_shufflevector(high_01, high_23, 2, 3, 6, 7);
  }

  /** Writes lane l of four vectors to the four places from @p address + l @p stride on. */
  template <typename Number, int width>
  inline void
  store_transposed(const Simd<Number, width> (&numbers)[4], Number *address, const int stride)
  {
    if constexpr (width == 4)
      {
        Simd<Number, 4> rows[4] = {numbers[0], numbers[1], numbers[2], numbers[3]};
        transpose(rows);
        for (int l = 0; l < width; ++l)
          rows[l].store(address + l * stride);
      }
    else if constexpr (width == 8)
      {
        const auto half = [&numbers, stride](const auto select, Number *to) {
          const Simd<Number, 4> rows[4] = {
            select(numbers[0]), select(numbers[1]), select(numbers[2]), select(numbers[3])};
          store_transposed(rows, to, stride);
        };
        half([](const auto &a) { return four_lanes<0>(a); }, address);
        half([](const auto &a) { return four_lanes<4>(a); }, address + 4 * stride);
      }
    else
      for (int l = 0; l < width; ++l)
        for (int i = 0; i < 4; ++i)
          address[l * stride + i] = numbers[i][l];
  }

  /** The inverse of store_transposed(). */
  template <typename Number, int width>
  inline void
  load_transposed(const Number *address, const int stride, Simd<Number, width> (&numbers)[4])
  {
    if constexpr (width == 4)
      {
        for (int l = 0; l < width; ++l)
          numbers[l] = Simd<Number, 4>::load(address + l * stride);
        transpose(numbers);
      }
    else if constexpr (width == 8)
      {
        Simd<Number, 4> low[4], high[4];
        load_transposed(address, stride, low);
        load_transposed(address + 4 * stride, stride, high);
        for (int i = 0; i < 4; ++i)
          numbers[i] = join(low[i], high[i]);
      }
    else
      for (int i = 0; i < 4; ++i)
        {
          numbers[i] = 0.;
          for (int l = 0; l < width; ++l)
            numbers[i].lanes[l] = address[l * stride + i];
        }
  }
} // namespace magmpm
