// The field of solid magnets as material feels it: what goes on inside must not lose or make energy.

#include <magmpm/magnets/continued_field.h>

#include "../catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  constexpr double small = 1e-12; ///< edge of the cube that a point stands for

  /** A cuboid of 2 x 1 x 1 (x 1), magnetized obliquely, away from the origin. */
  template <int dim>
  SourceParameters<dim>
  solid_cuboid()
  {
    Vector<dim> size, place, magnetization;
    for (int d = 0; d < dim; ++d)
      {
        size[d]          = (d == 0 ? 2. : 1.);
        place[d]         = 0.3 - 0.1 * d;
        magnetization[d] = 1e5 * (1. + d);
      }
    SourceParameters<dim> cuboid;
    cuboid.name     = "cuboid";
    cuboid.kind     = CuboidParameters<dim>{magnetization, size};
    cuboid.pose     = Pose<dim>{place};
    cuboid.is_solid = true;
    return cuboid;
  }

  template <int dim>
  SourceParameters<dim>
  solid_sphere()
  {
    Vector<dim> place, magnetization;
    place[0]               = 0.2;
    magnetization[dim - 1] = 1e6;
    SourceParameters<dim> sphere;
    sphere.name     = "sphere";
    sphere.kind     = MagnetizedSphereParameters<dim>{magnetization, 1.};
    sphere.pose     = Pose<dim>{place};
    sphere.is_solid = true;
    return sphere;
  }

  template <int dim>
  void
  check_gradient(const ContinuedField<dim> &field, const Vector<dim> &x, const double tolerance)
  {
    constexpr double step     = 1e-4;
    const Matrix<dim> against = field.at(x, small).gradient;
    for (int i = 0; i < dim; ++i)
      {
        Vector<dim> way;
        way[i]               = step;
        const Vector<dim> dH = (0.5 / step) *
                               (field.at(x + way, small).field - field.at(x - way, small).field);
        for (int j = 0; j < dim; ++j)
          CHECK(against(i, j) == Approx(dH[j]).margin(tolerance));
      }
  }
} // namespace

// Outside, field and gradient are those of the sources, bit for bit. Below the surface of a sphere the
// nearest place outside is on the same radius, so the field is that of the surface from outside.
TEMPLATE_TEST_CASE_SIG("Material in a sphere feels the field at its surface",
                       "[magnets]",
                       ((int dim), dim),
                       2,
                       3)
{
  const ExternalField<dim> sources({solid_sphere<dim>()});
  const ContinuedField<dim> field(sources);
  Vector<dim> direction;
  for (int d = 0; d < dim; ++d)
    direction[d] = 0.3 + 0.4 * d;
  direction *= 1. / norm(direction);
  Vector<dim> centre;
  centre[0]                 = 0.2;
  const Vector<dim> outside = centre + 1.3 * direction;
  CHECK(norm(field.at(outside, small).field - sources.field(outside)) == 0.);
  CHECK(frobenius_norm(field.at(outside, small).gradient +
                       (-1.) * sources.field_gradient(outside)) == 0.);

  const Vector<dim> at_surface = sources.field(centre + (1. + 1e-8) * direction);
  for (const double radius : {0.3, 0.7, 0.99})
    {
      const Vector<dim> inside = centre + radius * direction;
      CHECK(norm(field.at(inside, small).field - at_surface) < 1e-6 * norm(at_surface));
      check_gradient(field, inside, 1e-3 * norm(at_surface));
    }
}

// Along a line that crosses the diagonal plane beneath an edge of a cuboid, and its surface, H~ changes by
// no more from step to step than its slope allows: the nearest place alone would make it jump by the
// surface charge. Close to a face it is the field before that face.
TEMPLATE_TEST_CASE_SIG("The field goes on continuously beneath the edges of a cuboid",
                       "[magnets]",
                       ((int dim), dim),
                       2,
                       3)
{
  const SourceParameters<dim> cuboid = solid_cuboid<dim>();
  const ExternalField<dim> sources({cuboid});
  const ContinuedField<dim> field(sources);
  const Vector<dim> centre = sources.sources()[0]->pose().position;
  Vector<dim> start        = centre, way;
  start[0] += 0.85;
  start[1] += 0.55;
  way[0]                = 0.1;
  way[1]                = -0.3;
  constexpr int n_steps = 3000;
  Vector<dim> before    = field.at(start, small).field;
  double largest_change = 0.;
  for (int n = 1; n <= n_steps; ++n)
    {
      const Vector<dim> now =
        field.at(start + (static_cast<double>(n) / n_steps) * way, small).field;
      largest_change = std::max(largest_change, norm(now - before));
      before         = now;
    }
  CHECK(largest_change < 2e-3 * norm(sources.field(start)));
  check_gradient(field, start + 0.5 * way, 1e-3 * norm(sources.field(start)));

  Vector<dim> below = centre, above = centre;
  below[0] += 0.3;
  above[0] += 0.3;
  below[1] += 0.5 - 1e-4;
  above[1] += 0.5 + 1e-9;
  CHECK(norm(field.at(below, small).field - sources.field(above)) <
        1e-4 * norm(sources.field(above)));
}

// Of one source alone, in another's solid inside, the field is continued by the same places; all sources
// add up to the whole, so what acts on the material acts back on them.
TEST_CASE("The continued fields of the sources add up", "[magnets]")
{
  const ExternalField<3> sources({solid_cuboid<3>(), solid_sphere<3>()});
  const ContinuedField<3> field(sources);
  for (const Vector<3> &x : {Vector<3>{{0.5, 0.1, 0.1}},
                             Vector<3>{{1.15, 0.3, 0.2}},
                             Vector<3>{{0.2, 0.1, 0.9}},
                             Vector<3>{{2., 2., 2.}}})
    {
      LocalField<3> sum = {};
      for (const auto *source : sources.sources())
        {
          const LocalField<3> part = field.of(*source, x, small);
          sum.field += part.field;
          sum.gradient += part.gradient;
        }
      const LocalField<3> all = field.at(x, small);
      CHECK(norm(sum.field - all.field) < 1e-9 * norm(all.field));
      CHECK(frobenius_norm(sum.gradient + (-1.) * all.gradient) <
            1e-6 * frobenius_norm(all.gradient));
    }
}
