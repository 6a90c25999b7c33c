#include "catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/parallel/reduce.h>

#include <verification/magnetostatics/sampled_setup.h>
#include <verification/magnetostatics/sources.h>
#include <verification/print_once.h>

#include <map>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr double spacing = 1. / 128.; ///< dx [m]

  template <int dim>
  MagneticsParameters<dim>
  linear_law()
  {
    MagneticsParameters<dim> parameters;
    parameters.law                     = MagnetizationLaw::linear;
    parameters.solver.newton_tolerance = 1e-12;
    return parameters;
  }

  template <int dim>
  Vector<dim>
  lattice_point(const double x, const double y, const double z)
  {
    Vector<dim> point;
    point[0]       = spacing * x;
    point[1]       = spacing * y;
    point[dim - 1] = spacing * z;
    return point;
  }
} // namespace

// A body in a uniform field is pulled apart but not away: the net force is zero. What is left is
// the force that the far field of the body leaves on nodes beyond the two layers, and is counted.
TEMPLATE_TEST_CASE_SIG("There is no net force in a uniform field",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  SampledSetup<dim> scene(32, spacing, 2., linear_law<dim>());
  const Vector<dim> centre = lattice_point<dim>(16.2, 15.9, 16.4);
  scene.set_bodies({sphere<dim>(centre, 8. * spacing, {1., 0.91})});
  Vector<dim> field;
  field[0]       = 6e4;
  field[dim - 1] = 8e4;
  scene.problem.solve(scene.content, ExternalField<dim>({uniform_source<dim>(field)}));
  const Force<dim> force = force_on_nodes(scene, centre);
  print_once("uniform field, %dD: net force %.1e, dropped %.1e, of the sum of |f|",
             dim,
             norm(force.total) / force.absolute,
             norm(force.dropped) / force.absolute);
  CHECK(norm(force.total) < 5e-4 * force.absolute);
  CHECK(norm(force.total + force.dropped) < 5e-4 * force.absolute);
}

// Far from a magnet a small linear sphere feels mu_0 (m.grad) H with m its dipole moment. The
// moment is the computed one, U = -mu_0/2 m.H, so that this tests the force and not the smeared
// interface.
TEMPLATE_TEST_CASE_SIG("A small sphere is drawn like a dipole",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  SampledSetup<dim> scene(64, spacing, 2., linear_law<dim>());
  const Vector<dim> centre = lattice_point<dim>(41.3, 33.6, 47.2);
  scene.set_bodies({sphere<dim>(centre, 4. * spacing, {1., 0.91})});
  Vector<dim> magnetization;
  magnetization[0]       = 4e5;
  magnetization[dim - 1] = 1e6;
  const ExternalField<dim> sources(
    {magnet_source<dim>(lattice_point<dim>(20., 20., 10.), 6. * spacing, magnetization)});
  const SolveReport report = scene.problem.solve(scene.content, sources);

  const Vector<dim> field = sources.field(centre);
  const double moment     = -2. * report.energy / (constants::vacuum_permeability * norm(field));
  const Vector<dim> exact = (constants::vacuum_permeability * moment / norm(field)) *
                            (sources.field_gradient(centre) * field);
  const Force<dim> force = force_on_nodes(scene, centre);
  print_once("sphere of R = 4 dx as a dipole, %dD: error of the force %.1e",
             dim,
             norm(force.total - exact) / norm(exact));
  CHECK(norm(force.total - exact) < 0.02 * norm(exact));
}

// The force is what the energy loses on the way: U(b) - U(a) = -int F dx. Over two steps of 2 dx,
// the period of the mesh, with Simpson's rule.
TEMPLATE_TEST_CASE_SIG("The force is the derivative of the energy",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  SampledSetup<dim> scene(64, spacing, 2., linear_law<dim>());
  Vector<dim> magnetization;
  magnetization[0] = 1e6;
  const ExternalField<dim> sources(
    {magnet_source<dim>(lattice_point<dim>(16., 32., 32.), 8. * spacing, magnetization)});
  double energy[3], force[3];
  for (int i = 0; i < 3; ++i)
    {
      const Vector<dim> centre = lattice_point<dim>(36.3 + 2. * i, 34.1, 32.4);
      scene.set_bodies({sphere<dim>(centre, 5. * spacing, {1., 2.})});
      energy[i] = scene.problem.solve(scene.content, sources).energy;
      force[i]  = force_on_nodes(scene, centre).total[0];
    }
  const double work = 4. * spacing / 6. * (force[0] + 4. * force[1] + force[2]);
  print_once("%dD: energy lost %.6g, work of the force %.6g", dim, energy[0] - energy[2], work);
  CHECK(force[0] < 0.); // towards the magnet
  CHECK(energy[2] - energy[0] == Approx(-work).epsilon(5e-3));
}

// An oblique ellipse (2D) or spheroid (3D) turns into the field, mu_0 m x H_0. All of its torque
// comes from the antisymmetric part of h (x) (h + M): a transposed tensor would turn the body the
// wrong way. The moment m = A H_0 is known from the energy, U = -mu_0/2 H_0.A H_0: with the field
// along x, y and x + y, A_xy is in the difference. That of an ellipsoid, chi/(1 + N chi) along each
// axis, is missed by the smeared interface, more so at the sharp ends.
TEMPLATE_TEST_CASE_SIG("An oblique spheroid turns into the field",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const double long_axis = 10. * spacing, short_axis = 5. * spacing, chi = 3.;
  const Vector<dim> centre = lattice_point<dim>(16., 16., 16.);
  SampledBody<dim> body;
  body.contains = [=](const Vector<dim> &x) {
    const Vector<dim> r = x - centre;
    const double along  = std::sqrt(0.5) * (r[0] + r[1]);
    const double rest   = norm_square(r) - along * along;
    return along * along / (long_axis * long_axis) + rest / (short_axis * short_axis) < 1.;
  };
  body.material = {1., chi};
  for (int d = 0; d < dim; ++d)
    {
      body.lower[d] = centre[d] - long_axis;
      body.upper[d] = centre[d] + long_axis;
    }
  SampledSetup<dim> scene(32, spacing, 2., linear_law<dim>());
  scene.set_bodies({body});
  const double strength = 1e5;
  const auto energy     = [&](const double x, const double y) {
    Vector<dim> field;
    field[0] = strength * x;
    field[1] = strength * y;
    return scene.problem.solve(scene.content, ExternalField<dim>({uniform_source<dim>(field)}))
      .energy;
  };
  const double along_y = energy(0., 1.), along_both = energy(1., 1.), along_x = energy(1., 0.);
  const double of_moment = along_both - along_x - along_y; // -mu_0 A_xy H^2 = mu_0 (m x H_0)_z
  const Force<dim> force = force_on_nodes(scene, centre);
  const double torque    = force.torque[n_axial_components<dim> - 1];
  CHECK(torque == Approx(of_moment).epsilon(0.01));
  CHECK(norm(force.total) < 1e-3 * force.absolute);

  // Demagnetizing factors: of an ellipse b/(a + b); of a prolate spheroid with axis ratio 2.
  const double e       = std::sqrt(1. - 0.25);
  const double n_long  = (dim == 2 ? 1. / 3. : 0.25 / (e * e * e) * (std::atanh(e) - e));
  const double n_short = (dim == 2 ? 2. / 3. : 0.5 * (1. - n_long));
  const double volume  = (dim == 2 ? constants::pi * long_axis * short_axis
                                   : 4. / 3. * constants::pi * long_axis * short_axis * short_axis);
  const double exact   = -0.5 * constants::vacuum_permeability * volume * strength * strength *
                       (chi / (1. + n_long * chi) - chi / (1. + n_short * chi));
  print_once("torque on a spheroid, %dD: %.6g, mu_0 m x H_0 %.6g, of the exact m %.6g",
             dim,
             torque,
             of_moment,
             exact);
  CHECK(torque < 0.); // clockwise, into the field
  CHECK(torque == Approx(exact).epsilon(0.2));
}

// A layer between shielded side walls, in a field along them, is a piece of an endless one: the
// same acceleration on every node of a row that lies alike in its cell of the potential (of 2 dx),
// none across the walls. What the quadrature leaves out behind the mirrors would push the layer
// against them, with all of mu_0 M^2/2.
TEMPLATE_TEST_CASE_SIG("A layer between mirrors does not feel them",
                       "[magnetics][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  std::array<bool, 2 * dim> shielded;
  shielded.fill(true);
  constexpr int n_cells                = 16;
  MagneticsParameters<dim> exact_solve = linear_law<dim>();
  exact_solve.solver.newton_tolerance  = 1e-14;
  SampledSetup<dim> scene(n_cells, spacing, 2., exact_solve, shielded);
  Vector<dim> lower, upper, field;
  for (int d = 0; d < dim; ++d)
    upper[d] = n_cells * spacing;
  upper[dim - 1] = 9.3 * spacing;
  field[dim - 1] = 1e5;
  scene.set_bodies({box<dim>(lower, upper, {1., 1.5})});
  scene.problem.solve(scene.content, ExternalField<dim>({uniform_source<dim>(field)}));

  add_images(scene.partition.blocks(),
             scene.partition.blocks().n_owned(),
             scene.partition.walls(),
             Parity(),
             scene.mass);
  scene.partition.update_ghosts(scene.mass);
  NodeField<dim, SingleVector> force;
  scene.problem.compute_force(scene.mass, force);
  // Least and largest acceleration by height and place in the cell.
  std::map<Index<dim>, std::pair<double, double>> rows;
  double largest = 0., across = 0.;
  scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
    const double mass = scene.mass.get(SingleScalar::value, slot, node);
    Index<dim> row;
    bool is_inside = true;
    for (int d = 0; d < dim; ++d)
      {
        row[d]    = static_cast<int>(std::lround(x[d] / spacing));
        is_inside = is_inside && row[d] >= 0 && row[d] <= n_cells;
        if (d < dim - 1)
          row[d] = std::abs(row[d]) % 2;
      }
    if (!(mass > 0. && is_inside))
      return;
    const Vector<dim> f       = force.get(SingleVector::value, slot, node);
    const double acceleration = f[dim - 1] / mass;
    const auto entry          = rows.try_emplace(row, acceleration, acceleration).first;
    entry->second.first       = std::min(entry->second.first, acceleration);
    entry->second.second      = std::max(entry->second.second, acceleration);
    largest                   = std::max(largest, std::abs(acceleration));
    for (int d = 0; d < dim - 1; ++d)
      across = std::max(across, std::abs(f[d]) / mass);
  });
  largest = parallel::max(largest, MPI_COMM_WORLD);
  REQUIRE(largest > 0.);
  CHECK(across < 1e-9 * largest);
  for (const auto &row : rows)
    CHECK(row.second.second - row.second.first < 1e-9 * largest);
}
