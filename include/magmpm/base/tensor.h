#pragma once

#include <cmath>

/**
 * Small vectors and matrices for the rooms that must not include deal.II (kernels, point
 * functions). Plain aggregates, so that kernels can keep them in registers; deal.II's own types
 * are always written with their namespace (dealii::Tensor, ...) and cannot be confused with these.
 */
namespace magmpm
{
  /** A vector of R^dim. */
  template <int dim>
  struct Vector
  {
    double values[dim] = {};

    double &
    operator[](const int i)
    {
      return values[i];
    }

    double
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
    operator*=(const double factor)
    {
      for (int i = 0; i < dim; ++i)
        values[i] *= factor;
      return *this;
    }
  };

  /** A dim x dim matrix, stored by rows. */
  template <int dim>
  struct Matrix
  {
    double values[dim][dim] = {};

    double &
    operator()(const int i, const int j)
    {
      return values[i][j];
    }

    double
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
    operator*=(const double factor)
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

  template <int dim>
  inline Vector<dim>
  operator+(Vector<dim> a, const Vector<dim> &b)
  {
    return a += b;
  }

  template <int dim>
  inline Vector<dim>
  operator-(Vector<dim> a, const Vector<dim> &b)
  {
    return a -= b;
  }

  template <int dim>
  inline Vector<dim>
  operator*(const double factor, Vector<dim> a)
  {
    return a *= factor;
  }

  template <int dim>
  inline double
  dot(const Vector<dim> &a, const Vector<dim> &b)
  {
    double sum = 0.;
    for (int i = 0; i < dim; ++i)
      sum += a[i] * b[i];
    return sum;
  }

  template <int dim>
  inline double
  norm_square(const Vector<dim> &a)
  {
    return dot(a, a);
  }

  template <int dim>
  inline double
  norm(const Vector<dim> &a)
  {
    return std::sqrt(norm_square(a));
  }

  /** a x b; in 2D its only component, across the plane. */
  template <int dim>
  inline Vector<n_axial_components<dim>>
  cross(const Vector<dim> &a, const Vector<dim> &b)
  {
    if constexpr (dim == 3)
      return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    else
      return {{a[0] * b[1] - a[1] * b[0]}};
  }

  /** The velocity omega x r of a rotation; in 2D omega is across the plane. */
  template <int dim>
  inline Vector<dim>
  rotation_velocity(const Vector<n_axial_components<dim>> &omega, const Vector<dim> &r)
  {
    if constexpr (dim == 3)
      return cross(omega, r);
    else
      return {{-omega[0] * r[1], omega[0] * r[0]}};
  }

  template <int dim>
  inline Matrix<dim>
  operator+(Matrix<dim> a, const Matrix<dim> &b)
  {
    return a += b;
  }

  template <int dim>
  inline Matrix<dim>
  operator*(const double factor, Matrix<dim> a)
  {
    return a *= factor;
  }

  template <int dim>
  inline Vector<dim>
  operator*(const Matrix<dim> &a, const Vector<dim> &x)
  {
    Vector<dim> result;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        result[i] += a(i, j) * x[j];
    return result;
  }

  template <int dim>
  inline Matrix<dim>
  operator*(const Matrix<dim> &a, const Matrix<dim> &b)
  {
    Matrix<dim> result;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        for (int k = 0; k < dim; ++k)
          result(i, j) += a(i, k) * b(k, j);
    return result;
  }

  template <int dim>
  inline Matrix<dim>
  identity()
  {
    Matrix<dim> result;
    for (int i = 0; i < dim; ++i)
      result(i, i) = 1.;
    return result;
  }

  template <int dim>
  inline Matrix<dim>
  transpose(const Matrix<dim> &a)
  {
    Matrix<dim> result;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        result(i, j) = a(j, i);
    return result;
  }

  template <int dim>
  inline Matrix<dim>
  outer(const Vector<dim> &a, const Vector<dim> &b)
  {
    Matrix<dim> result;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        result(i, j) = a[i] * b[j];
    return result;
  }

  template <int dim>
  inline double
  trace(const Matrix<dim> &a)
  {
    double sum = 0.;
    for (int i = 0; i < dim; ++i)
      sum += a(i, i);
    return sum;
  }

  template <int dim>
  inline double
  determinant(const Matrix<dim> &a)
  {
    if constexpr (dim == 3)
      return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) -
             a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
             a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
    else
      return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  }

  /** Square root of the sum of the squares of all entries. */
  template <int dim>
  inline double
  frobenius_norm(const Matrix<dim> &a)
  {
    double sum = 0.;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        sum += a(i, j) * a(i, j);
    return std::sqrt(sum);
  }
} // namespace magmpm
