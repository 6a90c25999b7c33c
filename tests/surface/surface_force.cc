#include "catch.h"

#include <magmpm/surface/surface_force.h>

#include <verification/magnetostatics/sampled_setup.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  /** A body alone in a box of 24^dim cells of edge one, its surface and the forces of it. */
  template <int dim>
  struct Surface
  {
    SampledSetup<dim> setup{24, 1., 2., {}};
    WettedWalls<dim> walls;
    NodeField<dim, SingleVector> force;
    double energy = 0.;

    Surface()
    {
      walls.mirrors.n_cells = setup.lattice.n_cells;
    }

    void
    wet(const int face, const double cosine)
    {
      walls.mirrors.is_mirror[face] = true;
      walls.cosine[face]            = cosine;
    }

    void
    find(const SampledBody<dim> &body, const double tension = 1., const bool is_uniform = true)
    {
      setup.set_bodies({body});
      SurfaceFields<dim> fields;
      fields.is_uniform                       = is_uniform;
      NodeField<dim, SurfaceContent> &content = fields.content;
      content.reinit(setup.partition.blocks().size());
      setup.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &) {
        const double volume = setup.mass.get(SingleScalar::value, slot, node);
        content.set(SurfaceContent::volume, slot, node, volume);
        content.set(SurfaceContent::tension, slot, node, tension * volume);
      });
      setup.partition.update_ghosts(content);
      SurfaceForce<dim> surface(setup.lattice, walls);
      energy = parallel::sum(surface.find(setup.partition, fields, force), MPI_COMM_WORLD);
    }

    /** Sum of f_i . (x_i - x), which is -(dim - 1) times the energy. */
    double
    virial(const Vector<dim> &centre) const
    {
      double sum = 0.;
      setup.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
        sum += dot(force.get(SingleVector::value, slot, node), x - centre);
      });
      return parallel::sum(sum, MPI_COMM_WORLD);
    }

    /** Sum of (x f_y - y f_x), the largest torque of others being no larger. */
    double
    torque(const Vector<dim> &centre) const
    {
      double sum = 0.;
      setup.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
        const Vector<dim> f = force.get(SingleVector::value, slot, node);
        sum += (x - centre)[0] * f[1] - (x - centre)[1] * f[0];
      });
      return parallel::sum(sum, MPI_COMM_WORLD);
    }
  };

  template <int dim>
  Vector<dim>
  place(const double first, const double others)
  {
    Vector<dim> x;
    for (int d = 0; d < dim; ++d)
      x[d] = (d == 0 ? first : others + 0.1 * d);
    return x;
  }
} // namespace

// The surface energy of a ball is its area, and its forces are those of a membrane: without a sum, without a
// torque, and with the virial of a stress whose trace is (dim - 1) times the energy, to rounding. The
// area of a ball of 6 dx is right to 2.5 %.
TEMPLATE_TEST_CASE_SIG("A ball has the tension of its surface",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const double radius      = 6.;
  const Vector<dim> centre = place<dim>(11.7, 12.2);
  Surface<dim> surface;
  surface.find(sphere<dim>(centre, radius, {1., 1.}));
  const double area = (dim == 2 ? 2. * pi * radius : 4. * pi * radius * radius);
  CHECK(surface.energy == Approx(area).epsilon(0.025));
  const Vector<dim> total = surface.setup.sum(surface.force);
  CHECK(norm(total) < 1e-12 * area);
  CHECK(std::abs(surface.torque(centre)) < 1e-12 * area * radius);
  CHECK(surface.virial(centre) == Approx(-(dim - 1) * surface.energy).epsilon(1e-12));

  // Where a field tells the tension it does so: half of it.
  const double whole = surface.energy;
  surface.find(sphere<dim>(centre, radius, {1., 1.}), 0.5, false);
  CHECK(surface.energy == Approx(0.5 * whole).epsilon(1e-12));
  CHECK(surface.virial(centre) == Approx(-(dim - 1) * surface.energy).epsilon(1e-12));
}

// A wall is a mirror: half a ball on it has half of the energy and, in front, the forces of a whole one, which
// here lies as the half does among the nodes.
TEMPLATE_TEST_CASE_SIG("Half a drop on a wall is half of a drop",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  Surface<dim> whole, half;
  const int face = GENERATE(0, 1);
  half.wet(face, 0.);
  whole.find(sphere<dim>(place<dim>(12., 12.2), 6., {1., 1.}));
  const double wall = (face == 0 ? 0. : 24.);
  // Beyond the wall there is nothing: the samples there are left out.
  SampledBody<dim> cap    = sphere<dim>(place<dim>(wall, 12.2), 6., {1., 1.});
  const auto is_in_sphere = cap.contains;
  cap.contains            = [is_in_sphere](const Vector<dim> &x) {
    return x[0] > 0. && x[0] < 24. && is_in_sphere(x);
  };
  half.find(cap);
  CHECK(half.energy == Approx(0.5 * whole.energy).epsilon(1e-12));
  // The virial about the middle of the wall sums up all forces in front, with their places.
  CHECK(half.virial(place<dim>(wall, 12.2)) ==
        Approx(0.5 * whole.virial(place<dim>(12., 12.2))).epsilon(1e-12));
}

// A wall that is wetted at the angle theta has the energy -cos(theta) of what is wet, and pulls outward what
// stands on it: half a disc on it is wet over its diameter, to 3 %. With it the virial about a point of the
// wall stays -(dim - 1) times the energy; along the wall there is no force in all.
TEMPLATE_TEST_CASE_SIG("A wetted wall has its energy and the force of it",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const double radius      = 7.;
  const double cosine      = GENERATE(0.5, -0.8);
  const Vector<dim> centre = place<dim>(0., 12.2);
  SampledBody<dim> cap     = sphere<dim>(centre, radius, {1., 1.});
  const auto is_in_sphere  = cap.contains;
  cap.contains = [is_in_sphere](const Vector<dim> &x) { return x[0] > 0. && is_in_sphere(x); };
  Surface<dim> dry, wet;
  dry.wet(0, 0.);
  wet.wet(0, cosine);
  dry.find(cap);
  wet.find(cap);
  const double wetted = (dim == 2 ? 2. * radius : pi * radius * radius);
  CHECK(dry.energy - wet.energy == Approx(cosine * wetted).epsilon(0.03));
  CHECK(wet.virial(centre) == Approx(-(dim - 1) * wet.energy).epsilon(1e-12));
  for (int d = 1; d < dim; ++d)
    CHECK(std::abs(wet.setup.sum(wet.force)[d]) < 1e-12 * wetted);

  // Where a field tells the tension, the wall's follows it.
  const double whole = wet.energy;
  wet.find(cap, 0.5, false);
  CHECK(wet.energy == Approx(0.5 * whole).epsilon(1e-12));
}
