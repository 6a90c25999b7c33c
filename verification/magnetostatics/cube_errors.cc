#include <verification/magnetostatics/cube_errors.h>
#include <verification/magnetostatics/sources.h>

#include <cmath>

namespace magmpm::verification
{
  template <int dim>
  typename CubeErrors<dim>::Result
  CubeErrors<dim>::solve(const AccuracyCase &accuracy_case)
  {
    const double edge = accuracy_case.resolution * case_spacing;
    CaseSetup<dim> setup(accuracy_case, 2. * accuracy_case.resolution);
    setup.magnetics.set_bodies({setup.body(cube_region(setup.centre, edge), std::pow(edge, dim))});

    Result result;
    setup.magnetics.solve(ExternalField<dim>({uniform_source(1e5 * second_direction<dim>())}));
    result.moment = (1. / std::pow(edge, dim)) * setup.magnetics.moment();
    setup.magnetics.solve(
      ExternalField<dim>({magnet_source(setup.centre + 1.5 * edge * oblique_direction<dim>(),
                                        0.15 * edge,
                                        1e6 * second_direction<dim>())}));
    result.force = (1. / std::pow(edge, dim - 1)) * setup.magnetics.force();
    return result;
  }

  template <int dim>
  Errors
  CubeErrors<dim>::operator()(const AccuracyCase &accuracy_case)
  {
    if (!reference)
      reference = solve(fine);
    const Result result = solve(accuracy_case);
    return {{"dipole moment", relative_error(result.moment, reference->moment)},
            {"dipole force", relative_error(result.force, reference->force)}};
  }

  template class CubeErrors<2>;
  template class CubeErrors<3>;
} // namespace magmpm::verification
