#include <verification/magnetostatics/exact_magnetostatics.h>
#include <verification/magnetostatics/pair_errors.h>
#include <verification/magnetostatics/sources.h>
#include <verification/magnetostatics/two_spheres.h>

#include <algorithm>

namespace magmpm::verification
{
  namespace
  {
    constexpr double outer_field = 1e5; ///< [A/m]; errors do not depend on it

    /** Measured quantities of two spheres, beside the exact ones. */
    template <int dim>
    struct PairResult
    {
      std::array<Vector<dim>, 2> moment;
      std::array<Vector<dim>, 2> force;
      TwoSpheresSolution<dim> exact;

      double
      moment_error(const int s) const
      {
        return relative_error(moment[s], exact.moment[s]);
      }

      double
      third_law() const
      {
        return norm(force[0] + force[1]) / norm(exact.force_on_second);
      }
    };

    /** Radii and susceptibilities given, the gap is half the radius of the first. */
    template <int dim>
    PairResult<dim>
    solve_pair(const AccuracyCase &accuracy_case, TwoSpheres<dim> spheres)
    {
      const double gap        = 0.5 * spheres.radius[0];
      const double distance   = spheres.radius[0] + gap + spheres.radius[1];
      const double length     = distance + spheres.radius[0] + spheres.radius[1];
      spheres.separation      = distance * oblique_direction<dim>();
      const Vector<dim> field = outer_field * second_direction<dim>();

      // The middle of the whole comes to that of the box; this is wide, since the force of an open
      // face on the pair counts as a violation of the third law.
      CaseSetup<dim> setup(accuracy_case, 8. * accuracy_case.resolution);
      const Vector<dim> first = setup.centre -
                                (0.5 * length - spheres.radius[0]) * oblique_direction<dim>();
      const Vector<dim> centres[2] = {first, first + spheres.separation};
      std::vector<PointBody<dim>> bodies;
      for (int s = 0; s < 2; ++s)
        {
          bodies.push_back(setup.sphere(centres[s], spheres.radius[s]));
          bodies.back().magnetic.initial_susceptibility = spheres.susceptibility[s];
        }
      setup.magnetics.set_bodies(bodies);
      setup.magnetics.solve(ExternalField<dim>({uniform_source(field)}));

      PairResult<dim> result;
      result.exact       = two_spheres_in_uniform_field(spheres, field);
      const auto surface = [&](const Vector<dim> &x, const int s) {
        return norm(x - centres[s]) - spheres.radius[s];
      };
      for (int s = 0; s < 2; ++s)
        {
          result.force[s] = setup.magnetics.force_on_body(s);
          result.moment[s] =
            setup.magnetics.template integral<Vector<dim>>([&](const auto &sample) {
              const bool is_nearer = surface(sample.position, s) < surface(sample.position, 1 - s);
              return is_nearer ? sample.magnetization : Vector<dim>();
            });
        }
      return result;
    }
  } // namespace

  template <int dim>
  Errors
  pair_errors(const AccuracyCase &accuracy_case)
  {
    const double radius = accuracy_case.resolution * case_spacing;
    const double chi    = accuracy_case.susceptibility;
    const auto result   = solve_pair<dim>(accuracy_case, {{radius, radius}, {chi, chi}, {}});
    return {
      {"third law", result.third_law()},
      {"pair force",
       relative_error(0.5 * (result.force[1] - result.force[0]), result.exact.force_on_second)},
      {"dipole moment", std::max(result.moment_error(0), result.moment_error(1))}};
  }

  template <int dim>
  Errors
  unequal_pair_errors(const AccuracyCase &accuracy_case, const double small_susceptibility)
  {
    const double radius = accuracy_case.resolution * case_spacing;
    const auto result   = solve_pair<dim>(
      accuracy_case,
      {{radius, 0.5 * radius}, {accuracy_case.susceptibility, small_susceptibility}, {}});
    return {{"third law", result.third_law()},
            {"pair force", relative_error(result.force[1], result.exact.force_on_second)},
            {"moment, large", result.moment_error(0)},
            {"moment, small", result.moment_error(1)}};
  }

#define MAGMPM_INSTANTIATE(dim)                           \
  template Errors pair_errors<dim>(const AccuracyCase &); \
  template Errors unequal_pair_errors<dim>(const AccuracyCase &, const double);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm::verification
