#include <magmpm/io/parameter_sections.h>

namespace magmpm
{
  template <int dim>
  void
  declare_source(ParameterRegister &declarations, SourceParameters<dim> &source)
  {
    const auto section           = declarations.enter(source.name);
    const std::string components = " Expressions of t [s], separated by semicolons.";
    declarations.add("Type",
                     source.type,
                     {{"uniform field", SourceType::uniform_field},
                      {"magnetized sphere", SourceType::magnetized_sphere}},
                     "Kind of source; in 2D a sphere is a cylinder magnetized across its axis.");
    declarations.add(
      "Field", source.field, "A/m", "Of a uniform field: H(t)." + components, Presence::optional);
    declarations.add("Position",
                     source.position,
                     "m",
                     "Of a magnetized sphere: its centre x(t)." + components,
                     Presence::optional);
    declarations.add("Magnetization",
                     source.magnetization,
                     "A/m",
                     "Of a magnetized sphere: M(t)." + components,
                     Presence::optional);
    declarations.add("Radius",
                     source.radius,
                     "m",
                     "Of a magnetized sphere: its radius.",
                     positive,
                     Presence::optional);
    declarations.add("Contact",
                     source.contact,
                     {{"none", ContactCondition::none},
                      {"stick", ContactCondition::stick},
                      {"slip", ContactCondition::slip},
                      {"separate", ContactCondition::separate}},
                     "Of a magnetized sphere: what material does at its surface; none: it has no "
                     "surface.");
    declare_free_magnet(declarations, source);
  }

  template void
  declare_source(ParameterRegister &, SourceParameters<2> &);
  template void
  declare_source(ParameterRegister &, SourceParameters<3> &);
} // namespace magmpm
