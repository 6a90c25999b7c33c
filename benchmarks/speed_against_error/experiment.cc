#include <speed_against_error/experiment.h>

#include <verification/magnetostatics/accuracy_case.h>
#include <verification/magnetostatics/exact_magnetostatics.h>
#include <verification/magnetostatics/sources.h>

#include <cmath>
#include <limits>

namespace magmpm::benchmarks
{
  using namespace verification;

  namespace
  {
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

    // The dipole near the sphere, in radii: that of the accuracy tests.
    constexpr double dipole_distance      = 3.;
    constexpr double dipole_magnet_radius = 0.3;

    // The magnet near the cube: that of parameter_files/cube_nonlinear.prm, a little closer.
    constexpr double magnet_distance      = 3.;
    constexpr double magnet_radius        = 1.;
    constexpr double magnet_magnetization = 2e6; ///< [A/m]

    Vector<3>
    dipole_magnetization()
    {
      return 1e6 * second_direction<3>();
    }

    Region<3>
    body_region(const ExperimentKind kind, const double radius)
    {
      return kind == ExperimentKind::cube_near_magnet ? cube_region<3>({}, 2. * radius)
                                                      : sphere_region<3>({}, radius);
    }

    Matrix<3>
    deviator(const Matrix<3> &s)
    {
      return s + (-trace(s) / 3.) * identity<3>();
    }
  } // namespace

  const char *
  to_string(const ExperimentKind kind)
  {
    switch (kind)
      {
        case ExperimentKind::sphere_in_uniform_field:
          return "sphere in a uniform field";
        case ExperimentKind::sphere_near_dipole:
          return "sphere near a dipole";
        case ExperimentKind::cube_near_magnet:
          return "cube near a magnet";
      }
    return "";
  }

  Vector<3>
  Experiment::travel_direction()
  {
    return oblique_direction<3>();
  }

  Experiment::Experiment(const ExperimentKind kind,
                         const int resolution,
                         const unsigned int offset,
                         const Medium &medium)
    : kind(kind)
    , resolution(resolution)
    , spacing(case_spacing)
    , radius(resolution * case_spacing)
    , law(kind == ExperimentKind::sphere_near_dipole ? MagnetizationLaw::linear
                                                     : MagnetizationLaw::langevin)
    , content{3. * medium.susceptibility / argument_per_field, medium.susceptibility}
    , medium(medium)
  {
    RandomNumbers random(offset + 1);
    shift        = random.vector_between<3>(-0.5 * spacing, 0.5 * spacing);
    local_points = jittered_points(body_region(kind, radius), 0.5 * spacing, random);
    if (kind == ExperimentKind::cube_near_magnet)
      volume = std::pow(2. * radius, 3);
    else
      volume = ellipsoid_volume<3>({{radius, radius, radius}});
    if (kind == ExperimentKind::sphere_in_uniform_field)
      exact_field = (medium.argument / argument_per_field) * oblique_direction<3>();
  }

  std::vector<Vector<3>>
  Experiment::points(const Vector<3> &middle, const bool is_moved) const
  {
    std::vector<Vector<3>> result = local_points;
    for (Vector<3> &point : result)
      point += centre(middle, is_moved);
    return result;
  }

  ExternalField<3>
  Experiment::sources(const Vector<3> &middle) const
  {
    const Vector<3> origin = centre(middle, false);
    switch (kind)
      {
        case ExperimentKind::sphere_in_uniform_field:
          return ExternalField<3>(
            {uniform_source(exact_field + (1. / 3.) * magnetization(law, content, exact_field))});
        case ExperimentKind::sphere_near_dipole:
          return ExternalField<3>(
            {magnet_source(origin + dipole_distance * radius * oblique_direction<3>(),
                           dipole_magnet_radius * radius,
                           dipole_magnetization())});
        case ExperimentKind::cube_near_magnet:
          break;
      }
    return ExternalField<3>(
      {magnet_source(origin + magnet_distance * radius * oblique_direction<3>(),
                     magnet_radius * radius,
                     magnet_magnetization * second_direction<3>())});
  }

  StateErrors
  Experiment::errors(const MagneticState &state) const
  {
    if (kind == ExperimentKind::sphere_near_dipole)
      {
        const double magnet   = dipole_magnet_radius * radius;
        const Vector<3> exact = force_of_dipole_on_sphere<3>(
          content.initial_susceptibility,
          radius,
          dipole_distance * radius * oblique_direction<3>(),
          ellipsoid_volume<3>({{magnet, magnet, magnet}}) * dipole_magnetization());
        return {not_a_number, relative_error(state.force, exact), not_a_number, not_a_number};
      }
    const Vector<3> exact     = magnetization(law, content, exact_field);
    const Matrix<3> traction  = deviator(surface_virial_of_sphere(volume, exact));
    const Matrix<3> deviation = deviator(state.virial) + (-1.) * traction;
    return {relative_error(state.moment, volume * exact),
            not_a_number,
            state.field_rms / norm(exact_field),
            frobenius_norm(deviation) / frobenius_norm(traction)};
  }

  StateErrors
  Experiment::errors(const MagneticState &state,
                     const Experiment &finer,
                     const MagneticState &reference) const
  {
    const double scale = radius / finer.radius;
    return {relative_error(state.moment, std::pow(scale, 3) * reference.moment),
            relative_error(state.force, std::pow(scale, 2) * reference.force),
            not_a_number,
            not_a_number};
  }
} // namespace magmpm::benchmarks
