#include <magmpm/materials/neo_hookean.h>
#include <magmpm/materials/viscoelastic_fluid.h>

#include "catch.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace magmpm;

namespace
{
  template <int dim>
  const NeoHookean<dim> solid = {4e4, 6e4, 2500.};

  template <int dim>
  const ViscoelasticFluid<dim> fluid = {2e5, 3., 7., 1200.};

  /** A matrix of uniform random numbers in (-size, size), the same in every run. */
  template <int dim>
  Matrix<dim>
  random_matrix(std::mt19937 &generator, const double size)
  {
    std::uniform_real_distribution<double> uniform(-size, size);
    Matrix<dim> matrix;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        matrix(i, j) = uniform(generator);
    return matrix;
  }

  template <int dim>
  double
  contraction(const Matrix<dim> &a, const Matrix<dim> &b)
  {
    return trace(a * transpose(b));
  }

  /** Rotation by an angle about z. */
  template <int dim>
  Matrix<dim>
  rotation(const double angle)
  {
    Matrix<dim> matrix = identity<dim>();
    matrix(0, 0) = matrix(1, 1) = std::cos(angle);
    matrix(0, 1)                = -std::sin(angle);
    matrix(1, 0)                = std::sin(angle);
    return matrix;
  }

  /** The energy that a small motion with velocity gradient @p l adds in a unit of time, tau:l. */
  template <typename Material, int dim>
  double
  power(const Material &material, const typename Material::State &state, const Matrix<dim> &l)
  {
    const double dt = 1e-5;
    return (material.energy_density(material.advanced(state, l, dt)) -
            material.energy_density(material.advanced(state, l, -dt))) /
           (2. * dt);
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("the neo-Hookean stress is the derivative of the energy",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // tau : grad v = d psi/dt along F' = (grad v) F, for random F and grad v. A central difference of
  // the energy with dt = 1e-5 is off by dt^2 and by rounding over dt, about 1e-10 of the moduli.
  std::mt19937 generator(1);
  for (int i = 0; i < 50; ++i)
    {
      const Matrix<dim> f = identity<dim>() + random_matrix<dim>(generator, 0.3);
      const Matrix<dim> l = random_matrix<dim>(generator, 1.);
      CHECK(contraction(solid<dim>.kirchhoff_stress(f, {}), l) ==
            Approx(power(solid<dim>, f, l)).margin(1e-8 * solid<dim>.lame_lambda));
    }
}

TEST_CASE("the neo-Hookean stress is Eq. (18) worked out by hand", "[materials]")
{
  // Uniaxial stretch F = diag(2, 1, 1): J = 2, tau_xx = mu (4 - 1) + lambda ln 2, tau_yy = tau_zz =
  // lambda ln 2. Plane strain is the same stretch without its z, and tau_zz/J is out of the plane.
  const double mu = 4e4, lambda = 6e4;
  Matrix<3> f            = identity<3>();
  f(0, 0)                = 2.;
  const Matrix<3> stress = solid<3>.kirchhoff_stress(f, {});
  CHECK(stress(0, 0) == Approx(3. * mu + lambda * std::log(2.)));
  CHECK(stress(1, 1) == Approx(lambda * std::log(2.)));
  CHECK(stress(2, 2) == Approx(lambda * std::log(2.)));
  CHECK(stress(0, 1) == 0.);
  CHECK(solid<3>.volume_ratio(f) == 2.);
  CHECK(solid<3>.energy_density(f) ==
        Approx(0.5 * mu * 3. - mu * std::log(2.) + 0.5 * lambda * std::pow(std::log(2.), 2)));
  // The deviator has 3 mu on one axis only: sigma = 3 mu/2 in the sense of von Mises.
  CHECK(solid<3>.von_mises_stress(f, {}) == Approx(1.5 * mu));

  const Matrix<2> plane = {{{2., 0.}, {0., 1.}}};
  CHECK(solid<2>.kirchhoff_stress(plane, {})(0, 0) == Approx(stress(0, 0)));
  CHECK(solid<2>.kirchhoff_stress(plane, {})(1, 1) == Approx(stress(1, 1)));
  CHECK(solid<2>.cauchy_stress_out_of_plane(plane, {}) == Approx(0.5 * stress(2, 2)));
  CHECK(solid<2>.energy_density(plane) == Approx(solid<3>.energy_density(f)));
  CHECK(solid<2>.von_mises_stress(plane, {}) == Approx(1.5 * mu));
}

TEMPLATE_TEST_CASE_SIG("a rotation turns the stress and costs no energy",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // tau(R F) = R tau(F) R^T for every rotation R, and psi, von Mises stress and wave speed do not
  // notice: the law depends on F F^T and J only. An undeformed solid has neither stress nor energy.
  std::mt19937 generator(2);
  const Matrix<dim> f      = identity<dim>() + random_matrix<dim>(generator, 0.3);
  const Matrix<dim> r      = rotation<dim>(0.7);
  const Matrix<dim> turned = r * solid<dim>.kirchhoff_stress(f, {}) * transpose(r);
  const Matrix<dim> stress = solid<dim>.kirchhoff_stress(r * f, {});
  CHECK(frobenius_norm(stress + (-1.) * turned) < 1e-13 * frobenius_norm(stress));
  CHECK(solid<dim>.energy_density(r * f) == Approx(solid<dim>.energy_density(f)).epsilon(1e-12));
  CHECK(solid<dim>.von_mises_stress(r * f, {}) == Approx(solid<dim>.von_mises_stress(f, {})));
  CHECK(solid<dim>.wave_speed(r * f) == Approx(solid<dim>.wave_speed(f)));

  const Matrix<dim> undeformed = NeoHookean<dim>::undeformed();
  CHECK(frobenius_norm(solid<dim>.kirchhoff_stress(undeformed, {})) == 0.);
  CHECK(solid<dim>.energy_density(undeformed) == 0.);
  CHECK(solid<dim>.volume_ratio(undeformed) == 1.);
  CHECK(solid<dim>.viscosity() == 0.);
}

TEST_CASE("a deformation gradient follows the velocity gradient", "[materials]")
{
  // (I + dt grad v) F by hand: simple shear of a stretched square. The velocity gradient acts from
  // the left; from the right the result would be another one.
  const Matrix<2> f = {{{2., 0.}, {0., 3.}}};
  const Matrix<2> l = {{{0., 5.}, {0., 0.}}};
  const Matrix<2> g = solid<2>.advanced(f, l, 0.1);
  CHECK(g(0, 0) == 2.);
  CHECK(g(0, 1) == Approx(1.5));
  CHECK(g(1, 0) == 0.);
  CHECK(g(1, 1) == 3.);
}

TEMPLATE_TEST_CASE_SIG("no plane wave in the deformed solid is faster than its wave speed",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The speed of a wave in direction n with amplitude m follows from the second derivative of the
  // energy along F' = F + s m (F^T n)^T, taken here as a difference; no such speed may exceed the
  // bound (by more than the error of the difference), and in 2D the largest one must meet it.
  std::mt19937 generator(3);
  for (int i = 0; i < 20; ++i)
    {
      const Matrix<dim> f   = identity<dim>() + random_matrix<dim>(generator, 0.3);
      double fastest_square = 0.;
      for (int k = 0; k < 2000; ++k)
        {
          const Matrix<dim> random = random_matrix<dim>(generator, 1.);
          Vector<dim> n, m;
          for (int d = 0; d < dim; ++d)
            {
              n[d] = random(0, d);
              m[d] = k % 2 == 0 ? n[d] : random(1, d);
            }
          n *= 1. / norm(n);
          m *= 1. / norm(m);
          const double s         = 1e-4;
          const Matrix<dim> wave = outer(m, transpose(f) * n);
          const double curvature = (solid<dim>.energy_density(f + s * wave) -
                                    2. * solid<dim>.energy_density(f) +
                                    solid<dim>.energy_density(f + (-s) * wave)) /
                                   (s * s);
          fastest_square = std::max(fastest_square, curvature / solid<dim>.density);
        }
      const double fastest = std::sqrt(fastest_square);
      CHECK(fastest < 1.0001 * solid<dim>.wave_speed(f));
      CHECK(fastest > (dim == 2 ? 0.999 : 0.85) * solid<dim>.wave_speed(f));
    }
}

TEST_CASE("the wave speed of the undeformed solid is that of the textbook", "[materials]")
{
  // sqrt((lambda + 2 mu)/density) = sqrt(1.4e5/2500) m/s undeformed; stretched to twice its length,
  // along the axis: mu (4 + 1) + lambda (1 - ln 2).
  CHECK(solid<3>.wave_speed(identity<3>()) == Approx(std::sqrt(1.4e5 / 2500.)).epsilon(1e-14));
  CHECK(solid<2>.wave_speed(identity<2>()) == Approx(std::sqrt(1.4e5 / 2500.)).epsilon(1e-14));
  Matrix<3> f = identity<3>();
  f(2, 2)     = 2.;
  CHECK(solid<3>.wave_speed(f) ==
        Approx(std::sqrt((5. * 4e4 + 6e4 * (1. - std::log(2.))) / 2500.)).epsilon(1e-14));
}

TEST_CASE("the wave speed is a number for every positive volume ratio", "[materials]")
{
  // From crushed to a speck to torn to a hundred times the size, where lambda (1 - ln J) is far
  // below zero: never NaN, never below the shear speed in the direction of the largest stretch.
  for (double stretch = 1e-6; stretch < 200.; stretch *= 1.5)
    {
      const double speed = solid<3>.wave_speed(stretch * identity<3>());
      CHECK(std::isfinite(speed));
      CHECK(speed >= stretch * std::sqrt(4e4 / 2500.) * (1. - 1e-12));
    }
}

TEST_CASE("the volume ratio of a fluid follows the divergence and stays positive", "[materials]")
{
  // J exp(dt div v): at constant div v = -3/s, a hundred steps of 0.01 s are one of 1 s, exp(-3);
  // and a step a thousand times too long still leaves J positive.
  const Matrix<3> inward = (-1.) * identity<3>();
  double j               = ViscoelasticFluid<3>::undeformed();
  CHECK(j == 1.);
  for (int step = 0; step < 100; ++step)
    j = fluid<3>.advanced(j, inward, 0.01);
  CHECK(j == Approx(std::exp(-3.)).epsilon(1e-13));
  CHECK(fluid<3>.volume_ratio(j) == j);
  CHECK(fluid<3>.advanced(1., inward, 100.) > 0.);
  // A rotation or a shear does not change the volume.
  CHECK(fluid<2>.advanced(0.8, {{{0., 5.}, {-2., 0.}}}, 0.1) == 0.8);
}

TEMPLATE_TEST_CASE_SIG("a compressed fluid pushes outwards, and its work is its energy",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // At rest and compressed to J = 0.9 the Cauchy stress is -K (1 - J) I = -2e4 Pa. The work
  // tau:grad v of the pressure is the rate of K/2 (1 - J)^2 (by a central difference).
  const Matrix<dim> stress = fluid<dim>.kirchhoff_stress(0.9, {});
  for (int i = 0; i < dim; ++i)
    for (int k = 0; k < dim; ++k)
      CHECK(stress(i, k) / 0.9 == Approx(i == k ? -2e4 : 0.));
  CHECK(fluid<dim>.pressure(0.9) == Approx(2e4));
  CHECK(fluid<dim>.cauchy_stress_out_of_plane(0.9, {}) == Approx(-2e4));
  CHECK(fluid<dim>.energy_density(0.9) == Approx(0.5 * 2e5 * 0.01));
  CHECK(fluid<dim>.von_mises_stress(0.9, {}) == Approx(0.).margin(1e-9));

  std::mt19937 generator(4);
  for (const double j : {0.3, 0.9, 1., 1.2})
    {
      const Matrix<dim> l = random_matrix<dim>(generator, 1.);
      CHECK(contraction(fluid<dim>.kirchhoff_stress(j, {}), l) ==
            Approx(power(fluid<dim>, j, l)).margin(1e-8 * 2e5));
    }
}

TEST_CASE("a sheared fluid resists by its viscosity", "[materials]")
{
  // Simple shear v_x = 7/s y at J = 0.9 and mu_N = 3 Pa s: sigma_xy = sigma_yx = 21 Pa, and
  // sqrt(3) 21 Pa in the sense of von Mises, in 2D as in 3D.
  Matrix<3> l3;
  l3(0, 1)           = 7.;
  const Matrix<2> l2 = {{{0., 7.}, {0., 0.}}};
  CHECK(fluid<3>.kirchhoff_stress(0.9, l3)(0, 1) == Approx(0.9 * 21.));
  CHECK(fluid<3>.kirchhoff_stress(0.9, l3)(1, 0) == Approx(0.9 * 21.));
  CHECK(fluid<3>.von_mises_stress(0.9, l3) == Approx(std::sqrt(3.) * 21.));
  CHECK(fluid<2>.von_mises_stress(0.9, l2) == Approx(std::sqrt(3.) * 21.));
}

TEMPLATE_TEST_CASE_SIG("a fluid that expands is held back by its bulk viscosity",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // div v = 5 dim/s at J = 1, zeta = 7 Pa s and mu_N = 3 Pa s: 2 mu_N 5/s + 35 dim Pa along each axis. A wave
  // along x, (5, 0, 0)/s, has 2 mu_N 5 + 7 5 Pa across its fronts, as with a shear viscosity of 6.5 Pa s alone.
  const Matrix<dim> even = fluid<dim>.kirchhoff_stress(1., 5. * identity<dim>());
  for (int i = 0; i < dim; ++i)
    CHECK(even(i, i) == Approx(30. + 35. * dim));
  Matrix<dim> wave;
  wave(0, 0) = 5.;
  CHECK(fluid<dim>.kirchhoff_stress(1., wave)(0, 0) == Approx(2. * fluid<dim>.viscosity() * 5.));
  CHECK(fluid<dim>.viscosity() == 6.5);
  CHECK(fluid<dim>.cauchy_stress_out_of_plane(1., wave) == Approx(35.));
}

TEST_CASE("sound in a fluid is as fast as pressure rises with density", "[materials]")
{
  // c^2 = dp/d(rho) at rho = density/J, by a difference of p = K (1 - density/rho).
  for (const double j : {0.5, 1., 1.3})
    {
      const double rho  = 1200. / j;
      const double step = 1e-4 * rho;
      const double gradient =
        (fluid<3>.pressure(1200. / (rho + step)) - fluid<3>.pressure(1200. / (rho - step))) /
        (2. * step);
      CHECK(fluid<3>.wave_speed(j) == Approx(std::sqrt(gradient)).epsilon(1e-7));
    }
}

TEST_CASE("von Mises stress of tension, shear and pressure", "[materials]")
{
  // Tension: its strength; shear: sqrt(3) times it; pressure: none, in 2D only with the pressure
  // across the plane too.
  CHECK(von_mises_stress(Matrix<3>{{{5., 0., 0.}, {0., 0., 0.}, {0., 0., 0.}}}) == Approx(5.));
  CHECK(von_mises_stress(Matrix<3>{{{0., 0., 2.}, {0., 0., 0.}, {2., 0., 0.}}}) ==
        Approx(2. * std::sqrt(3.)));
  CHECK(von_mises_stress((-7.) * identity<3>()) == 0.);
  CHECK(von_mises_stress((-7.) * identity<2>(), -7.) == 0.);
  CHECK(von_mises_stress((-7.) * identity<2>(), 0.) == Approx(7.));
  CHECK(von_mises_stress(Matrix<2>{{{0., 3.}, {3., 0.}}}, 0.) == Approx(3. * std::sqrt(3.)));
}

TEST_CASE("materials are made of the parameters of a scene", "[materials]")
{
  // Every parameter in its place, each with a different value.
  MaterialParameters parameters;
  parameters.shear_modulus = 1.;
  parameters.lame_lambda   = 2.;
  parameters.bulk_modulus  = 3.;
  parameters.viscosity     = 4.;

  parameters.sound_damping_length = 0.1;

  const NeoHookean<3> elastic = make_neo_hookean<3>(parameters, 5.);
  CHECK(elastic.shear_modulus == 1.);
  CHECK(elastic.lame_lambda == 2.);
  CHECK(elastic.density == 5.);
  CHECK(NeoHookean<3>::stores_deformation_gradient);

  const ViscoelasticFluid<2> liquid = make_viscoelastic_fluid<2>(parameters, 6.);
  CHECK(liquid.bulk_modulus == 3.);
  CHECK(liquid.bulk_viscosity == Approx(0.1 * 6. * std::sqrt(3. / 6.)));
  CHECK(liquid.viscosity() == Approx(4. + 0.5 * liquid.bulk_viscosity));
  CHECK(liquid.density == 6.);
  CHECK(!ViscoelasticFluid<2>::stores_deformation_gradient);
}

TEST_CASE("a solid resists until J = 0 and has no stress beyond", "[materials]")
{
  // Squeezed along one axis, J = s: the stress along it, mu (s^2 - 1) + lambda ln s, pushes back ever
  // harder as s goes to 0, up to the smallest number there is, and so does the energy rise. At J = 0
  // and for F turned inside out the logarithm has no value: NaN, in the stress, the energy and the
  // wave speed alike, and not a clamped number. The caller sees J <= 0 and the wave speed first.
  double before = 0., energy_before = 0.;
  for (const double s : {0.5, 0.05, 1e-3, 1e-100, 1e-300})
    {
      Matrix<2> f         = identity<2>();
      f(0, 0)             = s;
      const double stress = solid<2>.kirchhoff_stress(f, Matrix<2>())(0, 0);
      CHECK(stress == Approx(4e4 * (s * s - 1.) + 6e4 * std::log(s)));
      CHECK(stress < before);
      CHECK(solid<2>.energy_density(f) > energy_before);
      CHECK(std::isfinite(solid<2>.wave_speed(f)));
      before        = stress;
      energy_before = solid<2>.energy_density(f);
    }
  for (const double s : {-1e-300, -0.5, -3.})
    {
      Matrix<2> f = identity<2>();
      f(0, 0)     = s;
      CHECK(solid<2>.volume_ratio(f) == s);
      CHECK(std::isnan(solid<2>.kirchhoff_stress(f, Matrix<2>())(0, 0)));
      CHECK(std::isnan(solid<2>.energy_density(f)));
      CHECK(std::isnan(solid<2>.wave_speed(f)));
    }
}

TEST_CASE("J of a fluid never passes zero", "[materials]")
{
  // A step as long as it takes for I + dt grad v to turn inside out leaves J = exp(-3) > 0. Squeezed
  // to nothing a fluid pushes with no more than p = K, its wave speed falls to 0, and all is finite.
  Matrix<2> squeeze;
  squeeze(0, 0) = -300.;
  CHECK(fluid<2>.advanced(1., squeeze, 0.01) == Approx(std::exp(-3.)));
  CHECK(fluid<2>.advanced(1e-300, squeeze, 0.01) > 0.);
  CHECK(fluid<2>.pressure(1e-300) == Approx(2e5));
  CHECK(fluid<2>.wave_speed(1e-300) < 1e-290);
  CHECK(fluid<2>.kirchhoff_stress(1e-300, squeeze)(0, 0) <= 0.);
}

TEST_CASE("a solid particle alone vibrates in bounds at small strains", "[materials]")
{
  // One particle with a lattice of its own: C <- C - dt 4/(dx^2 rho) tau(F), F <- (I + dt C) F, which is
  // what P2G and G2P come to, let loose when stretched by a tenth, almost incompressible, with steps of
  // 0.4 dx/c and 0.3/|C|. J swings no further than 1.4 from its start at 1.21. (From a fifth on it gains
  // energy: at half of these steps it does not.)
  const NeoHookean<2> law = {1., 49., 1.};
  const double dx         = 0.1;
  Matrix<2> f             = 1.1 * identity<2>(), c;
  double largest          = 0.;
  for (int step = 0; step < 2000; ++step)
    {
      const double dt = std::min(0.4 * dx / law.wave_speed(f),
                                 0.3 / std::max(frobenius_norm(c), 1e-9));
      c               = c + (-dt * 4. / (dx * dx)) * law.kirchhoff_stress(f, c);
      f               = law.advanced(f, c, dt);
      largest         = std::max(largest, determinant(f));
      REQUIRE(determinant(f) > 0.);
    }
  CHECK(largest < 1.4);
}
