#include "catch.h"

#include <magmpm/elliptic/newton_solver.h>

#include <deal.II/lac/vector.h>

#include <cmath>
#include <functional>

using namespace magmpm;

namespace
{
  using VectorType = dealii::Vector<double>;

  /** Equations of one unknown each, solved as exactly as asked for. */
  class Uncoupled : public NewtonProblem<VectorType>
  {
  public:
    std::function<double(double)> function, derivative;
    VectorType slope;

    void
    evaluate(const VectorType &x, VectorType &residual) override
    {
      slope.reinit(x);
      for (unsigned int i = 0; i < x.size(); ++i)
        {
          residual(i) = function(x(i));
          slope(i)    = derivative(x(i));
        }
    }

    int
    solve_linearized(const VectorType &residual, const double tolerance, VectorType &step) override
    {
      for (unsigned int i = 0; i < step.size(); ++i)
        step(i) = -(1. - 0.5 * tolerance) * residual(i) / slope(i);
      return 1;
    }
  };

  Uncoupled
  arctangent()
  {
    Uncoupled problem;
    problem.function   = [](const double x) { return std::atan(x); };
    problem.derivative = [](const double x) { return 1. / (1. + x * x); };
    return problem;
  }
} // namespace

// atan(x) = 0 from x = 3 is found with halved steps. The undamped method diverges from |x| > 1.39.
TEST_CASE("Newton's method converges with a line search where it would diverge", "[elliptic]")
{
  Uncoupled problem = arctangent();
  VectorType x(2);
  x(0)                      = 3.;
  x(1)                      = -20.;
  const NewtonReport report = damped_newton<VectorType>(problem, {1e-12, 50, false}, x);
  CHECK(x.linfty_norm() < 1e-11);
  CHECK(report.line_search_steps > 0);
  CHECK(report.steps == static_cast<int>(report.residuals.size()) - 1);
  CHECK(report.linear_iterations == report.steps);
  for (int i = 0; i < report.steps; ++i)
    CHECK(report.residuals[i + 1] < report.residuals[i]);
}

// Near the solution the residual falls quadratically: atan has no second derivative at its zero, so
// at least the square of the last one is reached, times the safety factor of the forcing term.
TEST_CASE("Newton's method converges quadratically with inexact steps", "[elliptic]")
{
  Uncoupled problem  = arctangent();
  problem.function   = [](const double x) { return std::exp(x) - 1.; };
  problem.derivative = [](const double x) { return std::exp(x); };
  VectorType x(1);
  x(0)                      = 0.5;
  const NewtonReport report = damped_newton<VectorType>(problem, {1e-13, 50, false}, x);
  CHECK(report.steps <= 6);
  CHECK(report.line_search_steps == 0);
}

// A linear problem takes one step, and one that is solved already takes none: the first linear
// system is solved to the tolerance of the whole.
TEST_CASE("Newton's method takes one step for a linear problem", "[elliptic]")
{
  Uncoupled problem;
  problem.function   = [](const double x) { return 3. * x - 1.; };
  problem.derivative = [](const double) { return 3.; };
  VectorType x(1);
  CHECK(damped_newton<VectorType>(problem, {1e-10, 50, true}, x).steps == 1);
  CHECK(x(0) == Approx(1. / 3.).epsilon(1e-9));
  CHECK(damped_newton<VectorType>(problem, {1e-9, 50, true}, x).steps == 0);
}

// Where there is no solution the error names the residuals: a user has to see how far it came.
TEST_CASE("Newton's method says how far it came when it fails", "[elliptic]")
{
  Uncoupled problem;
  problem.function   = [](const double x) { return std::exp(x); };
  problem.derivative = [](const double x) { return std::exp(x); };
  VectorType x(1);
  std::string message;
  try
    {
      damped_newton<VectorType>(problem, {1e-3, 3, false}, x);
    }
  catch (const RunError &error)
    {
      message = error.what();
    }
  CHECK(message.find("did not converge in 3 steps") != std::string::npos);
  CHECK(message.find("1.00e+00 ") != std::string::npos);
  CHECK(message.find("to reach was 1.00e-03") != std::string::npos);

#ifndef DEBUG // there deal.II ends the program itself, at the norm
  problem.function = [](const double) { return std::nan(""); };
  CHECK_THROWS_AS((damped_newton<VectorType>(problem, {1e-3, 3, false}, x)), RunError);
#endif
}
