#include "catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/parallel/reduce.h>

#include <verification/magnetostatics/sampled_setup.h>
#include <verification/magnetostatics/sources.h>
#include <verification/print_once.h>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr double spacing = 1. / 128.; ///< dx [m], the paper's
  constexpr double k2      = 3.31e-5;   ///< mu_0 m/(k_B T) of the paper's grains [m/A]

  MagneticContent
  grains(const double susceptibility)
  {
    return {3. * susceptibility / k2, susceptibility};
  }

  /** H in a sphere (3D) or cylinder (2D) in a uniform field: H + M(H)/dim = H_0, by bisection. */
  template <int dim>
  double
  exact_field(const MagnetizationLaw law, const MagneticContent &material, const double outer_field)
  {
    double below = 0., above = outer_field;
    for (int i = 0; i < 100; ++i)
      {
        Vector<dim> field;
        field[0]            = 0.5 * (below + above);
        const double excess = field[0] + magnetization<dim>(law, material, field)[0] / dim;
        (excess > outer_field ? above : below) = field[0];
      }
    return below;
  }

  /** One sphere in a uniform field along the last axis. */
  template <int dim>
  class SphereInField
  {
  public:
    SphereInField(const int n_cells,
                  const double radius_in_cells,
                  const MagneticContent &material,
                  const double outer_field,
                  const MagneticsParameters<dim> &parameters,
                  const double box_factor                  = 2.,
                  const std::array<bool, 2 *dim> &shielded = {},
                  const int cell_edge                      = 2)
      : scene(n_cells, spacing, box_factor, parameters, shielded, cell_edge)
      , outer_field(outer_field)
    {
      for (int d = 0; d < dim; ++d)
        centre[d] = spacing * (0.5 * n_cells + 0.13 * (d + 1));
      radius = spacing * radius_in_cells;
      scene.set_bodies({sphere<dim>(centre, radius, material)});
      Vector<dim> field;
      field[dim - 1] = outer_field;
      report = scene.problem.solve(scene.content, ExternalField<dim>({uniform_source<dim>(field)}));
    }

    /** Mean of H along the outer field in the inner half of the sphere. */
    double
    inner_field() const
    {
      NodeField<dim, SingleVector> field;
      scene.problem.compute_field(field);
      double sum = 0., count = 0.;
      scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
        if (norm(x - centre) < 0.5 * radius)
          {
            sum += field.get(SingleVector::value, slot, node)[dim - 1];
            count += 1.;
          }
      });
      return parallel::sum(sum, MPI_COMM_WORLD) / parallel::sum(count, MPI_COMM_WORLD);
    }

    /** Dipole moment over the exact one, linear law: U = -mu_0/2 m.H_0. */
    double
    relative_moment(const double susceptibility) const
    {
      const double volume = (dim == 3 ? 4. / 3. * constants::pi * std::pow(radius, 3)
                                      : constants::pi * radius * radius);
      const double exact  = volume * susceptibility / (1. + susceptibility / dim) * outer_field;
      return -2. * report.energy / (constants::vacuum_permeability * outer_field) / exact;
    }

    SampledSetup<dim> scene;
    double outer_field, radius;
    Vector<dim> centre;
    SolveReport report;
  };

  template <int dim>
  MagneticsParameters<dim>
  with_law(const MagnetizationLaw law)
  {
    MagneticsParameters<dim> parameters;
    parameters.law = law;
    return parameters;
  }
} // namespace

// H inside a sphere and a cylinder of radius 8 dx in a uniform field, exact values H + M(H)/dim = H_0.
// With the smeared indicator they come out 0.6 % (3D) and 0.5 % (2D) too large for the Langevin law at
// the paper's values, 1.2 % for the linear one; the sharp surface makes them
// 0.09 to 0.14 % too small, since cells with a surface are magnetized a little more than those inside.
TEMPLATE_TEST_CASE_SIG("The field in a magnetized sphere is right",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const double outer_field = 1e5;
  for (const MagnetizationLaw law : {MagnetizationLaw::langevin, MagnetizationLaw::linear})
    {
      const SphereInField<dim> test(32, 8., grains(0.91), outer_field, with_law<dim>(law));
      const double error = test.inner_field() / exact_field<dim>(law, grains(0.91), outer_field) -
                           1.;
      print_once("field in a %s, R = 8 dx, %dD: error %.2e",
                 law == MagnetizationLaw::linear ? "linear sphere" : "Langevin sphere",
                 dim,
                 error);
      CHECK(std::abs(error) < 1.6e-3);
    }
}

// The dipole moment of a linear sphere. The smeared indicator, a body's edge twice smoothed by
// B-splines, makes it too large by 0.35 dx/R at chi_0 = 0.91, in first order; the sharp one by less
// than 6e-3 at R = 8 dx, and cells of dx by a quarter of that.
TEMPLATE_TEST_CASE_SIG("The moment of a sphere converges", "[magnetics]", ((int dim), dim), 2, 3)
{
  const auto excess =
    [](const double radius, const MaterialIndicator indicator, const int cell_edge) {
      MagneticsParameters<dim> parameters = with_law<dim>(MagnetizationLaw::linear);
      parameters.indicator                = indicator;
      const SphereInField<dim> test(32, radius, grains(0.91), 1e5, parameters, 2., {}, cell_edge);
      return test.relative_moment(0.91) - 1.;
    };
  const double coarse = excess(4., MaterialIndicator::smeared, 2);
  const double fine   = excess(8., MaterialIndicator::smeared, 2);
  const double sharp  = excess(8., MaterialIndicator::sharp, 2);
  const double finer  = excess(8., MaterialIndicator::sharp, 1);
  print_once("moment of a linear sphere, %dD: error %.2e (R = 4 dx), %.2e (8 dx); sharp %.2e, with "
             "cells of dx %.2e",
             dim,
             coarse,
             fine,
             sharp,
             finer);
  CHECK(coarse / fine == Approx(2.).epsilon(0.1));
  CHECK(8. * fine == Approx(0.35).epsilon(0.1));
  CHECK(std::abs(sharp) < 6e-3);
  CHECK(std::abs(finer) < 1.5e-3);
}

// Large susceptibilities, linear and saturated, converge with few iterations, and H goes to zero inside
// as 1/chi_0 would have it: the sphere shields itself. The smeared interface costs accuracy there.
TEST_CASE("Large susceptibilities converge", "[magnetics]")
{
  for (const double chi : {10., 100.})
    {
      const SphereInField<3> linear(
        32, 8., grains(chi), 1e5, with_law<3>(MagnetizationLaw::linear));
      const SphereInField<3> saturated(
        32, 8., grains(chi), 9e5, with_law<3>(MagnetizationLaw::langevin));
      print_once(
        "chi_0 = %g: linear CG %d, error of H %.2f, of the moment %.2f; saturated Newton %d, line "
        "search %d, CG %d",
        chi,
        linear.report.newton.linear_iterations,
        linear.inner_field() / exact_field<3>(MagnetizationLaw::linear, grains(chi), 1e5) - 1.,
        linear.relative_moment(chi) - 1.,
        saturated.report.newton.steps,
        saturated.report.newton.line_search_steps,
        saturated.report.newton.linear_iterations);
      CHECK(linear.report.newton.steps == 1);
      CHECK(linear.report.newton.linear_iterations <= 20);
      CHECK(linear.inner_field() < 1.6 * 1e5 / (1. + chi / 3.));
      CHECK(saturated.report.newton.steps <= 12);
      CHECK(saturated.report.relative_final_residual() <= 1e-10);
    }
}

// A potential box twice as large as the walls gives the energy of one eight times as large: the open
// boundary is exact for the dipole, and the next field of a sphere is zero. Shielded, the box shows.
TEMPLATE_TEST_CASE_SIG("Open faces are far away", "[magnetics][mpi]", ((int dim), dim), 2, 3)
{
  const auto energy = [](const double factor, const bool is_shielded) {
    std::array<bool, 2 * dim> shielded;
    shielded.fill(is_shielded);
    const SphereInField<dim> test(
      24, 8., grains(0.91), 1e5, with_law<dim>(MagnetizationLaw::linear), factor, shielded);
    return test.report.energy;
  };
  const double far = energy(8., false), near = energy(2., false), shielded = energy(2., true);
  print_once("box of 3 radii, %dD: energy changes by %.1e (open), %.1e (shielded)",
             dim,
             near / far - 1.,
             shielded / far - 1.);
  CHECK(near == Approx(far).epsilon(dim == 2 ? 5e-4 : 1e-4));
  CHECK(std::abs(shielded / far - 1.) > 5e-3);
}

// With all faces shielded nothing fixes the constant of the potential but one value at a corner; the
// problem is solvable all the same, as the poles of a body sum to zero.
TEMPLATE_TEST_CASE_SIG("All faces can be shielded", "[magnetics][mpi]", ((int dim), dim), 2, 3)
{
  for (const Preconditioner preconditioner :
       {Preconditioner::gmg, Preconditioner::ml, Preconditioner::muelu})
    {
      std::array<bool, 2 * dim> shielded;
      shielded.fill(true);
      auto parameters                  = with_law<dim>(MagnetizationLaw::langevin);
      parameters.solver.preconditioner = preconditioner;
      const SphereInField<dim> test(16, 5., grains(10.), 1e5, parameters, 2., shielded);
      CHECK(test.report.relative_final_residual() <= 1e-10);
      CHECK(test.report.newton.steps <= 6);
      CHECK(test.report.newton.linear_iterations < 80);
    }
}

// A body from one shielded wall to the opposite one is endless in a field along these walls: a slab
// (2D) has H = H_0/(1 + chi_0) inside, a cylinder (3D) H_0/(1 + chi_0/2). Its images have to join it
// without a gap, and the open faces to see a row of bodies without end. The correction of the volume
// reaches into the body and makes its density uneven by 0.6 %, which 2D shows.
TEMPLATE_TEST_CASE_SIG("Shielded faces are mirrors", "[magnetics][mpi]", ((int dim), dim), 2, 3)
{
  std::array<bool, 2 *dim> ends = {};
  ends[2 * dim - 2] = ends[2 * dim - 1] = true;
  SampledSetup<dim> scene(16, spacing, 2., with_law<dim>(MagnetizationLaw::linear), ends);
  const double centre = 8.1 * spacing, radius = 6. * spacing;
  SampledBody<dim> body;
  const auto distance = [centre](const Vector<dim> &x) {
    return dim == 3 ? std::hypot(x[0] - centre, x[1] - centre) : std::abs(x[0] - centre);
  };
  body.contains = [&](const Vector<dim> &x) { return distance(x) < radius; };
  body.material = grains(1.);
  for (int d = 0; d < dim; ++d)
    {
      body.lower[d] = (d == dim - 1 ? 0. : centre - radius);
      body.upper[d] = (d == dim - 1 ? 16. * spacing : centre + radius);
    }
  scene.set_bodies({body});
  Vector<dim> field;
  field[0] = 1e5;
  scene.problem.solve(scene.content, ExternalField<dim>({uniform_source<dim>(field)}));

  NodeField<dim, SingleVector> inner;
  scene.problem.compute_field(inner);
  double lowest = 1e300, highest = 0.;
  scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
    if (distance(x) < 0.5 * radius && x[dim - 1] >= 0. && x[dim - 1] <= 16. * spacing)
      {
        const double along = inner.get(SingleVector::value, slot, node)[0];
        lowest             = std::min(lowest, along);
        highest            = std::max(highest, along);
      }
  });
  lowest             = parallel::min(lowest, MPI_COMM_WORLD);
  highest            = parallel::max(highest, MPI_COMM_WORLD);
  const double exact = 1e5 / (dim == 2 ? 2. : 1.5);
  print_once("from mirror to mirror, %dD: error of H from %.1e to %.1e",
             dim,
             lowest / exact - 1.,
             highest / exact - 1.);
  CHECK(lowest == Approx(exact).epsilon(8e-3));
  CHECK(highest == Approx(exact).epsilon(8e-3));
}

// A table of a Langevin curve solves the same problem as the law itself, to the error of interpolating it:
// 8 points a unit of a = k2 H know M to 3e-5 of M_s, and the slope at zero to 1e-4.
TEMPLATE_TEST_CASE_SIG("A table of a Langevin curve gives Langevin's field",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const MagneticContent material = grains(2.);
  std::vector<double> fields, magnetizations;
  for (int i = 1; i <= 80; ++i)
    {
      fields.push_back(0.125 * i / k2);
      magnetizations.push_back(
        magnetization<2>(MagnetizationLaw::langevin, material, {{fields.back(), 0.}})[0]);
    }
  MagneticsParameters<dim> table = with_law<dim>(MagnetizationLaw::table);
  table.curve = std::make_shared<const MagnetizationCurve>(fields, magnetizations);
  const MagneticContent tabulated = {table.curve->saturation_magnetization(),
                                     table.curve->initial_susceptibility()};
  for (const double outer_field : {1e4, 2e5})
    {
      const SphereInField<dim> law(
        16, 5., material, outer_field, with_law<dim>(MagnetizationLaw::langevin));
      const SphereInField<dim> curve(16, 5., tabulated, outer_field, table);
      CHECK(curve.inner_field() == Approx(law.inner_field()).epsilon(3e-4));
      CHECK(curve.report.energy == Approx(law.report.energy).epsilon(3e-4));
      CHECK(curve.report.newton.steps <= law.report.newton.steps + 2);
    }
}
