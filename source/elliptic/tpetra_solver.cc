#include <magmpm/base/exceptions.h>
#include <magmpm/elliptic/tpetra_solver.h>

#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <MueLu_TpetraOperator.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>

#include <algorithm>
#include <string>

namespace magmpm
{
  namespace
  {
    using GlobalIndex  = TpetraSolver::GlobalIndex;
    using LocalIndex   = Tpetra::Map<>::local_ordinal_type;
    using Node         = Tpetra::Map<>::node_type;
    using Map          = Tpetra::Map<LocalIndex, GlobalIndex, Node>;
    using Graph        = Tpetra::CrsGraph<LocalIndex, GlobalIndex, Node>;
    using Matrix       = Tpetra::CrsMatrix<double, LocalIndex, GlobalIndex, Node>;
    using MultiVector  = Tpetra::MultiVector<double, LocalIndex, GlobalIndex, Node>;
    using Operator     = Tpetra::Operator<double, LocalIndex, GlobalIndex, Node>;
    using Hierarchy    = MueLu::TpetraOperator<double, LocalIndex, GlobalIndex, Node>;
    using LinearSystem = Belos::LinearProblem<double, MultiVector, Operator>;
    using Teuchos::RCP;
    using Teuchos::rcp;

    int
    finalize_kokkos(MPI_Comm, int, void *guard, void *)
    {
      delete static_cast<Tpetra::ScopeGuard *>(guard);
      return MPI_SUCCESS;
    }

    /**
     * Starts Kokkos once, unless somebody has. It has to end before MPI does, and MPI_Finalize() first
     * of all deletes the attributes of MPI_COMM_SELF.
     */
    void
    start_kokkos()
    {
      if (Kokkos::is_initialized())
        return;
      int n_arguments  = 0;
      char **arguments = nullptr;
      int key          = MPI_KEYVAL_INVALID;
      MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, finalize_kokkos, &key, nullptr);
      MPI_Comm_set_attr(MPI_COMM_SELF, key, new Tpetra::ScopeGuard(&n_arguments, &arguments));
      MPI_Comm_free_keyval(&key);
    }

    /** The first line of a message from Trilinos, which may have many. */
    std::string
    first_words(const std::exception &error)
    {
      const std::string text = error.what();
      const auto start       = std::min(text.find_first_not_of(" \n"), text.size());
      return text.substr(start, text.find('\n', start) - start);
    }

    Teuchos::ParameterList
    hierarchy_parameters()
    {
      Teuchos::ParameterList parameters;
      parameters.set("verbosity", "none");
      parameters.set("multigrid algorithm", "sa");
      parameters.set("problem: symmetric", true);
      parameters.set("number of equations", 1);
      parameters.set("max levels", 10);
      parameters.set("coarse: max size", 100);

      // The power method starts at random and stays below the largest eigenvalue. With MueLu's own 10
      // steps it can stay so far below that the smoother diverges and CG breaks down.
      parameters.set("smoother: type", "CHEBYSHEV");
      Teuchos::ParameterList &smoother = parameters.sublist("smoother: params");
      smoother.set("chebyshev: degree", 4);
      smoother.set("chebyshev: ratio eigenvalue", 20.);
      smoother.set("chebyshev: min eigenvalue", 1.);
      smoother.set("chebyshev: zero starting solution", true);
      smoother.set("chebyshev: eigenvalue max iterations", 40);
      smoother.set("chebyshev: boost factor", 1.2);

      // On the few rows of the coarsest level Chebyshev is a solver. MueLu's direct one (KLU2 of
      // Amesos2) is not symmetric on two ranks with Debian's Trilinos 13.2, and CG then stagnates.
      parameters.set("coarse: type", "CHEBYSHEV");
      Teuchos::ParameterList &coarse = parameters.sublist("coarse: params");
      coarse.setParameters(smoother);
      coarse.set("chebyshev: degree", 60);
      coarse.set("chebyshev: ratio eigenvalue", 1000.);
      return parameters;
    }
  } // namespace

  struct TpetraSolver::Implementation
  {
    std::size_t n_rows = 0; ///< of this rank
    RCP<Matrix> matrix;
    RCP<Hierarchy> hierarchy;
    RCP<MultiVector> right_hand_side, solution;
  };

  TpetraSolver::TpetraSolver(const MPI_Comm communicator,
                             const std::vector<std::size_t> &row_starts,
                             const std::vector<GlobalIndex> &columns)
  {
    start_kokkos();
    implementation = std::make_unique<Implementation>();

    const std::size_t n_rows = row_starts.size() - 1;
    const auto all           = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
    const RCP<const Map> map =
      rcp(new Map(all, n_rows, 0, rcp(new Teuchos::MpiComm<int>(communicator))));

    std::vector<std::size_t> lengths(n_rows);
    for (std::size_t row = 0; row < n_rows; ++row)
      lengths[row] = row_starts[row + 1] - row_starts[row];
    const RCP<Graph> graph =
      rcp(new Graph(map, Teuchos::ArrayView<const std::size_t>(lengths.data(), n_rows)));
    for (std::size_t row = 0; row < n_rows; ++row)
      graph->insertGlobalIndices(map->getGlobalElement(static_cast<LocalIndex>(row)),
                                 static_cast<LocalIndex>(lengths[row]),
                                 &columns[row_starts[row]]);
    graph->fillComplete();

    implementation->n_rows          = n_rows;
    implementation->matrix          = rcp(new Matrix(graph));
    implementation->right_hand_side = rcp(new MultiVector(map, 1));
    implementation->solution        = rcp(new MultiVector(map, 1));
    implementation->matrix->fillComplete();
  }

  TpetraSolver::~TpetraSolver() = default;

  void
  TpetraSolver::start_assembly()
  {
    implementation->matrix->resumeFill();
    implementation->matrix->setAllToScalar(0.);
  }

  void
  TpetraSolver::add(const GlobalIndex row,
                    const int n,
                    const GlobalIndex *columns,
                    const double *values)
  {
    implementation->matrix->sumIntoGlobalValues(row, n, values, columns);
  }

  void
  TpetraSolver::finish_assembly()
  {
    implementation->matrix->fillComplete();
  }

  void
  TpetraSolver::rebuild_hierarchy()
  {
    implementation->hierarchy       = Teuchos::null;
    Teuchos::ParameterList settings = hierarchy_parameters();
    const RCP<Operator> copy        = rcp(new Matrix(*implementation->matrix, Teuchos::Copy));
    try
      {
        implementation->hierarchy =
          MueLu::CreateTpetraPreconditioner<double, LocalIndex, GlobalIndex, Node>(copy, settings);
      }
    catch (const std::exception &error)
      {
        throw RunError("MueLu could not set up smoothed aggregation for the magnetic potential: " +
                       first_words(error) + "\nChoose another preconditioner.");
      }
  }

  LinearSolveResult
  TpetraSolver::solve(const double *right_hand_side,
                      const double tolerance,
                      const int max_iterations,
                      double *solution) const
  {
    Implementation &data = *implementation;
    std::copy_n(right_hand_side, data.n_rows, data.right_hand_side->getDataNonConst(0).begin());
    data.solution->putScalar(0.);

    const RCP<LinearSystem> system =
      rcp(new LinearSystem(data.matrix, data.solution, data.right_hand_side));
    system->setLeftPrec(data.hierarchy);
    system->setProblem();

    const RCP<Teuchos::ParameterList> settings = Teuchos::parameterList();
    settings->set("Convergence Tolerance", tolerance);
    settings->set("Residual Scaling", "None");
    settings->set("Maximum Iterations", max_iterations);
    settings->set("Verbosity", static_cast<int>(Belos::Errors));
    Belos::PseudoBlockCGSolMgr<double, MultiVector, Operator> cg(system, settings);
    try
      {
        if (cg.solve() != Belos::Converged)
          return LinearSolveResult::unsolved_in(cg.getNumIters());
      }
    catch (const std::exception &error)
      {
        return {cg.getNumIters(), "by Belos' CG, which stopped: " + first_words(error)};
      }
    std::copy_n(data.solution->getData(0).begin(), data.n_rows, solution);
    return {cg.getNumIters(), ""};
  }
} // namespace magmpm
