#include <verification/magnetostatics/sources.h>

#include <cstdio>

namespace magmpm::verification
{
  namespace
  {
    /** "1; 2; 3", to the last digit. */
    template <int dim>
    std::string
    vector_text(const Vector<dim> &v)
    {
      std::string text;
      char number[32];
      for (int d = 0; d < dim; ++d)
        {
          std::snprintf(number, sizeof(number), "%.17g", v[d]);
          text += (d == 0 ? "" : "; ") + std::string(number);
        }
      return text;
    }
  } // namespace

  template <int dim>
  SourceParameters<dim>
  uniform_source(const Vector<dim> &field)
  {
    SourceParameters<dim> source;
    source.name  = "uniform field";
    source.type  = SourceType::uniform_field;
    source.field = vector_text(field);
    return source;
  }

  template <int dim>
  SourceParameters<dim>
  magnet_source(const Vector<dim> &centre, const double radius, const Vector<dim> &magnetization)
  {
    SourceParameters<dim> source;
    source.name          = "magnet";
    source.type          = SourceType::magnetized_sphere;
    source.position      = vector_text(centre);
    source.magnetization = vector_text(magnetization);
    source.radius        = radius;
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
