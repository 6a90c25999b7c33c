#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/motion/expression.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  /** The message with which an expression in 3D is refused; empty if it is not. */
  std::string
  refusal(const std::string &expression)
  {
    try
      {
        read_expression<3>(expression, "Position of source 'ball'");
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace

TEST_CASE("an expression is evaluated component by component", "[motion]")
{
  // The expressions are those that C++ computes beside them, with constants, functions, a condition
  // and either separator.
  const auto script = read_expression<3>("0.5 + 0.1*t^2; sin(2*pi*t), if(t < 1, 1, max(2, t))",
                                         "Position");
  for (const double t : {0., 0.3, 2.5})
    {
      const Vector<3> x = script(t);
      CHECK(x[0] == Approx(0.5 + 0.1 * t * t));
      CHECK(x[1] == Approx(std::sin(2. * constants::pi * t)).margin(1e-15));
      CHECK(x[2] == (t < 1. ? 1. : std::max(2., t)));
    }
  CHECK(read_expression<2>(" 1e5*t ;-2", "Field")(3.)[0] == 3e5);
}

TEST_CASE("an expression without t is constant", "[motion]")
{
  // Whether the name t occurs, and not whether the letter does (tan, 1e5, sqrt).
  CHECK(read_expression<2>("tan(0.5)*1e5; sqrt(2)", "Field").is_constant());
  CHECK(!read_expression<2>("0; 2*t", "Field").is_constant());
  CHECK(!read_expression<2>("0; sin(t)", "Field").is_constant());
}

TEST_CASE("a wrong expression is refused with its reason", "[motion]")
{
  // The wording, which users meet: who, what, why, and what is allowed.
  CHECK(refusal("0.5; 0.5") ==
        "Position of source 'ball': '0.5; 0.5' has 2 components, not 3. Give 3 expressions of the "
        "time t [s], separated by semicolons, such as '0.5; 0.5; 0.2 + 0.1*t'.");
  CHECK(contains(refusal(""), "'' has 1 component, not 3."));
  CHECK(contains(refusal("1; 2; 3; 4"), "has 4 components, not 3."));

  const std::string unknown = refusal("0.5; 0.5; 0.2 + speed*t");
  CHECK_THAT(unknown,
             Catch::Matchers::StartsWith(
               "Position of source 'ball': '0.5; 0.5; 0.2 + speed*t' cannot be read: "));
  CHECK(contains(unknown, "speed"));
  CHECK_THAT(unknown, Catch::Matchers::EndsWith("'0.5; 0.5; 0.2 + 0.1*t'; pi is known."));
  CHECK(!contains(unknown, "\n"));

  CHECK(contains(refusal("0.5; (0.5; 1"), "cannot be read: Missing parenthesis. Give 3 expr"));
  CHECK(contains(refusal("0.5;; 1"), "cannot be read"));
  CHECK(contains(refusal("0; 0; rand()"), "draws random numbers"));
  CHECK(contains(refusal("0; 1/t; 0"), "is not a finite number at t = 0 s (component 2)"));
  CHECK(contains(refusal("0; 0; 0/t"), "is not a finite number at t = 0 s (component 3)"));
  CHECK_THROWS_AS(read_expression<2>("1/(t - 1); 0", "Position")(1.), InputError);
}
