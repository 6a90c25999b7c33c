#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/multigrid/mg_coarse.h>
#include <deal.II/multigrid/mg_matrix.h>
#include <deal.II/multigrid/mg_smoother.h>
#include <deal.II/multigrid/mg_tools.h>
#include <deal.II/multigrid/mg_transfer_matrix_free.h>
#include <deal.II/multigrid/multigrid.h>

#include <magmpm/elliptic/elliptic_operator.h>
#include <magmpm/elliptic/multigrid_preconditioner.h>

#include <algorithm>
#include <map>
#include <optional>

namespace magmpm
{
  namespace
  {
    template <int dim>
    using LevelCell = typename dealii::Triangulation<dim>::cell_iterator;

    /**
     * K at the points of the cells of all levels. A point of a cell with children stands for two
     * of the six points of its children along each axis, and has half their arithmetic and half their
     * harmonic mean, weighted: surfaces stay where they are on all levels, which one mean for all points
     * of a cell would blur. Cells without an entry are vacuum.
     */
    template <int dim>
    class LevelCoefficient
    {
    public:
      using Tensor  = dealii::SymmetricTensor<2, dim>;
      using Tensors = std::vector<Tensor>; ///< at the points of a cell

      LevelCoefficient(const EllipticSpace<dim> &space, const JacobianData<dim> &jacobian)
        : space(space)
        , cells(space.mesh.triangulation().n_global_levels())
      {
        for (const auto &cell : space.mesh.triangulation().active_cell_iterators())
          if (cell->is_locally_owned())
            if (const Tensor *values = jacobian.coefficient(
                  space.lattice_cell_of_active_cell[cell->active_cell_index()]))
              cells[cell->level()][cell->index()] = Tensors(values, values + n_points<dim>);
        for (int level = static_cast<int>(cells.size()) - 2; level >= 0; --level)
          {
            exchange(level + 1);
            average_children(level);
          }
      }

      /** The tensors at the points of a cell of this rank, or a null pointer for vacuum. */
      const Tensor *
      operator()(const LevelCell<dim> &cell) const
      {
        const auto found = cells[cell->level()].find(cell->index());
        return found == cells[cell->level()].end() ? nullptr : found->second.data();
      }

    private:
      const EllipticSpace<dim> &space;
      std::vector<std::map<int, Tensors>> cells; ///< by level and cell index

      void
      average_children(const int level)
      {
        for (const auto &cell : space.mesh.triangulation().cell_iterators_on_level(level))
          if (cell->has_children() && cell->is_locally_owned_on_level())
            {
              std::array<const Tensor *, power(2, dim)> children;
              for (unsigned int c = 0; c < children.size(); ++c)
                children[c] = (*this)(cell->child(c));
              if (std::all_of(children.begin(), children.end(), [](const Tensor *child) {
                    return child == nullptr;
                  }))
                continue;
              Tensors &tensors = cells[level][cell->index()];
              tensors.resize(n_points<dim>);
              for (int q = 0; q < n_points<dim>; ++q)
                tensors[q] = mean_at(q, children);
            }
      }

      /** Along an axis, point p of a cell stands for points 2 p and 2 p + 1 of its children. */
      static Tensor
      mean_at(const int point, const std::array<const Tensor *, power(2, dim)> &children)
      {
        Tensor sum, inverse_sum;
        double total = 0.;
        for (int part = 0; part < power(2, dim); ++part)
          {
            double weight = 1.;
            int child = 0, point_of_child = 0;
            for (int d = 0, rest = point; d < dim; ++d, rest /= n_points_1d)
              {
                const int fine = 2 * (rest % n_points_1d) + ((part >> d) & 1);
                child += (fine / n_points_1d) << d;
                point_of_child += power(n_points_1d, d) * (fine % n_points_1d);
                weight *= CellStencil<dim>::weights_1d[fine % n_points_1d];
              }
            const Tensor tensor = children[child] == nullptr ? dealii::unit_symmetric_tensor<dim>()
                                                             : children[child][point_of_child];
            sum += weight * tensor;
            inverse_sum += weight * invert(tensor);
            total += weight;
          }
        return 0.5 * (sum / total + total * invert(inverse_sum));
      }

      /** Gives other ranks the tensors of this level on their level ghosts. Collective. */
      void
      exchange(const int level)
      {
        std::map<int, Tensors> &of_level = cells[level];
        dealii::GridTools::exchange_cell_data_to_level_ghosts<Tensors>(
          space.mesh.triangulation(),
          [&of_level](const LevelCell<dim> &cell) {
            const auto found = of_level.find(cell->index());
            return found == of_level.end() ? std::optional<Tensors>()
                                           : std::optional<Tensors>(found->second);
          },
          [&of_level](const LevelCell<dim> &cell, const Tensors &tensors) {
            of_level[cell->index()] = tensors;
          },
          [level](const LevelCell<dim> &cell) { return cell->level() == level; });
      }
    };

    /** The open boundary and the coefficient, for the operator of one level. */
    template <int dim>
    void
    set_jacobian(const EllipticSpace<dim> &space,
                 const OpenBoundary<dim> &boundary,
                 const LevelCoefficient<dim> &coefficient,
                 EllipticOperator<dim, float> &level_operator)
    {
      const auto cell_of = [&](const unsigned int batch, const unsigned int lane) {
        const auto place = level_operator.get_matrix_free()->get_cell_level_and_index(batch, lane);
        return LevelCell<dim>(&space.mesh.triangulation(), place.first, place.second);
      };
      level_operator.set_coefficient([&](const unsigned int batch, const unsigned int lane) {
        return coefficient(cell_of(batch, lane));
      });
      dealii::FullMatrix<double> matrix;
      level_operator.set_boundary_matrices([&](const unsigned int batch, const unsigned int lane) {
        return boundary.element_matrix(cell_of(batch, lane), matrix) ? &matrix : nullptr;
      });
    }
  } // namespace

  template <int dim>
  struct MultigridPreconditioner<dim>::Implementation
  {
    using LevelVector   = dealii::LinearAlgebra::distributed::Vector<float>;
    using LevelOperator = EllipticOperator<dim, float>;
    using Interface     = dealii::MatrixFreeOperators::MGInterfaceOperator<LevelOperator>;
    using Chebyshev     = dealii::PreconditionChebyshev<LevelOperator, LevelVector>;
    using Transfer      = dealii::MGTransferMatrixFree<dim, float>;

    explicit Implementation(const EllipticSpace<dim> &space);

    /** Sets up the operators, one for each level of the mesh. */
    void
    make_level_operators();

    const EllipticSpace<dim> &space;
    dealii::MGConstrainedDoFs constraints;

    dealii::MGLevelObject<LevelOperator> operators;
    dealii::MGLevelObject<Interface> interfaces;

    std::unique_ptr<Transfer> transfer;
    dealii::mg::SmootherRelaxation<Chebyshev, LevelVector> smoother;
    dealii::MGCoarseGridApplySmoother<LevelVector> coarse_solver;
    std::unique_ptr<dealii::mg::Matrix<LevelVector>> matrices, interface_matrices;
    std::unique_ptr<dealii::Multigrid<LevelVector>> multigrid;
    std::unique_ptr<dealii::PreconditionMG<dim, LevelVector, Transfer>> preconditioner;
  };

  template <int dim>
  MultigridPreconditioner<dim>::Implementation::Implementation(const EllipticSpace<dim> &space)
    : space(space)
  {
    constraints.initialize(space.dof_handler);
    make_level_operators();

    transfer = std::make_unique<Transfer>(constraints);
    transfer->build(space.dof_handler);
    coarse_solver.initialize(smoother);
    matrices           = std::make_unique<dealii::mg::Matrix<LevelVector>>(operators);
    interface_matrices = std::make_unique<dealii::mg::Matrix<LevelVector>>(interfaces);
    multigrid          = std::make_unique<dealii::Multigrid<LevelVector>>(
      *matrices, coarse_solver, *transfer, smoother, smoother);
    multigrid->set_edge_matrices(*interface_matrices, *interface_matrices);
    preconditioner = std::make_unique<dealii::PreconditionMG<dim, LevelVector, Transfer>>(
      space.dof_handler, *multigrid, *transfer);
  }

  template <int dim>
  void
  MultigridPreconditioner<dim>::Implementation::make_level_operators()
  {
    const unsigned int n_levels = space.mesh.triangulation().n_global_levels();
    operators.resize(0, n_levels - 1);
    interfaces.resize(0, n_levels - 1);
    for (unsigned int level = 0; level < n_levels; ++level)
      {
        dealii::AffineConstraints<double> no_constraints;
        no_constraints.close();

        typename CellBatches<dim, float>::AdditionalData data;
        data.tasks_parallel_scheme = CellBatches<dim, float>::AdditionalData::none;
        data.mapping_update_flags  = dealii::update_gradients | dealii::update_JxW_values;
        data.mg_level              = level;
        auto cells                 = std::make_shared<CellBatches<dim, float>>();
        cells->reinit(
          space.mapping, space.dof_handler, no_constraints, dealii::QGauss<1>(n_points_1d), data);
        operators[level].initialize_level(cells, constraints, level);
        interfaces[level].initialize(operators[level]);
      }
  }

  template <int dim>
  MultigridPreconditioner<dim>::MultigridPreconditioner(const EllipticSpace<dim> &space)
    : implementation(std::make_unique<Implementation>(space))
  {
  }

  template <int dim>
  MultigridPreconditioner<dim>::~MultigridPreconditioner() = default;

  template <int dim>
  void
  MultigridPreconditioner<dim>::rebuild(const JacobianData<dim> &jacobian)
  {
    auto &operators = implementation->operators;

    const LevelCoefficient<dim> coefficient(implementation->space, jacobian);
    dealii::MGLevelObject<typename Implementation::Chebyshev::AdditionalData> parameters(
      operators.min_level(), operators.max_level());
    for (unsigned int level = operators.min_level(); level <= operators.max_level(); ++level)
      {
        set_jacobian(implementation->space, jacobian.boundary, coefficient, operators[level]);
        operators[level].compute_diagonal();
        parameters[level].preconditioner      = operators[level].get_matrix_diagonal_inverse();
        parameters[level].degree              = 5;
        parameters[level].smoothing_range     = 15.;
        parameters[level].eig_cg_n_iterations = 10;
      }
    // On the root cells Chebyshev is a solver: all of the spectrum, to a relative accuracy of 1e-3.
    parameters[0].degree              = dealii::numbers::invalid_unsigned_int;
    parameters[0].smoothing_range     = 1e-3;
    parameters[0].eig_cg_n_iterations = std::min<unsigned int>(operators[0].m(), 200);
    implementation->smoother.initialize(operators, parameters);
  }

  template <int dim>
  void
  MultigridPreconditioner<dim>::vmult(PotentialVector &dst, const PotentialVector &src) const
  {
    implementation->preconditioner->vmult(dst, src);
  }

  template class MultigridPreconditioner<2>;
  template class MultigridPreconditioner<3>;
} // namespace magmpm
