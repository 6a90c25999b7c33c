#pragma once

#include <magmpm/base/tensor.h>

#include <type_traits>
#include <utility>

namespace magmpm::parallel
{
  namespace internal
  {
    struct AnyVisitor
    {
      template <typename T>
      void
      operator()(T &) const
      {
      }
    };

    /** Whether a T lists its numbers by a member function for_each_number(f). */
    template <typename T, typename = void>
    inline constexpr bool lists_its_numbers = false;

    template <typename T>
    inline constexpr bool
      lists_its_numbers<T,
                        std::void_t<decltype(std::declval<T &>().for_each_number(AnyVisitor()))>> =
        true;

    template <typename T>
    inline constexpr bool is_tensor = false;
    template <int dim, typename Number>
    inline constexpr bool is_tensor<Vector<dim, Number>> = true;
    template <int dim, typename Number>
    inline constexpr bool is_tensor<Matrix<dim, Number>> = true;
  } // namespace internal

  /**
   * Calls f(number) with every number in @p x, always in the same order, and always the numbers
   * themselves, so that f can change them. x is
   * - a number or an enumeration,
   * - a Vector, Matrix, array or standard container of what can be x,
   * - a struct that names its members (which can be x) in a member function
   *     `template <typename F> void for_each_number(F &&f) { f(mass); f(momentum); }`
   */
  template <typename T, typename F>
  void
  for_each_number(T &x, const F &f)
  {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
      f(x);
    else if constexpr (internal::lists_its_numbers<T>)
      x.for_each_number([&f](auto &member) { parallel::for_each_number(member, f); });
    else if constexpr (internal::is_tensor<T>)
      parallel::for_each_number(x.values, f);
    else
      for (auto &element : x)
        parallel::for_each_number(element, f);
  }
} // namespace magmpm::parallel
