// The checks of the section Magnets, and what they make of it.

#include <magmpm/base/number_text.h>
#include <magmpm/geometry/placed_shape.h>
#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/magnets/make_source.h>
#include <magmpm/parameters/free_body_section.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/input_file.h>
#include <magmpm/parameters/magnet_section.h>
#include <magmpm/parameters/source_kinds.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    template <int dim>
    void
    check_contact(const GivenMagnet<dim> &magnet)
    {
      const SurfaceContact &contact = magnet.input.body.contact;
      const KindOfSource<dim> &kind = *magnet.input.kind;
      if (contact.condition != ContactCondition::none && kind.interior != Interior::may_be_solid)
        throw magnet.declarations.error(magnet.section + "/Contact",
                                        "a " + kind.name + " has no surface; set it to none.");
      if (contact.friction > 0. && !contact.lets_slide())
        throw magnet.declarations.error(magnet.section + "/Friction",
                                        "there is friction with Contact = slip or separate only.");
      if (contact.contact_angle != 90. && !contact.lets_slide())
        throw magnet.declarations.error(magnet.section + "/Contact angle",
                                        "there is one with Contact = slip or separate only.");
    }

    /** That a free magnet has mass, and a place to begin at; others must not have these. */
    template <int dim>
    void
    check_free(const GivenMagnet<dim> &magnet, const MagneticSource<dim> &source)
    {
      const ParameterRegister &declarations = magnet.declarations;
      const std::string &section            = magnet.section;
      if (!magnet.input.body.is_free)
        return check_given(declarations, section, {}, parameters_of_free_body, "Free = false");
      if (!source.has_place())
        throw declarations.error(section + "/Free", "a uniform field is nowhere; set it to false.");
      check_mass(declarations, section, "Free = true");
      if (magnet.has("Key frames"))
        throw declarations.error(
          section + "/Free",
          "key frames move this magnet. Give Position and Rotation instead, or "
          "set Free = false.");
      const auto check_constant = [&](const std::string &name, const bool is_constant) {
        if (!is_constant)
          throw declarations.error(
            section + "/" + name,
            "a free magnet begins there, and forces move it: it must not depend "
            "on t. Or set Free = false.");
      };
      check_constant("Position", magnet.position().is_constant());
      check_constant("Rotation", magnet.rotation().is_constant());
      if (source.shape() == nullptr)
        throw declarations.error(section + "/Free",
                                 "a source of this type has no volume, and so no inertia; set it "
                                 "to false.");
    }

    /** A solid magnet excludes material, and so does the core of a dipole: none may be seeded inside. */
    template <int dim>
    void
    check_clear_of_bodies(const ParameterRegister &declarations,
                          const std::string &section,
                          const MagneticSource<dim> &source,
                          const double radius,
                          const Parameters<dim> &parameters,
                          const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes)
    {
      const Vector<dim> &position = source.pose().position;
      const PlacedShape<dim> magnet(*source.shape(), source.pose());
      for (std::size_t b = 0; b < body_shapes.size(); ++b)
        {
          if (body_shapes[b] == nullptr)
            continue;
          std::string depth;
          if (radius > 0.)
            {
              // From a centre inside a body: zero, so that the overlap is the radius.
              const double gap = std::max(0., body_shapes[b]->surface_distance(position).distance) -
                                 radius;
              if (gap >= -1e-9 * radius)
                continue;
              depth = " by " + to_text(-gap) + " m";
            }
          else if (!overlap(magnet, *body_shapes[b], 0.5 * parameters.lattice.spacing))
            continue;
          const bool is_solid = source.is_solid();
          throw declarations.error(
            section + (declarations.given(section + "/Position") ? "/Position" : "/Key frames"),
            std::string(is_solid ? "this solid magnet (" : "the core of this dipole (") +
              (radius > 0. ? "radius " + to_text(radius) + " m, " : std::string()) + "at " +
              components(position) + " m) overlaps the body '" + parameters.bodies[b].name + "'" +
              depth + " at the start. Move one of them, or " +
              (is_solid ? "set " + section + "/Contact = none." : "make its Radius smaller."));
        }
    }

    /** The source itself; a mesh that cannot be used is refused here. */
    template <int dim>
    std::unique_ptr<MagneticSource<dim>>
    make_checked(const GivenMagnet<dim> &magnet, const SourceParameters<dim> &source)
    {
      try
        {
          return make_source(source);
        }
      catch (const InputError &error)
        {
          if (!magnet.has("File"))
            throw;
          throw InputError(magnet.declarations.where(magnet.section + "/File") + ": " +
                           error.what());
        }
    }

    /** One of the magnets, into @p source. */
    template <int dim>
    void
    check_magnet(const GivenMagnet<dim> &magnet,
                 const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes,
                 const Parameters<dim> &parameters,
                 SourceParameters<dim> &source)
    {
      check_contact(magnet);
      check_sizes(magnet);
      source.kind     = magnet.input.kind->read(magnet);
      source.is_solid = magnet.input.body.contact.condition != ContactCondition::none;
      if (source.has_place())
        magnet.read_motion(source);
      const auto made = make_checked(magnet, source);
      check_free(magnet, *made);
      const bool is_ball = std::holds_alternative<MagnetizedSphereParameters<dim>>(source.kind) ||
                           made->refuses_material();
      if (source.is_solid || made->refuses_material())
        check_clear_of_bodies(magnet.declarations,
                              magnet.section,
                              *made,
                              is_ball ? magnet.input.radius : 0.,
                              parameters,
                              body_shapes);
    }
  } // namespace

  template <int dim>
  void
  check_magnets(const ParameterRegister &declarations,
                const std::vector<std::string> &names,
                const std::vector<MagnetInput<dim>> &magnets,
                const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes,
                Parameters<dim> &parameters)
  {
    for (std::size_t m = 0; m < magnets.size(); ++m)
      {
        const std::string section = "Magnets/" + names[m];
        MagnetInput<dim> input    = magnets[m];
        const GivenMagnet<dim> magnet{declarations, section, input};
        check_given_for_kind(magnet);
        if (magnet.has("File"))
          input.file = find_input_file(declarations, section + "/File", input.file);
        SourceParameters<dim> source;
        source.name = names[m];
        check_magnet(magnet, body_shapes, parameters, source);
        parameters.sources.push_back(source);
        parameters.magnet_bodies.push_back(input.body);
      }
  }

#define INSTANTIATE(dim)                                                        \
  template void check_magnets(const ParameterRegister &,                        \
                              const std::vector<std::string> &,                 \
                              const std::vector<MagnetInput<dim>> &,            \
                              const std::vector<std::unique_ptr<Shape<dim>>> &, \
                              Parameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
