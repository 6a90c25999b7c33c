#include <magmpm/base/tensor.h>

#include "catch.h"

using namespace magmpm;

// Matrices and vectors of small integers. Every sum and product is exact, so that the results,
// worked out by hand or by an identity of linear algebra, must be met to the last bit.

namespace
{
  const Matrix<3> a3 = {{{2., -1., 3.}, {0., 4., 5.}, {-2., 1., 7.}}};
  const Matrix<3> b3 = {{{1., 2., 0.}, {-3., 1., 4.}, {5., 0., 2.}}};
  const Matrix<2> a2 = {{{2., -1.}, {3., 4.}}};
  const Matrix<2> b2 = {{{1., 2.}, {-3., 5.}}};

  template <int dim>
  void
  check_equal(const Matrix<dim> &a, const Matrix<dim> &b)
  {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        CHECK(a(i, j) == b(i, j));
  }

  template <int dim>
  void
  check_equal(const Vector<dim> &a, const Vector<dim> &b)
  {
    for (int i = 0; i < dim; ++i)
      CHECK(a[i] == b[i]);
  }
} // namespace

TEST_CASE("determinants are those worked out by hand and multiply", "[base]")
{
  // 2 (28 - 5) + 1 (0 + 10) + 3 (0 + 8) = 80;  1 (2) - 2 (-6 - 20) = 54.
  CHECK(determinant(a3) == 80.);
  CHECK(determinant(b3) == 54.);
  CHECK(determinant(a3 * b3) == 80. * 54.);
  CHECK(determinant(transpose(a3)) == 80.);

  CHECK(determinant(a2) == 11.);
  CHECK(determinant(b2) == 11.);
  CHECK(determinant(a2 * b2) == 121.);
  CHECK(determinant(identity<2>()) == 1.);
  CHECK(determinant(identity<3>()) == 1.);
}

// Small integers, whose products are exact, against the rows times columns of paper; then
// identities that hold for all matrices and would catch a transposition.
TEST_CASE("products of matrices and vectors are those worked out by hand", "[base]")
{
  check_equal(a2 * b2, {{{5., -1.}, {-9., 26.}}});
  check_equal(a2 * Vector<2>{{1., -2.}}, {{4., -5.}});
  check_equal(a3 * Vector<3>{{1., 2., -1.}}, {{-3., 3., -7.}});
  check_equal(a3 * identity<3>(), a3);

  // (A B)^T = B^T A^T and (A B) x = A (B x).
  const Vector<3> x = {{1., 2., 3.}};
  check_equal(transpose(a3 * b3), transpose(b3) * transpose(a3));
  check_equal((a3 * b3) * x, a3 * (b3 * x));

  // (x y^T) z = x (y.z): rows belong to the first vector.
  const Vector<3> y = {{-1., 0., 2.}};
  const Vector<3> z = {{4., 1., 5.}};
  check_equal(outer(x, y) * z, dot(y, z) * x);
}

// Exact sums of small integers, each component with another value, so that no two can be
// exchanged.
TEST_CASE("sums, differences and multiples go by component", "[base]")
{
  const Vector<3> x = {{1., 2., 3.}};
  const Vector<3> y = {{-1., 5., 2.}};
  check_equal(x + y, {{0., 7., 5.}});
  check_equal(x - y, {{2., -3., 1.}});
  check_equal(2. * x, {{2., 4., 6.}});

  check_equal(a2 + b2, {{{3., 1.}, {0., 9.}}});
  check_equal(3. * a2, {{{6., -3.}, {9., 12.}}});
}

// Pythagorean numbers, whose roots are exact.
TEST_CASE("norms and traces are those worked out by hand", "[base]")
{
  CHECK(dot(Vector<3>{{1., 2., 3.}}, Vector<3>{{4., -5., 6.}}) == 12.);
  CHECK(norm_square(Vector<3>{{2., 3., 6.}}) == 49.);
  CHECK(norm(Vector<3>{{2., 3., 6.}}) == 7.);
  CHECK(norm(Vector<2>{{3., -4.}}) == 5.);
  CHECK(trace(a3) == 13.);
  CHECK(trace(a2) == 6.);
  CHECK(frobenius_norm(Matrix<2>{{{1., 2.}, {-2., 4.}}}) == 5.);
}

// e_x x e_y = e_z fixes the sign, a product worked out by hand the components, and that it is
// perpendicular to both factors and antisymmetric the rest.
TEST_CASE("the cross product follows the right hand, in 2D its component across the plane",
          "[base]")
{
  const Vector<3> x = {{2., -1., 3.}};
  const Vector<3> y = {{4., 1., 5.}};
  check_equal(cross(Vector<3>{{1., 0., 0.}}, Vector<3>{{0., 1., 0.}}), {{0., 0., 1.}});
  check_equal(cross(x, y), {{-8., 2., 6.}});
  CHECK(dot(cross(x, y), x) == 0.);
  CHECK(dot(cross(x, y), y) == 0.);
  check_equal(cross(y, x), -1. * cross(x, y));

  const Vector<2> p = {{2., -1.}};
  const Vector<2> q = {{4., 1.}};
  CHECK(cross(p, q)[0] == 6.);
  CHECK(n_axial_components<2> == 1);
  CHECK(n_axial_components<3> == 3);
}

TEST_CASE("a rotation about z moves points of the plane alike in 2D and 3D", "[base]")
{
  // omega x r with omega = 3 e_z and r = (2, 5, 7) is (-15, 6, 0), whatever z is.
  check_equal(rotation_velocity<3>(Vector<3>{{0., 0., 3.}}, Vector<3>{{2., 5., 7.}}),
              {{-15., 6., 0.}});
  check_equal(rotation_velocity<2>(Vector<1>{{3.}}, Vector<2>{{2., 5.}}), {{-15., 6.}});
}
