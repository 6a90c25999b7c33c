#include "../catch.h"

#include <magmpm/base/symmetric_root.h>

#include <random>

using namespace magmpm;

TEMPLATE_TEST_CASE_SIG("the root of a symmetric matrix", "[base]", ((int dim), dim), 2, 3)
{
  // Roots of B B^T, among them singular ones and a diagonal one: they are symmetric, and their square is the
  // matrix again. The root of a diagonal matrix is that of its entries, exactly.
  std::mt19937 engine(1);
  for (int i = 0; i < 100; ++i)
    {
      Matrix<dim> b;
      for (int r = 0; r < dim; ++r)
        for (int c = 0; c < dim - (i % 3 == 0 ? 1 : 0); ++c)
          b(r, c) = engine() / 4294967296. - 0.5;
      const Matrix<dim> a    = b * transpose(b);
      const Matrix<dim> root = symmetric_root(a);
      CHECK(frobenius_norm(root + -1. * transpose(root)) < 1e-15);
      CHECK(frobenius_norm(root * root + -1. * a) < 1e-14);
      CHECK(trace(root) > 0.);
    }
  Matrix<dim> diagonal;
  for (int d = 0; d < dim; ++d)
    diagonal(d, d) = (d + 2.) * (d + 2.);
  CHECK(symmetric_root(diagonal)(1, 1) == 3.);
  CHECK(symmetric_root(diagonal)(0, 1) == 0.);
}
