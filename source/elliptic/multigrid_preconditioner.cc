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
     * The coefficient of the cells of all levels. An octant of a cell with children is one of these, and
     * has half the arithmetic and half the harmonic mean of that child's K: surfaces stay where they are on
     * all levels, which one mean for a whole cell would blur. Of stabilization it has the least of its
     * children. Cells without an entry are vacuum.
     */
    template <int dim>
    class LevelCoefficient
    {
    public:
      LevelCoefficient(const EllipticSpace<dim> &space, const JacobianData<dim> &jacobian)
        : space(space)
        , cells(space.mesh.triangulation().n_global_levels())
      {
        for (const auto &cell : space.mesh.triangulation().active_cell_iterators())
          if (cell->is_locally_owned())
            if (const CellCoefficient<dim> *of_cell = jacobian.coefficient(
                  space.lattice_cell_of_active_cell[cell->active_cell_index()]))
              cells[cell->level()][cell->index()] = *of_cell;
        for (int level = static_cast<int>(cells.size()) - 2; level >= 0; --level)
          {
            exchange(level + 1);
            average_children(level);
          }
      }

      /** That of a cell of this rank, or a null pointer for vacuum. */
      const CellCoefficient<dim> *
      operator()(const LevelCell<dim> &cell) const
      {
        const auto found = cells[cell->level()].find(cell->index());
        return found == cells[cell->level()].end() ? nullptr : &found->second;
      }

    private:
      using Tensor = dealii::SymmetricTensor<2, dim>;

      const EllipticSpace<dim> &space;
      std::vector<std::map<int, CellCoefficient<dim>>> cells; ///< by level and cell index

      void
      average_children(const int level)
      {
        const CellCoefficient<dim> vacuum = {};
        for (const auto &cell : space.mesh.triangulation().cell_iterators_on_level(level))
          if (cell->has_children() && cell->is_locally_owned_on_level())
            {
              bool is_vacuum = true;
              std::array<const CellCoefficient<dim> *, n_octants<dim>> children;
              for (unsigned int c = 0; c < children.size(); ++c)
                {
                  children[c] = (*this)(cell->child(c));
                  is_vacuum   = is_vacuum && children[c] == nullptr;
                  children[c] = children[c] == nullptr ? &vacuum : children[c];
                }
              if (!is_vacuum)
                cells[level][cell->index()] = parent(children);
            }
      }

      static CellCoefficient<dim>
      parent(const std::array<const CellCoefficient<dim> *, n_octants<dim>> &children)
      {
        CellCoefficient<dim> result;
        result.whole = children[0]->whole;
        for (const CellCoefficient<dim> *child : children)
          result.whole = std::min(result.whole, child->whole);
        for (unsigned int c = 0; c < children.size(); ++c)
          result.octants[c] = mean(*children[c]) -
                              result.whole * dealii::unit_symmetric_tensor<dim>();
        return result;
      }

      /** Of K in a cell. */
      static Tensor
      mean(const CellCoefficient<dim> &coefficient)
      {
        constexpr double weight = 1. / n_octants<dim>;
        Tensor arithmetic, inverse;
        for (const Tensor &octant : coefficient.octants)
          {
            const Tensor k = coefficient.whole * dealii::unit_symmetric_tensor<dim>() + octant;
            arithmetic += weight * k;
            inverse += weight * invert(k);
          }
        return 0.5 * (arithmetic + invert(inverse));
      }

      /** Gives other ranks the coefficients of this level on their level ghosts. Collective. */
      void
      exchange(const int level)
      {
        using Coefficient                    = CellCoefficient<dim>;
        std::map<int, Coefficient> &of_level = cells[level];
        dealii::GridTools::exchange_cell_data_to_level_ghosts<Coefficient>(
          space.mesh.triangulation(),
          [&of_level](const LevelCell<dim> &cell) {
            const auto found = of_level.find(cell->index());
            return found == of_level.end() ? std::optional<Coefficient>()
                                           : std::optional<Coefficient>(found->second);
          },
          [&of_level](const LevelCell<dim> &cell, const Coefficient &coefficient) {
            of_level[cell->index()] = coefficient;
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

        const auto cells =
          make_cell_batches<dim, float>(space.mapping, space.dof_handler, no_constraints, level);
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
