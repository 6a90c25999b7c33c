// The definitions of AffineConstraints are needed here, as it does not know TpetraMatrix.
#include <deal.II/lac/affine_constraints.templates.h>

#include <magmpm/elliptic/muelu_solver.h>

namespace magmpm
{
  namespace
  {
    /**
     * The matrix of a TpetraSolver as AffineConstraints::distribute_local_to_global() sees one; it
     * asks by dynamic_cast whether that is one of deal.II's own, hence virtual.
     */
    class TpetraMatrix
    {
    public:
      using value_type = double;
      using size_type  = dealii::types::global_dof_index;

      TpetraMatrix(TpetraSolver &solver, const size_type size)
        : solver(solver)
        , size(size)
      {
      }

      virtual ~TpetraMatrix() = default;

      size_type
      m() const
      {
        return size;
      }

      size_type
      n() const
      {
        return size;
      }

      void
      add(const size_type row,
          const size_type n,
          const size_type *columns,
          const double *values,
          const bool /* leave zeros out */,
          const bool /* columns are sorted */)
      {
        global_columns.assign(columns, columns + n);
        solver.add(row, static_cast<int>(n), global_columns.data(), values);
      }

      void
      add(const size_type row, const size_type column, const double value)
      {
        add(row, 1, &column, &value, false, true);
      }

    private:
      TpetraSolver &solver;
      const size_type size;
      std::vector<TpetraSolver::GlobalIndex> global_columns;
    };
  } // namespace

  template <int dim>
  MueLuSolver<dim>::MueLuSolver(const EllipticSpace<dim> &space)
    : assembler(space)
  {
    const dealii::DynamicSparsityPattern pattern = assembler.sparsity_pattern();
    std::vector<std::size_t> row_starts          = {0};
    std::vector<TpetraSolver::GlobalIndex> columns;
    for (const auto row : space.dof_handler.locally_owned_dofs())
      {
        for (unsigned int i = 0; i < pattern.row_length(row); ++i)
          columns.push_back(pattern.column_number(row, i));
        row_starts.push_back(columns.size());
      }
    solver = std::make_unique<TpetraSolver>(space.mesh.communicator(), row_starts, columns);
  }

  template <int dim>
  void
  MueLuSolver<dim>::update(const JacobianData<dim> &jacobian)
  {
    TpetraMatrix matrix(*solver, assembler.n_rows());
    solver->start_assembly();
    assembler.add_to(jacobian, matrix);
    solver->finish_assembly();
  }

  template <int dim>
  void
  MueLuSolver<dim>::rebuild(const JacobianData<dim> &)
  {
    solver->rebuild_hierarchy();
  }

  template <int dim>
  LinearSolveResult
  MueLuSolver<dim>::solve(const EllipticOperator<dim, double> &,
                          const PotentialVector &right_hand_side,
                          const double tolerance,
                          const int max_iterations,
                          PotentialVector &x)
  {
    x = 0.; // ghosts too
    return solver->solve(right_hand_side.begin(), tolerance, max_iterations, x.begin());
  }

  template class MueLuSolver<2>;
  template class MueLuSolver<3>;
} // namespace magmpm
