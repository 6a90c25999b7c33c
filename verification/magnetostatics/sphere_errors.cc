#include <magmpm/base/constants.h>

#include <verification/magnetostatics/exact_magnetostatics.h>
#include <verification/magnetostatics/sources.h>
#include <verification/magnetostatics/sphere_errors.h>

#include <array>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double linear_outer_field = 1e5; ///< [A/m]; errors do not depend on it

    template <int dim>
    double
    sphere_volume(const double radius)
    {
      Vector<dim> half_axes;
      for (int d = 0; d < dim; ++d)
        half_axes[d] = radius;
      return ellipsoid_volume(half_axes);
    }

    /** H_0 along oblique_direction(): with the Langevin law, such that a is as asked for inside. */
    template <int dim>
    Vector<dim>
    outer_field(const AccuracyCase &accuracy_case)
    {
      if (accuracy_case.law() == MagnetizationLaw::linear)
        return linear_outer_field * oblique_direction<dim>();
      const Vector<dim> inside = (accuracy_case.argument / argument_per_field) *
                                 oblique_direction<dim>();
      return inside +
             (1. / dim) * magnetization<dim>(accuracy_case.law(), accuracy_case.content(), inside);
    }

    /** S along e, without its trace. */
    template <int dim>
    double
    deviator(const Matrix<dim> &s, const Vector<dim> &e)
    {
      const double along = dot(e, s * e);
      return along - (trace(s) - along) / (dim - 1.);
    }

    /** A dipole near a sphere, made by a magnet of a given radius. */
    template <int dim>
    struct DipoleField
    {
      Vector<dim> place; ///< from the centre of the sphere
      double magnet_radius;
      Vector<dim> magnetization;
      bool is_solid = false;

      ExternalField<dim>
      sources(const Vector<dim> &sphere_centre) const
      {
        SourceParameters<dim> source =
          magnet_source(sphere_centre + place, magnet_radius, magnetization);
        source.is_solid = is_solid;
        return ExternalField<dim>({source});
      }

      Vector<dim>
      exact_force(const double susceptibility, const double radius) const
      {
        return force_of_dipole_on_sphere(
          susceptibility, radius, place, sphere_volume<dim>(magnet_radius) * magnetization);
      }
    };

    /** A dipole 3 R away, oblique to the lattice and to the line of centres. */
    template <int dim>
    DipoleField<dim>
    dipole_at_three_radii(const double radius)
    {
      return {3. * radius * oblique_direction<dim>(), 0.3 * radius, 1e6 * second_direction<dim>()};
    }

    /** Relative error of the force of a dipole. */
    template <int dim>
    double
    force_error(const AccuracyCase &accuracy_case, const DipoleField<dim> &dipole)
    {
      const double radius = accuracy_case.resolution * case_spacing;
      CaseSetup<dim> setup(accuracy_case, 4. * accuracy_case.resolution);
      setup.magnetics.set_bodies({setup.sphere(setup.centre, radius)});
      setup.magnetics.solve(dipole.sources(setup.centre));
      return relative_error(setup.magnetics.force(),
                            dipole.exact_force(accuracy_case.susceptibility, radius));
    }

    /** Rms of what a cubic polynomial leaves of values at equidistant points. */
    double
    rms_beside_cubic(std::vector<double> values)
    {
      const std::size_t n      = values.size();
      const auto subtract_part = [n](std::vector<double> &from, const std::vector<double> &of) {
        double product = 0., square = 0.;
        for (std::size_t i = 0; i < n; ++i)
          {
            product += from[i] * of[i];
            square += of[i] * of[i];
          }
        for (std::size_t i = 0; i < n; ++i)
          from[i] -= product / square * of[i];
      };
      std::array<std::vector<double>, 4> orthogonal;
      for (int power = 0; power < 4; ++power)
        {
          for (std::size_t i = 0; i < n; ++i)
            orthogonal[power].push_back(std::pow(2. * i / (n - 1.) - 1., power));
          for (int lower = 0; lower < power; ++lower)
            subtract_part(orthogonal[power], orthogonal[lower]);
          subtract_part(values, orthogonal[power]);
        }
      double sum = 0.;
      for (const double value : values)
        sum += value * value / n;
      return std::sqrt(sum);
    }
  } // namespace

  template <int dim>
  Errors
  uniform_field_errors(const AccuracyCase &accuracy_case)
  {
    const double radius         = accuracy_case.resolution * case_spacing;
    const double volume         = sphere_volume<dim>(radius);
    const Vector<dim> field     = outer_field<dim>(accuracy_case);
    const Vector<dim> direction = oblique_direction<dim>();
    const UniformState<dim> exact =
      sphere_in_uniform_field(accuracy_case.law(), accuracy_case.content(), field);

    CaseSetup<dim> setup(accuracy_case, 4. * accuracy_case.resolution);
    setup.magnetics.set_bodies({setup.sphere(setup.centre, radius)});
    setup.magnetics.solve(ExternalField<dim>({uniform_source(field)}));

    const auto inner = [&](const auto &value) {
      return [&, value](const MaterialSample<dim> &sample) {
        return norm(sample.position - setup.centre) < 0.7 * radius
                 ? value(sample.field - exact.field)
                 : decltype(value(sample.field))();
      };
    };
    const double inner_volume =
      setup.magnetics.template integral<double>(inner([](const Vector<dim> &) { return 1.; }));
    const double mean_square = setup.magnetics.template integral<double>(
                                 inner([](const Vector<dim> &h) { return norm_square(h); })) /
                               inner_volume;
    const Vector<dim> mean = (1. / inner_volume) * setup.magnetics.template integral<Vector<dim>>(
                                                     inner([](const Vector<dim> &h) { return h; }));

    const Matrix<dim> exact_virial = surface_virial_of_sphere(volume, exact.magnetization);
    const Matrix<dim> virial       = setup.magnetics.virial(setup.centre);
    const Matrix<dim> carried      = setup.magnetics.virial_of_particles(setup.centre);
    const double exact_deviator    = deviator(exact_virial, direction);
    const double net_scale = constants::vacuum_permeability * norm_square(exact.magnetization) *
                             volume / radius;
    return {{"dipole moment",
             relative_error(setup.magnetics.moment(), volume * exact.magnetization)},
            {"rms H inside 0.7 R", std::sqrt(mean_square) / norm(exact.field)},
            {"mean H inside 0.7 R", norm(mean) / norm(exact.field)},
            {"virial deviator", deviator(virial, direction) / exact_deviator - 1.},
            {"virial deviator, particles", deviator(carried, direction) / exact_deviator - 1.},
            {"virial trace", trace(virial) / trace(exact_virial) - 1.},
            {"net force", norm(setup.magnetics.force()) / net_scale}};
  }

  template <int dim>
  Errors
  dipole_field_errors(const AccuracyCase &accuracy_case)
  {
    const double radius = accuracy_case.resolution * case_spacing;
    return {{"dipole force", force_error(accuracy_case, dipole_at_three_radii<dim>(radius))}};
  }

  template <int dim>
  Errors
  sphere_errors(const AccuracyCase &accuracy_case)
  {
    Errors errors = uniform_field_errors<dim>(accuracy_case);
    if (accuracy_case.law() == MagnetizationLaw::linear)
      errors.push_back(dipole_field_errors<dim>(accuracy_case).front());
    return errors;
  }

  template <int dim>
  Errors
  magnet_errors(const AccuracyCase &accuracy_case)
  {
    const double radius = accuracy_case.resolution * case_spacing;
    const auto error_at = [&](const double distance) {
      return force_error<dim>(accuracy_case,
                              {distance * radius * oblique_direction<dim>(),
                               0.6 * radius,
                               2e6 * second_direction<dim>(),
                               true});
    };
    return {{"force", error_at(1.8)}, {"force in contact", error_at(1.6)}};
  }

  template <int dim>
  Errors
  box_errors(const AccuracyCase &accuracy_case)
  {
    const double radius           = accuracy_case.resolution * case_spacing;
    const DipoleField<dim> dipole = dipole_at_three_radii<dim>(radius);
    AccuracyCase wide             = accuracy_case;
    wide.box_factor *= 16.;

    const auto moment_and_force = [&](const AccuracyCase &boxed) {
      CaseSetup<dim> setup(boxed, 32.);
      setup.magnetics.set_bodies({setup.sphere(setup.centre, radius)});
      setup.magnetics.solve(ExternalField<dim>({uniform_source(outer_field<dim>(boxed))}));
      const Vector<dim> moment = setup.magnetics.moment();
      setup.magnetics.solve(dipole.sources(setup.centre));
      return std::array<Vector<dim>, 2>{moment, setup.magnetics.force()};
    };
    const auto narrow_box = moment_and_force(accuracy_case);
    const auto wide_box   = moment_and_force(wide);
    return {{"dipole moment, box", relative_error(narrow_box[0], wide_box[0])},
            {"dipole force, box", relative_error(narrow_box[1], wide_box[1])}};
  }

  template <int dim>
  Errors
  translation_errors(const AccuracyCase &accuracy_case)
  {
    constexpr int n_steps         = 16;
    const double step             = 4. * case_spacing / n_steps;
    const double radius           = accuracy_case.resolution * case_spacing;
    const DipoleField<dim> dipole = dipole_at_three_radii<dim>(radius);
    const Vector<dim> direction   = oblique_direction<dim>();

    CaseSetup<dim> setup(accuracy_case, 4. * accuracy_case.resolution);
    PointBody<dim> body              = setup.sphere(setup.centre, radius);
    const ExternalField<dim> sources = dipole.sources(setup.centre);
    std::array<std::vector<double>, dim> ratios;
    double work = 0., first_energy = 0., last_energy = 0.;
    for (int i = 0; i <= n_steps; ++i)
      {
        setup.magnetics.set_bodies({body});
        last_energy             = setup.magnetics.solve(sources).energy;
        const Vector<dim> force = setup.magnetics.force();
        if (i == 0)
          first_energy = last_energy;
        // Simpson's rule.
        work += step / 3. * (i == 0 || i == n_steps ? 1. : (i % 2 == 1 ? 4. : 2.)) *
                dot(force, direction);

        DipoleField<dim> moved = dipole;
        moved.place -= (i * step) * direction;
        const double exact = norm(moved.exact_force(accuracy_case.susceptibility, radius));
        for (int d = 0; d < dim; ++d)
          ratios[d].push_back(force[d] / exact);
        for (Vector<dim> &point : body.points)
          point += step * direction;
      }
    double noise = 0.;
    for (int d = 0; d < dim; ++d)
      noise += std::pow(rms_beside_cubic(ratios[d]), 2);
    return {{"force noise", std::sqrt(noise)}, {"work", work / (first_energy - last_energy) - 1.}};
  }

#define MAGMPM_INSTANTIATE(dim)                                    \
  template Errors uniform_field_errors<dim>(const AccuracyCase &); \
  template Errors dipole_field_errors<dim>(const AccuracyCase &);  \
  template Errors sphere_errors<dim>(const AccuracyCase &);        \
  template Errors magnet_errors<dim>(const AccuracyCase &);        \
  template Errors box_errors<dim>(const AccuracyCase &);           \
  template Errors translation_errors<dim>(const AccuracyCase &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm::verification
