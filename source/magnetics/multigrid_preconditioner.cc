#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/multigrid/mg_coarse.h>
#include <deal.II/multigrid/mg_matrix.h>
#include <deal.II/multigrid/mg_smoother.h>
#include <deal.II/multigrid/mg_tools.h>
#include <deal.II/multigrid/mg_transfer_matrix_free.h>
#include <deal.II/multigrid/multigrid.h>

#include <magmpm/magnetics/multigrid_preconditioner.h>
#include <magmpm/magnetics/potential_operator.h>

#include <map>
#include <optional>

namespace magmpm
{
  namespace
  {
    template <int dim>
    using LevelCell = typename dealii::Triangulation<dim>::cell_iterator;

    /**
     * I + dM/dH on the cells of all levels: at the points of cells without children, and as the mean
     * over a cell for the others. Cells without an entry are vacuum.
     */
    template <int dim>
    class LevelPermeability
    {
    public:
      using Tensor = dealii::SymmetricTensor<2, dim>;

      LevelPermeability(const PotentialSpace<dim> &space, const JacobianData<dim> &jacobian)
        : space(space)
        , jacobian(jacobian)
        , means(space.mesh.triangulation().n_global_levels())
      {
        average_active_cells();
        for (int level = static_cast<int>(means.size()) - 2; level >= 0; --level)
          {
            exchange(level + 1);
            average_children(level);
          }
      }

      /** The tensors at the points of a cell of this rank, or a null pointer for vacuum. */
      const Tensor *
      operator()(const LevelCell<dim> &cell)
      {
        if (cell->is_active())
          return of_active_cell(cell);
        const auto mean = means[cell->level()].find(cell->index());
        if (mean == means[cell->level()].end())
          return nullptr;
        constant.fill(mean->second);
        return constant.data();
      }

    private:
      const PotentialSpace<dim> &space;
      const JacobianData<dim> &jacobian;
      std::vector<std::map<int, Tensor>> means; ///< by level and cell index
      std::array<Tensor, n_points<dim>> constant;

      /** Of the volume of a cell. */
      static double
      point_fraction(int q)
      {
        double fraction = 1.;
        for (int d = 0; d < dim; ++d, q /= n_points_1d)
          fraction *= 0.5 * CellStencil<dim>::weights_1d[q % n_points_1d];
        return fraction;
      }

      const Tensor *
      of_active_cell(const LevelCell<dim> &cell) const
      {
        return jacobian.permeability(space.lattice_cell_of_active_cell[cell->active_cell_index()]);
      }

      void
      average_active_cells()
      {
        for (const auto &cell : space.mesh.triangulation().active_cell_iterators())
          if (cell->is_locally_owned())
            if (const Tensor *values = of_active_cell(cell))
              {
                Tensor mean;
                for (int q = 0; q < n_points<dim>; ++q)
                  mean += point_fraction(q) * values[q];
                means[cell->level()][cell->index()] = mean;
              }
      }

      void
      average_children(const int level)
      {
        for (const auto &cell : space.mesh.triangulation().cell_iterators_on_level(level))
          if (cell->has_children() && cell->is_locally_owned_on_level())
            {
              Tensor mean;
              bool has_material = false;
              for (unsigned int c = 0; c < cell->n_children(); ++c)
                {
                  const auto found     = means[level + 1].find(cell->child(c)->index());
                  const bool is_vacuum = found == means[level + 1].end();
                  has_material         = has_material || !is_vacuum;
                  mean += (is_vacuum ? dealii::unit_symmetric_tensor<dim>() : found->second) /
                          cell->n_children();
                }
              if (has_material)
                means[level][cell->index()] = mean;
            }
      }

      /** Gives other ranks the means of this level on their level ghosts. Collective. */
      void
      exchange(const int level)
      {
        std::map<int, Tensor> &of_level = means[level];
        dealii::GridTools::exchange_cell_data_to_level_ghosts<Tensor>(
          space.mesh.triangulation(),
          [&of_level](const LevelCell<dim> &cell) {
            const auto found = of_level.find(cell->index());
            return found == of_level.end() ? std::optional<Tensor>()
                                           : std::optional<Tensor>(found->second);
          },
          [&of_level](const LevelCell<dim> &cell, const Tensor &mean) {
            of_level[cell->index()] = mean;
          },
          [level](const LevelCell<dim> &cell) { return cell->level() == level; });
      }
    };

    /** The open boundary and the permeability, for the operator of one level. */
    template <int dim>
    void
    set_jacobian(const PotentialSpace<dim> &space,
                 const OpenBoundary<dim> &boundary,
                 LevelPermeability<dim> &permeability,
                 PotentialOperator<dim, float> &level_operator)
    {
      const auto cell_of = [&](const unsigned int batch, const unsigned int lane) {
        const auto place = level_operator.get_matrix_free()->get_cell_level_and_index(batch, lane);
        return LevelCell<dim>(&space.mesh.triangulation(), place.first, place.second);
      };
      level_operator.set_permeability([&](const unsigned int batch, const unsigned int lane) {
        return permeability(cell_of(batch, lane));
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
    using LevelOperator = PotentialOperator<dim, float>;
    using Interface     = dealii::MatrixFreeOperators::MGInterfaceOperator<LevelOperator>;
    using Chebyshev     = dealii::PreconditionChebyshev<LevelOperator, LevelVector>;
    using Transfer      = dealii::MGTransferMatrixFree<dim, float>;

    explicit Implementation(const PotentialSpace<dim> &space);

    /** Sets up the operators, one for each level of the mesh. */
    void
    make_level_operators();

    const PotentialSpace<dim> &space;
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
  MultigridPreconditioner<dim>::Implementation::Implementation(const PotentialSpace<dim> &space)
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
  MultigridPreconditioner<dim>::MultigridPreconditioner(const PotentialSpace<dim> &space)
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

    LevelPermeability<dim> permeability(implementation->space, jacobian);
    dealii::MGLevelObject<typename Implementation::Chebyshev::AdditionalData> parameters(
      operators.min_level(), operators.max_level());
    for (unsigned int level = operators.min_level(); level <= operators.max_level(); ++level)
      {
        set_jacobian(implementation->space, jacobian.boundary, permeability, operators[level]);
        operators[level].compute_diagonal();
        parameters[level].preconditioner      = operators[level].get_matrix_diagonal_inverse();
        parameters[level].degree              = 4;
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
