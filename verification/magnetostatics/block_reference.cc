#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools.h>

#include <verification/magnetostatics/block_reference.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr double far_away = 30.; ///< half an edge of the space, over the longest half axis
    constexpr double growth   = 2.;  ///< of cells away from the block

    /** Widths of cells from the middle of the block to far away; small at the face. */
    std::vector<double>
    cell_widths(const double half_axis, const double longest, const int n_cells)
    {
      // Inside, widths fall by a factor towards the face, by 30 in all.
      const double ratio = std::pow(1. / 30., 1. / (n_cells - 1.));
      std::vector<double> widths;
      double sum = 0.;
      for (int i = 0; i < n_cells; ++i)
        {
          widths.push_back(std::pow(ratio, i));
          sum += widths.back();
        }
      for (double &width : widths)
        width *= half_axis / sum;
      // Outside, they grow as they fell, then faster.
      double width = widths.back(), position = half_axis;
      while (position < far_away * longest)
        {
          widths.push_back(width);
          position += width;
          width *= position < half_axis + 0.5 * longest ? 1. / ratio : growth;
        }
      return widths;
    }

    template <int dim>
    class BlockProblem
    {
    public:
      BlockProblem(const Vector<dim> &half_axes,
                   const double susceptibility,
                   const bool axisymmetric,
                   const int n_cells)
        : susceptibility(susceptibility)
        , axisymmetric(axisymmetric)
        , fe(2)
        , dof_handler(triangulation)
      {
        std::vector<std::vector<double>> widths;
        dealii::Point<dim> upper;
        const double longest = *std::max_element(half_axes.values, half_axes.values + dim);
        for (int d = 0; d < dim; ++d)
          {
            widths.push_back(cell_widths(half_axes[d], longest, n_cells));
            for (const double width : widths.back())
              upper[d] += width;
          }
        dealii::GridGenerator::subdivided_hyper_rectangle(
          triangulation, widths, dealii::Point<dim>(), upper, true);
        for (const auto &cell : triangulation.active_cell_iterators())
          {
            bool is_inside = true;
            for (int d = 0; d < dim; ++d)
              is_inside = is_inside && cell->center()[d] < half_axes[d];
            cell->set_material_id(is_inside ? 1 : 0);
          }
        set_up();
        assemble();
      }

      /** Solves, and returns the mean of M/H_0 over the block. */
      double
      mean_magnetization()
      {
        dealii::SolverControl control(5000, 1e-9 * right_hand_side.l2_norm());
        dealii::SolverCG<dealii::Vector<double>> solver(control);
        dealii::PreconditionSSOR<dealii::SparseMatrix<double>> preconditioner;
        preconditioner.initialize(matrix, 1.2);
        dealii::Vector<double> potential(dof_handler.n_dofs());
        solver.solve(matrix, potential, right_hand_side, preconditioner);
        constraints.distribute(potential);

        dealii::FEValues<dim> values(fe, quadrature, flags);
        std::vector<dealii::Tensor<1, dim>> gradients(quadrature.size());
        double moment = 0., volume = 0.;
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (cell->material_id() == 1)
            {
              values.reinit(cell);
              values.get_function_gradients(potential, gradients);
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                {
                  moment += weight(values, q) * susceptibility * (1. - gradients[q][dim - 1]);
                  volume += weight(values, q);
                }
            }
        return moment / volume;
      }

    private:
      const dealii::UpdateFlags flags = dealii::update_gradients | dealii::update_JxW_values |
                                        dealii::update_quadrature_points;

      const double susceptibility;
      const bool axisymmetric;
      const dealii::QGauss<dim> quadrature{3};
      dealii::Triangulation<dim> triangulation;
      dealii::FE_Q<dim> fe;
      dealii::DoFHandler<dim> dof_handler;
      dealii::AffineConstraints<double> constraints;
      dealii::SparsityPattern sparsity;
      dealii::SparseMatrix<double> matrix;
      dealii::Vector<double> right_hand_side;

      double
      weight(const dealii::FEValues<dim> &values, const unsigned int q) const
      {
        return values.JxW(q) * (axisymmetric ? values.quadrature_point(q)[0] : 1.);
      }

      /** The potential is odd along the field, which makes it zero on the plane of symmetry, and far away. */
      void
      set_up()
      {
        dof_handler.distribute_dofs(fe);
        const dealii::Functions::ZeroFunction<dim> zero;
        dealii::VectorTools::interpolate_boundary_values(
          dof_handler, 2 * (dim - 1), zero, constraints);
        for (int d = 0; d < dim; ++d)
          dealii::VectorTools::interpolate_boundary_values(
            dof_handler, 2 * d + 1, zero, constraints);
        constraints.close();
        dealii::DynamicSparsityPattern pattern(dof_handler.n_dofs());
        dealii::DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints, false);
        sparsity.copy_from(pattern);
        matrix.reinit(sparsity);
        right_hand_side.reinit(dof_handler.n_dofs());
      }

      /** int (1 + chi) grad v . grad phi = int chi grad v . H_0, H = H_0 - grad phi. */
      void
      assemble()
      {
        const unsigned int n = fe.n_dofs_per_cell();
        dealii::FEValues<dim> values(fe, quadrature, flags);
        dealii::FullMatrix<double> cell_matrix(n, n);
        dealii::Vector<double> cell_vector(n);
        std::vector<dealii::types::global_dof_index> dofs(n);
        for (const auto &cell : dof_handler.active_cell_iterators())
          {
            const double chi = cell->material_id() == 1 ? susceptibility : 0.;
            values.reinit(cell);
            cell_matrix = 0.;
            cell_vector = 0.;
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              for (unsigned int i = 0; i < n; ++i)
                {
                  const auto gradient = weight(values, q) * values.shape_grad(i, q);
                  cell_vector(i) += chi * gradient[dim - 1];
                  for (unsigned int j = 0; j < n; ++j)
                    cell_matrix(i, j) += (1. + chi) * (gradient * values.shape_grad(j, q));
                }
            cell->get_dof_indices(dofs);
            constraints.distribute_local_to_global(
              cell_matrix, cell_vector, dofs, matrix, right_hand_side);
          }
      }
    };
  } // namespace

  template <int dim>
  double
  magnetization_of_block(const Vector<dim> &half_axes,
                         const double susceptibility,
                         const bool axisymmetric,
                         const int n_cells)
  {
    return BlockProblem<dim>(half_axes, susceptibility, axisymmetric, n_cells).mean_magnetization();
  }

  template double
  magnetization_of_block(const Vector<2> &, const double, const bool, const int);
  template double
  magnetization_of_block(const Vector<3> &, const double, const bool, const int);
} // namespace magmpm::verification
