#include <magmpm/elliptic/open_boundary.h>
#include <magmpm/lattice/cell_quadrature.h>

namespace magmpm
{
  namespace
  {
    constexpr int n_dofs_1d = potential_degree + 1;

    /** Shape functions of FE_Q(2) on [0, 1], lexicographic. */
    double
    shape_value(const int dof, const double x)
    {
      switch (dof)
        {
          case 0:
            return (1. - x) * (1. - 2. * x);
          case 1:
            return 4. * x * (1. - x);
          default:
            return x * (2. * x - 1.);
        }
    }

    template <int dim>
    Index<dim>
    split(int number)
    {
      Index<dim> index;
      for (int d = 0; d < dim; ++d, number /= 3)
        index[d] = number % 3;
      return index;
    }
  } // namespace

  template <int dim>
  OpenBoundary<dim>::OpenBoundary(const EllipticSpace<dim> &space,
                                  const std::array<bool, 2 * dim> &shielded,
                                  const Vector<dim> &centre)
    : lower_corner(space.lower_corner)
    , upper_corner(space.upper_corner)
  {
    for (int d = 0; d < dim; ++d)
      {
        open[2 * d]     = !shielded[2 * d];
        open[2 * d + 1] = !shielded[2 * d + 1];
        counts[d]       = open[2 * d] || open[2 * d + 1];
        decay += counts[d];

        const bool is_inside = centre[d] > lower_corner[d] && centre[d] < upper_corner[d];
        if (open[2 * d] && open[2 * d + 1])
          start[d] = is_inside ? centre[d] : 0.5 * (lower_corner[d] + upper_corner[d]);
        else
          start[d] = open[2 * d] ? upper_corner[d] : lower_corner[d];
      }
    decay -= 1;
    has_robin = decay > 0;
  }

  template <int dim>
  double
  OpenBoundary<dim>::coefficient(const Vector<dim> &point, const int axis, const int sign) const
  {
    double square = 0.;
    for (int d = 0; d < dim; ++d)
      if (counts[d])
        square += (point[d] - start[d]) * (point[d] - start[d]);
    return decay * sign * (point[axis] - start[axis]) / square;
  }

  template <int dim>
  void
  OpenBoundary<dim>::add_face(const CellIterator &cell,
                              const int axis,
                              const int side,
                              dealii::FullMatrix<double> &matrix) const
  {
    const double edge = cell->extent_in_direction(0); // cells are cubes
    for (int q = 0; q < power(n_points_1d, dim - 1); ++q)
      {
        // Position in the cell, in [0, 1], and weight on the face.
        Vector<dim> unit_point, point;
        double weight = 1.;
        for (int d = 0, rest = q; d < dim; ++d)
          {
            unit_point[d] = side;
            if (d != axis)
              {
                unit_point[d] = 0.5 * CellRule<n_points_1d>::points[rest % n_points_1d];
                weight *= 0.5 * edge * CellRule<n_points_1d>::weights[rest % n_points_1d];
                rest /= n_points_1d;
              }
            point[d] = cell->vertex(0)[d] + edge * unit_point[d];
          }
        weight *= coefficient(point, axis, side == 0 ? -1 : 1);

        double values[power(n_dofs_1d, dim)];
        for (int i = 0; i < power(n_dofs_1d, dim); ++i)
          {
            values[i]              = 1.;
            const Index<dim> index = split<dim>(i);
            for (int d = 0; d < dim; ++d)
              values[i] *= shape_value(index[d], unit_point[d]);
          }
        for (int i = 0; i < power(n_dofs_1d, dim); ++i)
          for (int j = 0; j < power(n_dofs_1d, dim); ++j)
            matrix(i, j) += weight * values[i] * values[j];
      }
  }

  template <int dim>
  bool
  OpenBoundary<dim>::element_matrix(const CellIterator &cell,
                                    dealii::FullMatrix<double> &matrix) const
  {
    constexpr int n_dofs = power(n_dofs_1d, dim);
    if (!has_robin)
      {
        // Colorized boundary: a cell at the lower faces of all axes holds the lower corner.
        for (int axis = 0; axis < dim; ++axis)
          if (!cell->at_boundary(2 * axis))
            return false;
        matrix.reinit(n_dofs, n_dofs);
        // The same number on all levels, as it belongs to one value of the potential.
        matrix(0, 0) = std::pow(upper_corner[0] - lower_corner[0], dim - 2);
        return true;
      }

    bool has_matrix = false;
    for (int face = 0; face < 2 * dim; ++face)
      if (open[face] && cell->at_boundary(face))
        {
          if (!has_matrix)
            matrix.reinit(n_dofs, n_dofs);
          has_matrix = true;
          add_face(cell, face / 2, face % 2, matrix);
        }
    return has_matrix;
  }

  template class OpenBoundary<2>;
  template class OpenBoundary<3>;
} // namespace magmpm
