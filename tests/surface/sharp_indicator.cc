#include "catch.h"

#include <magmpm/elliptic/elliptic_space.h>
#include <magmpm/magnetics/material_points.h>
#include <magmpm/mesh/node_filters.h>
#include <magmpm/parallel/reduce.h>

#include <verification/magnetostatics/sampled_setup.h>
#include <verification/magnetostatics/sources.h>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr double spacing        = 0.01; ///< dx [m]
  constexpr double susceptibility = 0.91;

  /** Functions to be smoothed. */
  struct Functions
  {
    static constexpr NodeScalar<Functions> one    = {0};
    static constexpr NodeScalar<Functions> sine   = {1};
    static constexpr NodeScalar<Functions> cosine = {2};

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(one);
      f(sine);
      f(cosine);
    }
  };

  /** The medium that bodies become, without a potential. */
  template <int dim>
  class Medium
  {
  public:
    explicit Medium(const std::vector<SampledBody<dim>> &bodies,
                    const int cell_edge                               = 2,
                    const std::array<bool, 2 *dim> &shielded          = {},
                    const std::vector<SourceParameters<dim>> &sources = {})
      : scene(32, spacing, 2., {}, shielded, cell_edge)
    {
      scene.set_bodies(bodies);
      MagneticsParameters<dim> parameters;
      parameters.shielded = shielded;
      points = std::make_unique<MaterialPoints<dim>>(scene.mesh, scene.partition, parameters);
      const EllipticSpace<dim> space(scene.mesh, false);
      n_cells = space.lattice_cells.size();
      points->reinit(space.lattice_cells, scene.content, ExternalField<dim>(sources));
    }

    /** Sum of action(point, its position) times the weight of the point, over all ranks. */
    template <typename Action>
    double
    integrate(const Action &action) const
    {
      double sum = 0.;
      for (unsigned int cell = 0; cell < n_cells; ++cell)
        if (points->first_point(cell) != points->none)
          for (int q = 0; q < n_octants<dim>; ++q)
            {
              const unsigned int point = points->first_point(cell) + q;
              sum += points->quadrature().weight(q) * action(point, points->position(point));
            }
      return parallel::sum(sum, MPI_COMM_WORLD);
    }

    /** int q f, the volume of the medium; q shows in what the linear law multiplies. */
    double
    volume() const
    {
      return integrate([&](const unsigned int point, const auto &) {
        return points->number_density(point) * points->fraction(point);
      });
    }

    /** Volume of the samples: the scene counts one grain per volume. */
    double
    sampled_volume() const
    {
      return scene.sum(scene.mass);
    }

    SampledSetup<dim> scene;
    std::unique_ptr<MaterialPoints<dim>> points;
    unsigned int n_cells;
  };

  template <int dim>
  SampledBody<dim>
  test_sphere(const double radius, const double shift = 0.)
  {
    Vector<dim> centre;
    for (int d = 0; d < dim; ++d)
      centre[d] = spacing * (16.27 + 0.3 * d + shift);
    return sphere<dim>(centre, radius * spacing, {8e4, susceptibility});
  }
} // namespace

// The volume of the medium is that of the particles, to 5e-6 for bodies and 1e-4 for drops, with cells
// of 2 dx and of dx: smoothing keeps sums, so nothing is lost but in the outermost tails of the
// B-splines, where the correction is cut off.
TEMPLATE_TEST_CASE_SIG("The medium has the volume of the particles",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  for (const double radius : {0.8, 2., 8.})
    for (const int cell_edge : {2, 1})
      {
        const Medium<dim> medium({test_sphere<dim>(radius)}, cell_edge);
        CAPTURE(dim, radius, cell_edge);
        CHECK(medium.volume() ==
              Approx(medium.sampled_volume()).epsilon(radius < 8. ? 1e-4 : 5e-6));
        CHECK(parallel::sum(medium.points->indicator().n_clipped_corrections(), MPI_COMM_WORLD) ==
              0);
      }
  Vector<dim> neighbour = test_sphere<dim>(3.).lower;
  const Medium<dim> touching(
    {test_sphere<dim>(3.), sphere<dim>(neighbour, 2. * spacing, {8e4, susceptibility})});
  CHECK(touching.volume() == Approx(touching.sampled_volume()).epsilon(1e-5));
}

// Inside a body the fraction is 1, outside 0, and between them it falls within little more than one dx and
// the octant that has its mean, at the right place, which the second moment of a sphere about its centre tells:
// that of the fractions that the sphere itself has in the same octants, as counted by points.
TEMPLATE_TEST_CASE_SIG("The surface is sharp and in place",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const SampledBody<dim> body = test_sphere<dim>(8.);
  const Vector<dim> centre    = 0.5 * (body.lower + body.upper);
  const Medium<dim> medium({body});
  const double reach = 0.8 + 0.5 * std::sqrt(static_cast<double>(dim)); // [dx]
  const auto middle  = [&](const Vector<dim> &x) {
    Vector<dim> m;
    for (int d = 0; d < dim; ++d)
      m[d] = (std::floor(x[d] / spacing) + 0.5) * spacing;
    return m;
  };
  const auto distance  = [&](const Vector<dim> &x) { return norm(middle(x) - centre) / spacing; };
  const double inside  = medium.integrate([&](const unsigned int point, const auto &x) {
    return distance(x) < 8. - reach ? std::abs(medium.points->fraction(point) - 1.) : 0.;
  });
  const double outside = medium.integrate([&](const unsigned int point, const auto &x) {
    return distance(x) > 8. + reach ? medium.points->fraction(point) : 0.;
  });
  const double volume  = std::pow(spacing, dim);
  CHECK(inside <= 0.05 * volume);
  CHECK(outside <= 0.05 * volume);

  const auto square = [&](const auto &fraction) {
    return medium.integrate([&](const unsigned int point, const auto &x) {
      return fraction(point, x) * distance(x) * distance(x);
    }) / medium.integrate(fraction);
  };
  const auto of_medium = [&](const unsigned int point, const auto &) {
    return medium.points->fraction(point);
  };
  const auto of_sphere = [&](const unsigned int, const Vector<dim> &x) {
    constexpr int n_edge = 8;
    int n_inside         = 0;
    for (int i = 0; i < power(n_edge, dim); ++i)
      {
        Vector<dim> y = middle(x);
        for (int d = 0, rest = i; d < dim; ++d, rest /= n_edge)
          y[d] += ((rest % n_edge + 0.5) / n_edge - 0.5) * spacing;
        n_inside += norm(y - centre) < 8. * spacing;
      }
    return n_inside / static_cast<double>(power(n_edge, dim));
  };
  CHECK(square(of_medium) == Approx(square(of_sphere)).epsilon(4e-3));
}

// A shielded wall is a mirror: a half sphere on it is the same medium as the half of a whole one. Its
// volume and density up to the wall show that images are complete for all filters.
TEMPLATE_TEST_CASE_SIG("The medium joins its image at a shielded wall",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  for (const bool is_upper : {false, true})
    {
      std::array<bool, 2 *dim> shielded          = {};
      shielded[2 * dim - 2 + (is_upper ? 1 : 0)] = true;
      Vector<dim> lower, upper;
      for (int d = 0; d < dim; ++d)
        {
          lower[d] = 8. * spacing;
          upper[d] = 24. * spacing;
        }
      (is_upper ? upper : lower)[dim - 1] = (is_upper ? 32. : 0.) * spacing;
      const Medium<dim> medium({box<dim>(lower, upper, {8e4, susceptibility})}, 2, shielded);
      const double uneven = medium.integrate([&](const unsigned int point, const Vector<dim> &x) {
        const double from_wall = (is_upper ? 32. * spacing - x[dim - 1] : x[dim - 1]) / spacing;
        const bool is_inner    = from_wall < 6. && std::abs(x[0] / spacing - 16.) < 1. &&
                              (dim == 2 || std::abs(x[1] / spacing - 16.) < 1.);
        return is_inner
                 ? std::abs(medium.points->fraction(point) * medium.points->number_density(point) -
                            1.)
                 : 0.;
      });
      CHECK(uneven <= 1e-3 * std::pow(2. * spacing, dim - 1) * 6. * spacing);
      CHECK(medium.volume() == Approx(medium.sampled_volume()).epsilon(2e-5));
    }
}

// Material that is pressed into a solid magnet is where it is: with or without a surface of the magnet the
// medium is the same, and its volume that of the particles.
TEMPLATE_TEST_CASE_SIG("Solid magnets leave the medium as it is",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  Vector<dim> magnetization;
  magnetization[0]             = 1e6;
  const SampledBody<dim> body  = test_sphere<dim>(6.);
  const Vector<dim> centre     = body.upper; // in the corner of the box around the body
  SourceParameters<dim> magnet = magnet_source<dim>(centre, 6. * spacing, magnetization);
  std::array<double, 2> in_magnet;
  for (const bool is_solid : {true, false})
    {
      magnet.is_solid = is_solid;
      const Medium<dim> medium({body}, 2, {}, {magnet});
      in_magnet[is_solid] = medium.integrate([&](const unsigned int point, const auto &x) {
        return norm(x - centre) < 6. * spacing ? medium.points->fraction(point) : 0.;
      });
      CHECK(medium.volume() == Approx(medium.sampled_volume()).epsilon(1e-5));
    }
  CHECK(in_magnet[true] > 0.);
  CHECK(in_magnet[true] == in_magnet[false]);
}

// smooth() is symmetric and keeps constants and sums, also at the ragged edge of the active blocks and
// across ranks: the volume of the medium rests on that.
TEMPLATE_TEST_CASE_SIG("The smoothing filter is symmetric and conservative",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const Medium<dim> medium({test_sphere<dim>(5.)});
  const SampledSetup<dim> &scene = medium.scene;
  NodeField<dim, Functions> field(scene.partition.blocks().size());
  scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
    field.set(Functions::one, slot, node, 1.);
    field.set(Functions::sine, slot, node, std::sin(300. * x[0] + 200. * x[1]));
    field.set(Functions::cosine, slot, node, std::cos(500. * x[0] * x[1] / spacing));
  });
  scene.partition.update_ghosts(field);
  NodeField<dim, Functions> smoothed(field);
  smooth(scene.partition, smoothed);

  double difference = 0., products[2] = {0., 0.}, sums[2] = {0., 0.};
  scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &) {
    const double sine        = field.get(Functions::sine, slot, node);
    const double smooth_sine = smoothed.get(Functions::sine, slot, node);
    difference = std::max(difference, std::abs(smoothed.get(Functions::one, slot, node) - 1.));
    products[0] += sine * smoothed.get(Functions::cosine, slot, node);
    products[1] += smooth_sine * field.get(Functions::cosine, slot, node);
    sums[0] += sine;
    sums[1] += smooth_sine;
  });
  for (double *figure : {&products[0], &products[1], &sums[0], &sums[1]})
    *figure = parallel::sum(*figure, MPI_COMM_WORLD);
  CHECK(difference <= 1e-14);
  CHECK(products[0] == Approx(products[1]).epsilon(1e-10).margin(1e-8));
  CHECK(sums[0] == Approx(sums[1]).epsilon(1e-10).margin(1e-8));
}
