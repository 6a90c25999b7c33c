#include <deal.II/lac/full_matrix.h>

#include <magmpm/boundary/rigid_vector.h>

namespace magmpm
{
  template <int n>
  Matrix<n>
  inverse(const Matrix<n> &matrix)
  {
    dealii::FullMatrix<double> full(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        full(i, j) = matrix(i, j);
    full.gauss_jordan();
    Matrix<n> result;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        result(i, j) = full(i, j);
    return result;
  }

  template Matrix<n_rigid_components<2>>
  inverse(const Matrix<n_rigid_components<2>> &);
  template Matrix<n_rigid_components<3>>
  inverse(const Matrix<n_rigid_components<3>> &);
} // namespace magmpm
