#pragma once

#include <cmath>

/**
 * Small vectors and matrices for the rooms that must not include deal.II (kernels, point
 * functions). Plain aggregates, so that kernels can keep them in registers; deal.II's own types
 * are always written with their namespace (dealii::Tensor, ...) and cannot be confused with these.
 */
namespace magmpm
{
  /** A vector of R^dim. @tparam Number  double, or Simd: a vector of each of several particles. */
  template <int dim, typename Number = double>
  struct Vector
  {
    using value_type = Number;

    Number values[dim] = {};

    Number &
    operator[](const int i)
    {
      return values[i];
    }

    Number
    operator[](const int i) const
    {
      return values[i];
    }

    Vector &
    operator+=(const Vector &other)
    {
      for (int i = 0; i < dim; ++i)
        values[i] += other[i];
      return *this;
    }

    Vector &
    operator-=(const Vector &other)
    {
      for (int i = 0; i < dim; ++i)
        values[i] -= other[i];
      return *this;
    }

    Vector &
    operator*=(const Number factor)
    {
      for (int i = 0; i < dim; ++i)
        values[i] *= factor;
      return *this;
    }
  };

  /** A dim x dim matrix, stored by rows. @tparam Number  as for Vector. */
  template <int dim, typename Number = double>
  struct Matrix
  {
    using value_type = Number;

    Number values[dim][dim] = {};

    Number &
    operator()(const int i, const int j)
    {
      return values[i][j];
    }

    Number
    operator()(const int i, const int j) const
    {
      return values[i][j];
    }

    Matrix &
    operator+=(const Matrix &other)
    {
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          values[i][j] += other(i, j);
      return *this;
    }

    Matrix &
    operator*=(const Number factor)
    {
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          values[i][j] *= factor;
      return *this;
    }
  };

  /** Angular momentum, torque: three components in 3D, the one across the plane in 2D. */
  template <int dim>
  inline constexpr int n_axial_components = (dim == 3 ? 3 : 1);

  template <int dim, typename Number>
  inline Vector<dim, Number>
  operator+(Vector<dim, Number> a, const Vector<dim, Number> &b)
  {
    return a += b;
  }

  template <int dim, typename Number>
  inline Vector<dim, Number>
  operator-(Vector<dim, Number> a, const Vector<dim, Number> &b)
  {
    return a -= b;
  }

  template <int dim, typename Number>
  inline Vector<dim, Number>
  operator*(const typename Vector<dim, Number>::value_type factor, Vector<dim, Number> a)
  {
    return a *= factor;
  }

  template <int dim, typename Number>
  inline Number
  dot(const Vector<dim, Number> &a, const Vector<dim, Number> &b)
  {
    Number sum = 0.;
    for (int i = 0; i < dim; ++i)
      sum += a[i] * b[i];
    return sum;
  }

  template <int dim, typename Number>
  inline Number
  norm_square(const Vector<dim, Number> &a)
  {
    return dot(a, a);
  }

  template <int dim, typename Number>
  inline Number
  norm(const Vector<dim, Number> &a)
  {
    using std::sqrt;
    return sqrt(norm_square(a));
  }

  /** a x b; in 2D its only component, across the plane. */
  template <int dim, typename Number>
  inline Vector<n_axial_components<dim>, Number>
  cross(const Vector<dim, Number> &a, const Vector<dim, Number> &b)
  {
    if constexpr (dim == 3)
      return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    else
      return {{a[0] * b[1] - a[1] * b[0]}};
  }

  /** The velocity omega x r of a rotation; in 2D omega is across the plane. */
  template <int dim, typename Number>
  inline Vector<dim, Number>
  rotation_velocity(const Vector<n_axial_components<dim>, Number> &omega,
                    const Vector<dim, Number> &r)
  {
    if constexpr (dim == 3)
      return cross(omega, r);
    else
      return {{-omega[0] * r[1], omega[0] * r[0]}};
  }

  template <int dim, typename Number>
  inline Matrix<dim, Number>
  operator+(Matrix<dim, Number> a, const Matrix<dim, Number> &b)
  {
    return a += b;
  }

  template <int dim, typename Number>
  inline Matrix<dim, Number>
  operator*(const typename Matrix<dim, Number>::value_type factor, Matrix<dim, Number> a)
  {
    return a *= factor;
  }

  template <int dim, typename Number>
  inline Vector<dim, Number>
  operator*(const Matrix<dim, Number> &a, const Vector<dim, Number> &x)
  {
    Vector<dim, Number> result;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        result[i] += a(i, j) * x[j];
    return result;
  }

  template <int dim, typename Number>
  inline Matrix<dim, Number>
  operator*(const Matrix<dim, Number> &a, const Matrix<dim, Number> &b)
  {
    Matrix<dim, Number> result;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        {
          Number sum = a(i, 0) * b(0, j);
          for (int k = 1; k < dim; ++k)
            sum += a(i, k) * b(k, j);
          result(i, j) = sum;
        }
    return result;
  }

  template <int dim, typename Number = double>
  inline Matrix<dim, Number>
  identity()
  {
    Matrix<dim, Number> result;
    for (int i = 0; i < dim; ++i)
      result(i, i) = 1.;
    return result;
  }

  template <int dim, typename Number>
  inline Matrix<dim, Number>
  transpose(const Matrix<dim, Number> &a)
  {
    Matrix<dim, Number> result;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        result(i, j) = a(j, i);
    return result;
  }

  template <int dim, typename Number>
  inline Matrix<dim, Number>
  outer(const Vector<dim, Number> &a, const Vector<dim, Number> &b)
  {
    Matrix<dim, Number> result;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        result(i, j) = a[i] * b[j];
    return result;
  }

  template <int dim, typename Number>
  inline Number
  trace(const Matrix<dim, Number> &a)
  {
    Number sum = 0.;
    for (int i = 0; i < dim; ++i)
      sum += a(i, i);
    return sum;
  }

  template <int dim, typename Number>
  inline Number
  determinant(const Matrix<dim, Number> &a)
  {
    if constexpr (dim == 3)
      return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) -
             a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
             a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
    else
      return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  }

  /** Square root of the sum of the squares of all entries. */
  template <int dim, typename Number>
  inline Number
  frobenius_norm(const Matrix<dim, Number> &a)
  {
    Number sum = 0.;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        sum += a(i, j) * a(i, j);
    using std::sqrt;
    return sqrt(sum);
  }
} // namespace magmpm
