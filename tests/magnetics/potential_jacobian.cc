#include "catch.h"

#include <magmpm/elliptic/elliptic_residual.h>
#include <magmpm/elliptic/ml_preconditioner.h>
#include <magmpm/parallel/reduce.h>

#include <verification/magnetostatics/sampled_setup.h>
#include <verification/magnetostatics/sources.h>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** A strongly magnetized sphere on an adaptive mesh with hanging nodes, and a potential to test at. */
  template <int dim>
  class JacobianTest
  {
  public:
    explicit JacobianTest(const MagnetizationLaw law)
      : scene(16, spacing, 2., {})
      , sources({uniform_source<dim>(uniform_field())})
      , material(scene.mesh, scene.partition, with_law(law))
    {
      Vector<dim> centre;
      for (int d = 0; d < dim; ++d)
        centre[d] = spacing * (8.3 + 0.2 * d);
      scene.set_bodies({sphere<dim>(centre, 3. * spacing, {9e4, 3.})});
      space = std::make_unique<EllipticSpace<dim>>(scene.mesh, true);
      material.reinit(space->lattice_cells, scene.content, sources);
      boundary = std::make_unique<OpenBoundary<dim>>(*space, std::array<bool, 2 * dim>{}, centre);

      jacobian.initialize(space->matrix_free);
      dealii::FullMatrix<double> matrix;
      jacobian.set_boundary_matrices([&](const unsigned int batch, const unsigned int lane) {
        const auto cell = space->matrix_free->get_cell_iterator(batch, lane);
        return boundary->element_matrix(cell, matrix) ? &matrix : nullptr;
      });
    }

    static MagneticsParameters<dim>
    with_law(const MagnetizationLaw law)
    {
      MagneticsParameters<dim> parameters;
      parameters.law = law;
      return parameters;
    }

    /** A vector of numbers of order one that does not depend on the number of ranks. */
    PotentialVector
    arbitrary(const double phase) const
    {
      PotentialVector vector = space->make_vector();
      for (const auto i : vector.locally_owned_elements())
        vector(i) = std::sin(phase + 1.7 * static_cast<double>(i));
      space->constraints.set_zero(vector);
      return vector;
    }

    /** F(phi); the Jacobian is then that at phi. */
    PotentialVector
    linearize(const PotentialVector &potential)
    {
      PotentialVector result = space->make_vector();
      residual.evaluate(*space, material, MediumResponse::full, jacobian, potential, result);
      jacobian.set_coefficient([&](const unsigned int batch, const unsigned int lane) {
        return residual.coefficient(space->lattice_cell(batch, lane));
      });
      return result;
    }

    /** Batches of cells of which some lanes hold material and some do not, on all ranks. */
    unsigned int
    n_mixed_batches() const
    {
      const auto &cells = *space->matrix_free;
      unsigned int n    = 0;
      for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
        {
          const unsigned int n_lanes = cells.n_active_entries_per_cell_batch(batch);
          unsigned int n_material    = 0;
          for (unsigned int lane = 0; lane < n_lanes; ++lane)
            n_material += residual.coefficient(space->lattice_cell(batch, lane)) != nullptr;
          n += n_material > 0 && n_material < n_lanes;
        }
      return parallel::sum(n, MPI_COMM_WORLD);
    }

    static Vector<dim>
    uniform_field()
    {
      Vector<dim> field;
      field[0]       = 2e4;
      field[dim - 1] = 5e4;
      return field;
    }

    static constexpr double spacing = 0.01;
    SampledSetup<dim> scene;
    ExternalField<dim> sources;
    std::unique_ptr<EllipticSpace<dim>> space;
    MaterialPoints<dim> material;
    std::unique_ptr<OpenBoundary<dim>> boundary;
    EllipticOperator<dim, double> jacobian;
    EllipticResidual<dim> residual;
  };

  /** Of the test potentials [A]: fields of order H_ext. */
  constexpr double amplitude = 100.;
} // namespace

// The matrix-free Jacobian times a vector is the assembled matrix times it. The two share nothing but
// the tensors at the quadrature points and the element matrices of the boundary.
TEMPLATE_TEST_CASE_SIG("The matrix-free Jacobian is the assembled matrix",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  JacobianTest<dim> test(MagnetizationLaw::langevin);
  PotentialVector potential = test.arbitrary(0.);
  potential *= amplitude;
  test.linearize(potential);

  // What SIMD lanes can get wrong is there: lanes that differ, and hanging nodes.
  CHECK(test.n_mixed_batches() >= (CellLanes<double>::size() > 1 ? 1 : 0));
  CHECK(parallel::sum(test.space->constraints.n_constraints(), MPI_COMM_WORLD) > 0);

  MLPreconditioner<dim> assembled(*test.space);
  assembled.rebuild(
    {[&](const unsigned int cell) { return test.residual.coefficient(cell); }, *test.boundary});

  const PotentialVector x = test.arbitrary(0.3), y = test.arbitrary(2.);
  PotentialVector matrix_free(x), with_matrix(x);
  test.jacobian.vmult(matrix_free, x);
  assembled.matrix().vmult(with_matrix, x);
  test.space->constraints.set_zero(with_matrix);
  const double norm = matrix_free.l2_norm();
  CHECK(y * matrix_free == Approx(y * with_matrix).epsilon(1e-12));
  with_matrix -= matrix_free;
  CHECK(with_matrix.l2_norm() < 1e-13 * norm);

  // Symmetric and positive definite, as CG needs it.
  PotentialVector transposed(x);
  test.jacobian.vmult(transposed, y);
  CHECK(x * transposed == Approx(y * matrix_free).epsilon(1e-12));
  CHECK(x * matrix_free > 0.);
}

// The Jacobian is the derivative of the residual, the residual that of the energy: central differences
// agree to second order in their step.
TEMPLATE_TEST_CASE_SIG("Jacobian, residual and energy belong together",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  JacobianTest<dim> test(MagnetizationLaw::langevin);
  PotentialVector potential = test.arbitrary(0.);
  potential *= amplitude;
  const PotentialVector direction = test.arbitrary(0.9);
  const double step               = 1e-4 * amplitude;

  PotentialVector shifted(potential);
  shifted.add(step, direction);
  PotentialVector difference = test.linearize(shifted);
  const double energy_above  = test.residual.functional();
  shifted.add(-2. * step, direction);
  difference -= test.linearize(shifted);
  const double energy_below = test.residual.functional();
  difference /= 2. * step;

  const PotentialVector residual = test.linearize(potential);
  PotentialVector product(potential);
  test.jacobian.vmult(product, direction);
  const double norm = product.l2_norm();
  product -= difference;
  CHECK(product.l2_norm() < 1e-6 * norm);
  CHECK((energy_above - energy_below) / (2. * step) == Approx(residual * direction).epsilon(1e-6));
}

// The diagonal that smoothers use is that of the assembled matrix, at the boundary and beside hanging
// nodes too.
TEMPLATE_TEST_CASE_SIG("The matrix-free diagonal is that of the matrix",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  JacobianTest<dim> test(MagnetizationLaw::langevin);
  test.linearize(test.arbitrary(0.));
  test.jacobian.compute_diagonal();
  MLPreconditioner<dim> assembled(*test.space);
  assembled.rebuild(
    {[&](const unsigned int cell) { return test.residual.coefficient(cell); }, *test.boundary});
  const auto &inverse = test.jacobian.get_matrix_diagonal_inverse()->get_vector();
  double error        = 0.;
  for (const auto i : inverse.locally_owned_elements())
    if (!test.space->constraints.is_constrained(i))
      error = std::max(error, std::abs(inverse(i) * assembled.matrix().diag_element(i) - 1.));
  CHECK(parallel::max(error, MPI_COMM_WORLD) < 1e-12);
}

namespace
{
  /** The operator of one level, with arbitrary coefficients on every third cell. */
  template <int dim>
  void
  set_up_level(const JacobianTest<dim> &test,
               const dealii::MGConstrainedDoFs &constraints,
               const unsigned int level,
               EllipticOperator<dim, double> &level_operator)
  {
    dealii::AffineConstraints<double> no_constraints;
    no_constraints.close();
    const auto cells = make_cell_batches<dim, double>(
      test.space->mapping, test.space->dof_handler, no_constraints, level);
    level_operator.initialize_level(cells, constraints, level);

    CellCoefficient<dim> values;
    level_operator.set_coefficient(
      [&](const unsigned int batch, const unsigned int lane) -> const CellCoefficient<dim> * {
        const auto cell = cells->get_cell_iterator(batch, lane);
        if (cell->index() % 3 != 0)
          return nullptr;
        values.whole = 1.3;
        for (int q = 0; q < n_octants<dim>; ++q)
          for (int i = 0; i < dim; ++i)
            for (int j = 0; j <= i; ++j)
              values.octants[q][i][j] = (i == j ? 3. : 0.) +
                                        std::sin(q + 2. * i + j + cell->center()[0]);
        return &values;
      });
    dealii::FullMatrix<double> matrix;
    level_operator.set_boundary_matrices([&](const unsigned int batch, const unsigned int lane) {
      return test.boundary->element_matrix(cells->get_cell_iterator(batch, lane), matrix) ? &matrix
                                                                                          : nullptr;
    });
  }
} // namespace

// On the levels of multigrid the diagonal is that of the operator, found by applying it to unit vectors;
// and the operators at the edge of a level are those of a loop over all of its cells.
TEMPLATE_TEST_CASE_SIG("Diagonal and edge of a level are those of its operator",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const JacobianTest<dim> test(MagnetizationLaw::langevin);
  dealii::MGConstrainedDoFs constraints;
  constraints.initialize(test.space->dof_handler);
  bool has_edge = false;
  for (unsigned int level = 0; level < test.scene.mesh.triangulation().n_global_levels(); ++level)
    {
      CAPTURE(level);
      EllipticOperator<dim, double> level_operator;
      set_up_level(test, constraints, level, level_operator);
      level_operator.compute_diagonal();
      const auto &inverse = level_operator.get_matrix_diagonal_inverse()->get_vector();
      PotentialVector unit, product;
      unit.reinit(inverse);
      product.reinit(inverse);
      double error = 0.;
      for (dealii::types::global_dof_index i = 0; i < unit.size(); i += 1 + unit.size() / 200)
        {
          const bool is_mine = unit.in_local_range(i);
          unit               = 0.;
          if (is_mine)
            unit(i) = 1.;
          level_operator.vmult(product, unit);
          if (is_mine)
            error = std::max(error, std::abs(product(i) * inverse(i) - 1.));
        }
      CHECK(parallel::max(error, MPI_COMM_WORLD) < 1e-13);

      using Base = dealii::MatrixFreeOperators::Base<dim, PotentialVector, CellLanes<double>>;
      PotentialVector of_all_cells(product);
      for (const auto i : unit.locally_owned_elements())
        unit(i) = std::sin(1. + 1.3 * static_cast<double>(i));
      level_operator.vmult_interface_down(product, unit);
      level_operator.Base::vmult_interface_down(of_all_cells, unit);
      has_edge = has_edge || of_all_cells.l2_norm() > 0.;
      of_all_cells -= product;
      CHECK(of_all_cells.linfty_norm() < 1e-13);
      level_operator.vmult_interface_up(product, unit);
      level_operator.Base::vmult_interface_up(of_all_cells, unit);
      of_all_cells -= product;
      CHECK(of_all_cells.linfty_norm() < 1e-13);
    }
  CHECK(has_edge);
}
