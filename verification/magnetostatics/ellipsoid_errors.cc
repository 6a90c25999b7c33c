#include <magmpm/base/constants.h>

#include <verification/magnetostatics/ellipsoid_errors.h>
#include <verification/magnetostatics/exact_magnetostatics.h>
#include <verification/magnetostatics/sources.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double outer_field = 1e5; ///< [A/m]; errors do not depend on it

    /** An ellipsoid of the case's medium, its axes oblique to the lattice, in a uniform field. */
    template <int dim>
    class Ellipsoid
    {
    public:
      explicit Ellipsoid(const Vector<dim> &half_axes)
        : half_axes(half_axes)
      {
        // The second axis is what second_direction() has across the first.
        const Vector<dim> e = oblique_direction<dim>(), other = second_direction<dim>();
        Vector<dim> across = other - dot(other, e) * e;
        across             = (1. / norm(across)) * across;
        Vector<dim> rows[] = {e, across, {}};
        if constexpr (dim == 3)
          rows[2] = cross(e, across);
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j)
            axes(i, j) = rows[i][j];
      }

      double
      volume() const
      {
        return ellipsoid_volume(half_axes);
      }

      Region<dim>
      region(const Vector<dim> &centre) const
      {
        return ellipsoid_region(centre, half_axes, axes);
      }

      /** A vector given along the axes. */
      Vector<dim>
      in_space(const Vector<dim> &along_axes) const
      {
        return transpose(axes) * along_axes;
      }

      /** M in a field, both given in space. */
      Vector<dim>
      exact_magnetization(const AccuracyCase &accuracy_case, const Vector<dim> &field) const
      {
        return in_space(ellipsoid_in_uniform_field(accuracy_case.law(),
                                                   accuracy_case.content(),
                                                   demagnetizing_factors(half_axes),
                                                   axes * field)
                          .magnetization);
      }

    private:
      Vector<dim> half_axes;
      Matrix<dim> axes; ///< as rows
    };

    template <int dim>
    Vector<dim>
    unit_vector(const int axis)
    {
      Vector<dim> v;
      v[axis] = 1.;
      return v;
    }

    /** sum r x f from S(a,b) = sum f_a r_b. */
    template <int dim>
    Vector<n_axial_components<dim>>
    torque_of(const Matrix<dim> &s)
    {
      if constexpr (dim == 3)
        return {{s(2, 1) - s(1, 2), s(0, 2) - s(2, 0), s(1, 0) - s(0, 1)}};
      else
        return {{s(1, 0) - s(0, 1)}};
    }

    /**
     * Of the number of grains in the medium at the quadrature points, which is that of the
     * particles.
     */
    template <int dim>
    double
    grain_error(const CaseSetup<dim> &setup, const PointBody<dim> &body)
    {
      const double found = setup.magnetics.template integral<double>(
        [](const MaterialSample<dim> &sample) { return sample.number_density; });
      return found / (body.volume * body.magnetic.number_density) - 1.;
    }

    /**
     * The moment of a body in a uniform field: relative error, and that of its part along the
     * exact.
     */
    struct MomentError
    {
      double all;
      double along;
    };

    template <int dim>
    MomentError
    moment_error(CaseSetup<dim> &setup,
                 const PointBody<dim> &body,
                 const Vector<dim> &field,
                 const Vector<dim> &exact_magnetization)
    {
      setup.magnetics.set_bodies({body});
      setup.magnetics.solve(ExternalField<dim>({uniform_source(field)}));
      const Vector<dim> exact = body.volume * exact_magnetization;
      const Vector<dim> found = setup.magnetics.moment();
      return {relative_error(found, exact), dot(found, exact) / norm_square(exact) - 1.};
    }
  } // namespace

  template <int dim>
  Errors
  torque_errors(const AccuracyCase &accuracy_case)
  {
    const double short_axis = accuracy_case.resolution * case_spacing / std::pow(2., 1. / dim);
    Vector<dim> half_axes;
    for (int d = 0; d < dim; ++d)
      half_axes[d] = (d == 0 ? 2. : 1.) * short_axis;
    const Ellipsoid<dim> spheroid(half_axes);
    const Vector<dim> field = (outer_field / std::sqrt(2.)) *
                              spheroid.in_space(unit_vector<dim>(0) + unit_vector<dim>(1));
    const Vector<dim> magnetization = spheroid.exact_magnetization(accuracy_case, field);

    CaseSetup<dim> setup(accuracy_case, 4. * accuracy_case.resolution);
    const PointBody<dim> body = setup.body(spheroid.region(setup.centre), spheroid.volume());
    const double moment       = moment_error(setup, body, field, magnetization).all;
    const auto exact = (constants::vacuum_permeability * body.volume) * cross(magnetization, field);
    return {{"torque", relative_error(torque_of(setup.magnetics.virial(setup.centre)), exact)},
            {"torque, particles",
             relative_error(torque_of(setup.magnetics.virial_of_particles(setup.centre)), exact)},
            {"dipole moment", moment}};
  }

  template <int dim>
  Errors
  sheet_errors(const AccuracyCase &accuracy_case)
  {
    Vector<dim> half_axes;
    for (int d = 0; d < dim; ++d)
      half_axes[d] = (d < dim - 1 ? 12. : 0.5 * accuracy_case.resolution) * case_spacing;
    const Ellipsoid<dim> sheet(half_axes);
    CaseSetup<dim> setup(accuracy_case, 32.);
    const PointBody<dim> body = setup.body(sheet.region(setup.centre), sheet.volume());

    const auto error = [&](const int axis) {
      const Vector<dim> field = outer_field * sheet.in_space(unit_vector<dim>(axis));
      return moment_error(setup, body, field, sheet.exact_magnetization(accuracy_case, field))
        .along;
    };
    return {{"moment, field in the plane", error(0)}, {"moment, field across", error(dim - 1)}};
  }

  template <int dim>
  Errors
  drop_errors(const AccuracyCase &accuracy_case)
  {
    Vector<dim> half_axes;
    for (int d = 0; d < dim; ++d)
      half_axes[d] = accuracy_case.resolution * case_spacing;
    const Ellipsoid<dim> drop(half_axes);
    const Vector<dim> field = outer_field * oblique_direction<dim>();
    CaseSetup<dim> setup(accuracy_case, 16.);
    const PointBody<dim> body = setup.body(drop.region(setup.centre), drop.volume());
    const MomentError moment =
      moment_error(setup, body, field, drop.exact_magnetization(accuracy_case, field));
    return {{"moment along H_0", moment.along},
            {"dipole moment", moment.all},
            {"number of grains", grain_error(setup, body)}};
  }

  template <int dim>
  Errors
  particle_errors(const AccuracyCase &accuracy_case)
  {
    const Vector<dim> field = outer_field * oblique_direction<dim>();
    CaseSetup<dim> setup(accuracy_case, 16.);
    PointBody<dim> particle = setup.body(sphere_region(setup.centre, 0.), 1.);
    particle.volume         = std::pow(case_spacing / (dim == 3 ? 2. : 3.), dim);
    const Vector<dim> exact =
      sphere_in_uniform_field(accuracy_case.law(), accuracy_case.content(), field).magnetization;
    const MomentError moment = moment_error(setup, particle, field, exact);
    return {{"moment along H_0", moment.along},
            {"dipole moment", moment.all},
            {"number of grains", grain_error(setup, particle)}};
  }

#define MAGMPM_INSTANTIATE(dim)                             \
  template Errors torque_errors<dim>(const AccuracyCase &); \
  template Errors sheet_errors<dim>(const AccuracyCase &);  \
  template Errors drop_errors<dim>(const AccuracyCase &);   \
  template Errors particle_errors<dim>(const AccuracyCase &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm::verification
