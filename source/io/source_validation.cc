#include <magmpm/io/given_parameters.h>
#include <magmpm/io/number_text.h>
#include <magmpm/io/section_validation.h>
#include <magmpm/magnets/motion_script.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** A solid magnet excludes material: none may be seeded inside. */
    template <int dim>
    void
    check_magnet_clear_of_bodies(const ParameterRegister &declarations,
                                 const std::string &section,
                                 const SourceParameters<dim> &source,
                                 const Vector<dim> &centre,
                                 const Parameters<dim> &parameters,
                                 const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes)
    {
      for (std::size_t b = 0; b < body_shapes.size(); ++b)
        {
          // From a centre inside a body: zero, so that the overlap is the radius.
          const double from_body = std::max(0., body_shapes[b]->surface_distance(centre).distance);
          const double gap       = from_body - source.radius;
          if (gap < -1e-9 * source.radius)
            throw declarations.error(section + "/Position",
                                     "this solid magnet (radius " + to_text(source.radius) +
                                       " m, at " + components(centre) + " m) overlaps the body '" +
                                       parameters.bodies[b].name + "' by " + to_text(-gap) +
                                       " m at the start. Move one of them, or set " + section +
                                       "/Contact = none.");
        }
    }
  } // namespace

  template <int dim>
  void
  check_sources(const ParameterRegister &declarations,
                const Parameters<dim> &parameters,
                const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes)
  {
    for (const SourceParameters<dim> &source : parameters.sources)
      {
        const std::string section             = "Magnets/" + source.name;
        const std::vector<std::string> field  = {"Field"};
        const std::vector<std::string> sphere = {"Position", "Magnetization", "Radius"};
        const auto at_start = [&](const std::string &name, const std::string &expressions) {
          return MotionScript<dim>(expressions, declarations.where(section + "/" + name)).value(0.);
        };
        check_free_magnet(declarations, section, source);
        if (source.type == SourceType::uniform_field)
          {
            check_given(declarations, section, field, sphere, "Type = uniform field");
            if (source.contact != ContactCondition::none)
              throw declarations.error(section + "/Contact",
                                       "a uniform field has no surface; set it to none.");
            at_start("Field", source.field);
            continue;
          }
        check_given(declarations, section, sphere, field, "Type = magnetized sphere");
        at_start("Magnetization", source.magnetization);
        const Vector<dim> centre = at_start("Position", source.position);
        if (source.contact != ContactCondition::none)
          check_magnet_clear_of_bodies(
            declarations, section, source, centre, parameters, body_shapes);
      }
  }

  template void
  check_sources(const ParameterRegister &,
                const Parameters<2> &,
                const std::vector<std::unique_ptr<Shape<2>>> &);
  template void
  check_sources(const ParameterRegister &,
                const Parameters<3> &,
                const std::vector<std::unique_ptr<Shape<3>>> &);
} // namespace magmpm
