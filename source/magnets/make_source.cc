#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/make_source.h>
#include <magmpm/magnets/placed_source.h>

namespace magmpm
{
  namespace
  {
    template <int dim>
    std::unique_ptr<MagneticSource<dim>>
    make(const SourceParameters<dim> &parameters, const UniformFieldParameters<dim> &kind)
    {
      if (parameters.is_solid)
        throw InputError("Source '" + parameters.name +
                         "' is a uniform field, which has no surface, but has a contact condition. "
                         "Set it to none.");
      return std::make_unique<UniformField<dim>>(parameters.name, kind);
    }

    template <int dim, typename Kind>
    std::unique_ptr<MagneticSource<dim>>
    make(const SourceParameters<dim> &parameters, const Kind &kind)
    {
      SourceParts<dim> parts = make_parts(kind, parameters.name);
      if (parameters.is_solid && kind.interior != Interior::may_be_solid)
        throw InputError("Source '" + parameters.name +
                         "' has no surface, but has a contact condition. Set it to none.");
      return std::make_unique<PlacedSource<dim>>(parameters, std::move(parts));
    }
  } // namespace

  template <int dim>
  std::unique_ptr<MagneticSource<dim>>
  make_source(const SourceParameters<dim> &parameters)
  {
    return std::visit([&](const auto &kind) { return make(parameters, kind); }, parameters.kind);
  }

  template std::unique_ptr<MagneticSource<2>>
  make_source(const SourceParameters<2> &);
  template std::unique_ptr<MagneticSource<3>>
  make_source(const SourceParameters<3> &);
} // namespace magmpm
