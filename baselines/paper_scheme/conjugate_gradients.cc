#include <baselines/paper_scheme/conjugate_gradients.h>

#include <cmath>

namespace magmpm::paper_scheme
{
  double
  internal::update_residual(const double alpha, const NodeVector &q_vector, NodeVector &r_vector)
  {
    const double *const q = q_vector.data();
    double *const r       = r_vector.data();
    double sum            = 0.;
#pragma omp simd reduction(+ : sum)
    for (std::ptrdiff_t i = 0; i < r_vector.size(); ++i)
      {
        r[i] -= alpha * q[i];
        sum += r[i] * r[i];
      }
    return std::sqrt(sum);
  }

  void
  internal::update_solution_and_direction(const double alpha,
                                          const double beta,
                                          const NodeVector &z_vector,
                                          NodeVector &x_vector,
                                          NodeVector &p_vector)
  {
    const double *const z = z_vector.data();
    double *const x       = x_vector.data();
    double *const p       = p_vector.data();
#pragma omp simd
    for (std::ptrdiff_t i = 0; i < p_vector.size(); ++i)
      {
        x[i] += alpha * p[i];
        p[i] = z[i] + beta * p[i];
      }
  }
} // namespace magmpm::paper_scheme
