#pragma once

#include <functional>
#include <type_traits>
#include <utility>

namespace magmpm
{
  /**
   * A quantity that changes in time as the user says: a constant, an expression (read_expression()) or
   * key frames (read_key_frames()). Made when parameters are read, so that whoever holds one holds no
   * text. Only times >= 0 are ever asked for.
   */
  template <typename Value>
  class TimeFunction
  {
  public:
    /** The same at all times. */
    TimeFunction(const Value &constant = Value())
      : constant(constant)
    {
    }

    /** @param function  the value at a time [s]. */
    template <typename Function,
              std::enable_if_t<std::is_invocable_r_v<Value, Function, double>, int> = 0>
    explicit TimeFunction(Function function)
      : function(std::move(function))
    {
    }

    /** @param time  >= 0 [s]. */
    Value
    operator()(const double time) const
    {
      return function ? function(time) : constant;
    }

    bool
    is_constant() const
    {
      return !function;
    }

    /** What @p change makes of the value; constant if this is. */
    template <typename Change>
    auto
    transformed(Change change) const
    {
      using Result = std::decay_t<decltype(change(std::declval<Value>()))>;
      if (is_constant())
        return TimeFunction<Result>(change(constant));
      return TimeFunction<Result>(
        [inner = function, change](const double time) { return change(inner(time)); });
    }

  private:
    Value constant = Value();
    std::function<Value(double)> function; ///< empty: constant
  };
} // namespace magmpm
