#include <verification/magnetostatics/sources.h>

namespace magmpm::verification
{
  template <int dim>
  SourceParameters<dim>
  uniform_source(const Vector<dim> &field)
  {
    SourceParameters<dim> source;
    source.name = "uniform field";
    source.kind = UniformFieldParameters<dim>{field};
    return source;
  }

  template <int dim>
  SourceParameters<dim>
  magnet_source(const Vector<dim> &centre, const double radius, const Vector<dim> &magnetization)
  {
    SourceParameters<dim> source;
    source.name = "magnet";
    source.kind = MagnetizedSphereParameters<dim>{magnetization, radius};
    source.pose = Pose<dim>{centre};
    return source;
  }

  template SourceParameters<2>
  uniform_source(const Vector<2> &);
  template SourceParameters<3>
  uniform_source(const Vector<3> &);
  template SourceParameters<2>
  magnet_source(const Vector<2> &, const double, const Vector<2> &);
  template SourceParameters<3>
  magnet_source(const Vector<3> &, const double, const Vector<3> &);
} // namespace magmpm::verification
