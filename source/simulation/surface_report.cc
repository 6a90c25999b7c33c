#include <magmpm/base/constants.h>
#include <magmpm/base/number_text.h>
#include <magmpm/materials/critical_layer.h>
#include <magmpm/simulation/surface_report.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** sqrt(K/rho) over sqrt(gamma/(rho dx)). */
    double
    relative_sound(const MaterialParameters &material, const double spacing)
    {
      return std::sqrt(material.bulk_modulus * spacing / material.surface_tension);
    }

    /** What decides whether a flat layer of it stands. */
    std::string
    critical_line(const FerrofluidProperties &fluid, const MagnetizationModel &model)
    {
      const auto critical = critical_layer(fluid, model);
      if (!critical)
        return "\n    it saturates before any vertical field makes a deep layer unstable";
      return "\n    critical magnetization of a deep layer " +
             with_prefix(critical->magnetization, "A/m") + ", of an induction of " +
             with_prefix(critical->induction, "T") + " (a coil of " +
             with_prefix(critical->induction / constants::vacuum_permeability, "A/m") + ")";
    }

    template <int dim>
    std::string
    lines_on(const Parameters<dim> &parameters, const BodyParameters<dim> &body)
    {
      const MaterialParameters &material = parameters.material_of(body);
      const double dx                    = parameters.lattice.spacing;
      std::string text                   = "  surface of " + body.name + ": " +
                         with_prefix(material.surface_tension, "N/m") + ", sound " +
                         three_digits(relative_sound(material, dx)) + " times sqrt(gamma/(rho dx))";
      const double gravity = norm(parameters.gravity(0.));
      if (!(gravity > 0.))
        return text;
      const FerrofluidProperties fluid = {body.density,
                                          material.surface_tension,
                                          gravity,
                                          {material.magnetic.saturation_magnetization,
                                           material.magnetic.initial_susceptibility}};
      const double length              = capillary_length(fluid);
      text += ", capillary length " + with_prefix(length, "m") + ": a wave of " +
              with_prefix(2. * constants::pi * length, "m") + " has " +
              three_digits(2. * constants::pi * length / dx) + " cells";
      if (material.viscosity > 0.)
        text += ", Laplace number " + three_digits(body.density * material.surface_tension *
                                                   length / std::pow(material.viscosity, 2));
      if (material.magnetic.is_magnetic())
        text += critical_line(fluid, {parameters.magnetics.law, parameters.magnetics.curve});
      return text;
    }
  } // namespace

  template <int dim>
  std::string
  surface_report(const Parameters<dim> &parameters)
  {
    std::string text;
    for (const BodyParameters<dim> &body : parameters.bodies)
      if (parameters.material_of(body).surface_tension > 0.)
        text += (text.empty() ? "" : "\n") + lines_on(parameters, body);
    return text;
  }

  template std::string
  surface_report(const Parameters<2> &);
  template std::string
  surface_report(const Parameters<3> &);
} // namespace magmpm
