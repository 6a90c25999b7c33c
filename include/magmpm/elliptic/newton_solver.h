#pragma once

#include <magmpm/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace magmpm
{
  /** What a Newton solve did. */
  struct NewtonReport
  {
    int steps             = 0;
    int line_search_steps = 0;     ///< halvings of a step, in all
    int linear_iterations = 0;     ///< of the linear solver, in all
    std::vector<double> residuals; ///< norms, the one at the start first

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &steps;
      archive &line_search_steps;
      archive &linear_iterations;
      archive &residuals;
    }
  };

  /** When a Newton solve ends. */
  struct NewtonParameters
  {
    double tolerance = 0.; ///< on the norm of the residual, absolute
    int max_steps    = 25;
    bool is_linear   = false; ///< the first linear system is solved straight to the tolerance

    /** Norm of the residual before a good start was found for x, or zero if that is not known. */
    double residual_without_start = 0.;
  };

  /** A system of equations F(x) = 0, as damped_newton() sees it. */
  template <typename VectorType>
  class NewtonProblem
  {
  public:
    virtual ~NewtonProblem() = default;

    /** Computes F(x) and keeps what the linearization at this x needs. */
    virtual void
    evaluate(const VectorType &x, VectorType &residual) = 0;

    /**
     * Solves F'(x) step = -residual for the x that was evaluated last.
     *
     * @param relative_tolerance  on the residual of the linear system, relative to @p residual.
     * @return iterations of the linear solver.
     */
    virtual int
    solve_linearized(const VectorType &residual,
                     const double relative_tolerance,
                     VectorType &step) = 0;
  };

  /**
   * How exactly to solve the linear system of a Newton step (Eisenstat and Walker 1996, choice 2):
   * eta = 0.9 (|F| / |F_previous|)^2, safeguarded by 0.9 eta_previous^2 while that is large, at most
   * 0.1, and no smaller than what reaches the tolerance of the Newton solve in this step. Keeps the
   * quadratic convergence at about a third of the linear iterations that exact solves need.
   *
   * @param residual  |F|.
   * @param before    |F_previous|, or zero if there is none.
   * @param previous  eta_previous.
   */
  inline double
  forcing_term(const double residual,
               const double before,
               const double previous,
               const double tolerance)
  {
    constexpr double largest = 0.1;
    double eta               = largest;
    if (before > 0.)
      {
        const double safeguard = 0.9 * previous * previous;
        eta                    = 0.9 * std::pow(residual / before, 2);
        if (safeguard > largest)
          eta = std::max(eta, safeguard);
      }
    return std::clamp(eta, std::min(0.3 * tolerance / residual, largest), largest);
  }

  /** "1.0e+00 5.4e-02 ..." for error messages. */
  inline std::string
  to_string(const std::vector<double> &residuals)
  {
    std::ostringstream text;
    text.precision(2);
    text << std::scientific;
    for (const double residual : residuals)
      text << (text.tellp() > 0 ? " " : "") << residual;
    return text.str();
  }

  /**
   * Inexact Newton method with backtracking on the norm of the residual.
   *
   * For the gradient F of a strictly convex energy (Jacobian positive definite), this norm and the
   * energy both fall along the Newton direction, and backtracking on either converges from any start.
   * The norm is taken because near the solution the energy changes by less than its rounding error.
   *
   * @param x               start on entry, solution on return.
   * @param start_residual  F(x) at the start, if that is where @p problem was evaluated last.
   * @throw RunError with the history of the residual if @p parameters are not met.
   */
  template <typename VectorType>
  NewtonReport
  damped_newton(NewtonProblem<VectorType> &problem,
                const NewtonParameters &parameters,
                VectorType &x,
                const VectorType *start_residual = nullptr)
  {
    constexpr double sufficient_decrease = 1e-4;
    constexpr int max_halvings           = 16;

    NewtonReport report;
    VectorType residual, step, start;
    residual.reinit(x);
    step.reinit(x);
    if (start_residual)
      residual = *start_residual;
    else
      problem.evaluate(x, residual);
    report.residuals.push_back(residual.l2_norm());

    double before = parameters.residual_without_start, eta = 0.;
    while (!(report.residuals.back() <= parameters.tolerance))
      {
        const double norm = report.residuals.back();
        if (report.steps == parameters.max_steps || !std::isfinite(norm))
          throw RunError("Newton's method did not converge in " + std::to_string(report.steps) +
                         " steps: the norms of the residual were " + to_string(report.residuals) +
                         ", to reach was " + to_string({parameters.tolerance}) + ".");

        eta = parameters.is_linear ? std::min(0.5 * parameters.tolerance / norm, 0.1)
                                   : forcing_term(norm, before, eta, parameters.tolerance);
        report.linear_iterations += problem.solve_linearized(residual, eta, step);

        start         = x;
        double length = 1.;
        for (int halvings = 0;; ++halvings, length *= 0.5)
          {
            x = start;
            x.add(length, step);
            problem.evaluate(x, residual);
            if (residual.l2_norm() <= (1. - sufficient_decrease * length) * norm)
              break;
            if (halvings == max_halvings)
              throw RunError("Newton's method did not converge: no step along the Newton direction "
                             "makes the residual smaller. Its norms were " +
                             to_string(report.residuals) + ", to reach was " +
                             to_string({parameters.tolerance}) +
                             "; a tolerance below the rounding error cannot be met.");
            ++report.line_search_steps;
          }
        report.residuals.push_back(residual.l2_norm());
        before = norm;
        ++report.steps;
      }
    return report;
  }
} // namespace magmpm
