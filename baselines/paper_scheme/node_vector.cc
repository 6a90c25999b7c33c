#include <baselines/paper_scheme/node_vector.h>

#include <cmath>

namespace magmpm::paper_scheme
{
  void
  NodeVector::add(const double factor, const NodeVector &other)
  {
    double *const x       = data();
    const double *const y = other.data();
#pragma omp simd
    for (std::ptrdiff_t i = 0; i < n_nodes; ++i)
      x[i] += factor * y[i];
  }

  double
  NodeVector::l2_norm() const
  {
    const double *const x = data();
    double sum            = 0.;
#pragma omp simd reduction(+ : sum)
    for (std::ptrdiff_t i = 0; i < n_nodes; ++i)
      sum += x[i] * x[i];
    return std::sqrt(sum);
  }
} // namespace magmpm::paper_scheme
