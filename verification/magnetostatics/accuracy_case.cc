#include <verification/magnetostatics/accuracy_case.h>
#include <verification/magnetostatics/exact_magnetostatics.h>

#include <cmath>
#include <stdexcept>

namespace magmpm::verification
{
  namespace
  {
    template <int dim>
    Lattice<dim>
    case_lattice(const double width)
    {
      Lattice<dim> lattice;
      lattice.spacing = case_spacing;
      lattice.n_cells.fill(8 * static_cast<int>(std::ceil(width / 8. - 1e-9)));
      return lattice;
    }

    template <int dim>
    MeshParameters<dim>
    case_mesh(const AccuracyCase &accuracy_case)
    {
      MeshParameters<dim> parameters;
      parameters.potential_box_factor = accuracy_case.box_factor;
      parameters.cell_edge            = accuracy_case.cell_edge;
      return parameters;
    }

    template <int dim>
    MagneticsParameters<dim>
    case_magnetics(const AccuracyCase &accuracy_case)
    {
      MagneticsParameters<dim> parameters;
      parameters.law       = accuracy_case.law();
      parameters.indicator = accuracy_case.indicator;
      return parameters;
    }

    template <int dim>
    Vector<dim>
    unit(const Vector<dim> &v)
    {
      return (1. / norm(v)) * v;
    }
  } // namespace

  double
  find_error(const Errors &errors, const std::string &name)
  {
    for (const NamedError &error : errors)
      if (error.name == name)
        return error.value;
    throw std::logic_error("no error '" + name + "' was measured");
  }

  MagneticContent
  AccuracyCase::content() const
  {
    return {3. * susceptibility / argument_per_field, susceptibility};
  }

  template <int dim>
  CaseSetup<dim>::CaseSetup(const AccuracyCase &accuracy_case, const double width)
    : accuracy_case(accuracy_case)
    , lattice(case_lattice<dim>(width))
    , random(accuracy_case.offset + 1)
    , centre(0.5 * lattice.upper_corner() +
             random.template vector_between<dim>(-case_spacing, case_spacing))
    , magnetics(accuracy_case.communicator,
                lattice,
                case_mesh<dim>(accuracy_case),
                case_magnetics<dim>(accuracy_case))
  {
  }

  template <int dim>
  PointBody<dim>
  CaseSetup<dim>::body(const Region<dim> &region, const double volume)
  {
    constexpr int per_edge        = (dim == 3 ? 2 : 3);
    const MagneticContent content = accuracy_case.content();
    PointBody<dim> result;
    result.points = jittered_points(region, case_spacing / per_edge, random);
    if (result.points.empty())
      result.points = {region.centre};
    result.volume   = volume;
    result.magnetic = {content.saturation_magnetization, content.initial_susceptibility, 1e24};
    return result;
  }

  template <int dim>
  PointBody<dim>
  CaseSetup<dim>::sphere(const Vector<dim> &sphere_centre, const double radius)
  {
    const double stretch = accuracy_case.stretch;
    Vector<dim> half_axes;
    for (int d = 0; d < dim; ++d)
      half_axes[d] = radius;
    const double volume = ellipsoid_volume(half_axes);

    half_axes[0] /= stretch;
    PointBody<dim> result = body(ellipsoid_region(sphere_centre, half_axes, identity<dim>()),
                                 volume);
    for (Vector<dim> &point : result.points)
      point[0] = sphere_centre[0] + stretch * (point[0] - sphere_centre[0]);
    result.deformation(0, 0) = stretch;
    // Undeformed there was more in a volume.
    result.magnetic.saturation_magnetization *= stretch;
    result.magnetic.initial_susceptibility *= stretch;
    result.magnetic.number_density *= stretch;
    return result;
  }

  template <int dim>
  Vector<dim>
  oblique_direction()
  {
    if constexpr (dim == 3)
      return {{0.8 * std::cos(0.35), 0.8 * std::sin(0.35), 0.6}};
    else
      return {{std::cos(0.35), std::sin(0.35)}};
  }

  template <int dim>
  Vector<dim>
  second_direction()
  {
    if constexpr (dim == 3)
      return unit<3>({{0.2, 1., 0.5}});
    else
      return {{std::cos(1.), std::sin(1.)}};
  }

  template class CaseSetup<2>;
  template class CaseSetup<3>;
  template Vector<2>
  oblique_direction();
  template Vector<3>
  oblique_direction();
  template Vector<2>
  second_direction();
  template Vector<3>
  second_direction();
} // namespace magmpm::verification
