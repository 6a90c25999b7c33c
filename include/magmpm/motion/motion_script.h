#pragma once

#include <magmpm/base/tensor.h>

#include <memory>
#include <string>

namespace magmpm
{
  /**
   * A vector that changes in time by a formula of the user: one expression of t [s] per component,
   * separated by semicolons or commas, as in "0.5; 0.5; 0.2 + 0.1*t". The expressions are those of
   * muParser (+ - * / ^, sin, exp, sqrt, if(t < 1, a, b), ...), and pi is known. Only t >= 0 is
   * ever asked for.
   */
  template <int dim>
  class MotionScript
  {
  public:
    /**
     * @param expression  dim expressions of t.
     * @param subject     what is given by them, for messages: "Position of magnet 'ball'".
     * @throw InputError  names subject and expression, if it does not have dim components, cannot
     *                    be parsed, draws random numbers, or is not a number at t = 0.
     */
    MotionScript(const std::string &expression, const std::string &subject);

    ~MotionScript();
    MotionScript(MotionScript &&) noexcept;
    MotionScript &
    operator=(MotionScript &&) noexcept;

    /**
     * The vector at @p time >= 0 [s].
     *
     * @throw InputError  if a component is infinite or not a number there.
     */
    Vector<dim>
    value(const double time) const;

    /** Whether t does not occur in the expressions. */
    bool
    is_constant() const
    {
      return constant;
    }

  private:
    std::string expression;
    std::string subject;
    bool constant;

    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace magmpm
