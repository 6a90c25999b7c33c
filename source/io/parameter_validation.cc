#include <magmpm/io/body_geometry.h>
#include <magmpm/io/number_text.h>
#include <magmpm/io/parameter_names.h>
#include <magmpm/io/parameter_validation.h>
#include <magmpm/magnets/motion_script.h>
#include <magmpm/materials/parameter_conversion.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace magmpm
{
  namespace
  {
    constexpr const char *axis_names = "xyz";

    /** No medium of grains comes near; what does is a slip in a unit. */
    constexpr double max_susceptibility = 1e6;

    /** Block coordinates are packed into 21 bits each. */
    constexpr double max_cells = 1e6;

    std::string
    to_text(const double number)
    {
      std::ostringstream text;
      text << number;
      return text.str();
    }

    /** The parameters of @p names in @p section that were given. */
    std::vector<std::string>
    given_of(const ParameterRegister &declarations,
             const std::string &section,
             const std::vector<std::string> &names)
    {
      std::vector<std::string> result;
      std::copy_if(names.begin(), names.end(), std::back_inserter(result), [&](const auto &name) {
        return declarations.given(section + "/" + name);
      });
      return result;
    }

    /** All of @p needed must be given, none of @p unused; @p reason names what says so. */
    void
    check_given(const ParameterRegister &declarations,
                const std::string &section,
                const std::vector<std::string> &needed,
                const std::vector<std::string> &unused,
                const std::string &reason)
    {
      for (const std::string &name : needed)
        if (!declarations.given(section + "/" + name))
          throw declarations.error(section + "/" + name, reason + " needs it.");
      for (const std::string &name : given_of(declarations, section, unused))
        throw declarations.error(section + "/" + name,
                                 reason + " does not use it; remove this line or change that.");
    }

    /** Cells along an edge of the box, or an error with good values near it. */
    template <int dim>
    int
    cells_along(const ParameterRegister &declarations,
                const ParameterInput<dim> &input,
                const int d)
    {
      const double edge = input.upper_corner[d] - input.lower_corner[d];
      const std::string axis(1, axis_names[d]);
      if (!(edge > 0.))
        throw declarations.error("Box/Upper corner",
                                 "along " + axis + " it must lie above Box/Lower corner (" +
                                   to_text(input.lower_corner[d]) + " m).");

      const double cells = edge / input.cell_size;
      if (cells > max_cells)
        throw declarations.error("Box/Cell size",
                                 "that makes " + to_text(cells) + " cells along " + axis +
                                   "; at most 1e6 are possible. Choose larger cells.");

      const double blocks = std::round(cells / block_edge);
      if (blocks >= 1. && std::abs(cells - block_edge * blocks) < 1e-6 * cells)
        return block_edge * static_cast<int>(blocks);

      const double above = std::ceil(cells / block_edge), below = above - 1.;
      const double nearest    = std::max(1., blocks);
      const double block_size = block_edge * input.cell_size;
      std::ostringstream advice;
      advice.precision(9);
      advice << "the edge along " << axis << " is " << to_text(cells)
             << " cells, but must be a multiple of 4 cells. Good values near: upper corner at "
             << axis << " = ";
      if (below >= 1.)
        advice << input.lower_corner[d] + below * block_size << " or ";
      advice << input.lower_corner[d] + above * block_size
             << " m, or Cell size = " << edge / (block_edge * nearest) << " m ("
             << block_edge * nearest << " cells).";
      throw declarations.error("Box/Upper corner", advice.str());
    }

    template <int dim>
    void
    check_box(const ParameterRegister &declarations,
              const ParameterInput<dim> &input,
              Lattice<dim> &lattice)
    {
      lattice.lower_corner = input.lower_corner;
      lattice.spacing      = input.cell_size;
      for (int d = 0; d < dim; ++d)
        lattice.n_cells[d] = cells_along(declarations, input, d);
    }

    /** E and nu, or Lame's moduli: exactly one pair. */
    void
    convert_solid(const ParameterRegister &declarations,
                  const std::string &section,
                  const MaterialInput &input,
                  MaterialParameters &material)
    {
      const std::vector<std::string> engineers = {"Young's modulus", "Poisson ratio"};
      const std::vector<std::string> lames     = {"Shear modulus", "Lame lambda"};
      const std::string law                    = "Mechanical law = neo-Hookean";
      check_given(declarations, section, {}, {"Bulk modulus", "Viscosity"}, law);

      const bool by_engineers = !given_of(declarations, section, engineers).empty();
      const bool by_lame      = !given_of(declarations, section, lames).empty();
      if (by_engineers == by_lame)
        throw declarations.error(section + "/Mechanical law",
                                 std::string("the moduli are given ") +
                                   (by_lame ? "in two ways" : "in no way") +
                                   ". Give either Young's modulus and Poisson ratio, or Shear "
                                   "modulus and Lame lambda.");
      if (by_engineers)
        {
          check_given(declarations, section, engineers, {}, "the other one of this pair");
          const LameModuli moduli = lame_moduli(input.youngs_modulus, input.poisson_ratio);
          material.shear_modulus  = moduli.shear_modulus;
          material.lame_lambda    = moduli.lame_lambda;
          return;
        }
      check_given(declarations, section, lames, {}, "the other one of this pair");
      if (!(input.lame_lambda > -2. / 3. * input.shear_modulus))
        throw declarations.error(
          section + "/Lame lambda",
          "must be above -2/3 of the Shear modulus (" + to_text(-2. / 3. * input.shear_modulus) +
            " Pa): with less the material has no resistance to compression.");
      material.shear_modulus = input.shear_modulus;
      material.lame_lambda   = input.lame_lambda;
    }

    void
    convert_fluid(const ParameterRegister &declarations,
                  const std::string &section,
                  const MaterialInput &input,
                  MaterialParameters &material)
    {
      check_given(declarations,
                  section,
                  {"Bulk modulus", "Viscosity"},
                  {"Young's modulus", "Poisson ratio", "Shear modulus", "Lame lambda"},
                  "Mechanical law = viscoelastic fluid");
      material.bulk_modulus = input.bulk_modulus;
      material.viscosity    = input.viscosity;
    }

    /** That what a user gave makes a medium that can be computed; @p given is named if not. */
    MagneticParameters
    checked(const ParameterRegister &declarations,
            const std::string &given,
            const MagneticParameters &magnetic)
    {
      const double chi = magnetic.initial_susceptibility;
      if (!(chi > 0. && chi <= max_susceptibility))
        throw declarations.error(given,
                                 "it gives the material the initial susceptibility " +
                                   to_text(chi) + ", which must be above 0 and at most " +
                                   to_text(max_susceptibility) + ". Are the units right?");
      if (!std::isfinite(magnetic.saturation_magnetization) ||
          !std::isfinite(magnetic.number_density))
        throw declarations.error(given,
                                 "it gives the material the saturation magnetization " +
                                   to_text(magnetic.saturation_magnetization) + " A/m with " +
                                   to_text(magnetic.number_density) +
                                   " grains per m^3, which must be finite. Are the units right?");
      return magnetic;
    }

    /** Saturation and susceptibility, or grains: at most one of these ways, and all of it. */
    MagneticParameters
    convert_magnetic(const ParameterRegister &declarations,
                     const std::string &section,
                     const MaterialInput &input,
                     const MagnetizationLaw law,
                     const double temperature)
    {
      const std::vector<std::string> saturation = {"Saturation magnetization",
                                                   "Initial susceptibility"};
      const std::vector<std::string> grains     = {"Grain moment", "Grain number density"};

      const std::vector<std::string> given = given_of(declarations, section, saturation);
      if (!given_of(declarations, section, grains).empty())
        {
          if (!given.empty())
            throw declarations.error(section + "/" + given.front(),
                                     "the magnetization is given in two ways. Give either " +
                                       saturation[0] + " and " + saturation[1] + ", or " +
                                       grains[0] + " and " + grains[1] + ".");
          check_given(declarations, section, grains, {}, "the other one of this pair");
          return checked(declarations,
                         section + "/" + grains[0],
                         magnetic_parameters_of_grains(
                           input.grain_moment, input.grain_number_density, temperature));
        }
      if (given.empty())
        return {};

      if (law == MagnetizationLaw::langevin)
        check_given(declarations, section, saturation, {}, "Magnetization law = Langevin");
      check_given(declarations, section, {saturation[1]}, {}, "a magnetic material");
      return checked(declarations,
                     section + "/" + saturation[1],
                     magnetic_parameters_of_saturation(
                       input.saturation_magnetization, input.initial_susceptibility, temperature));
    }

    template <int dim>
    void
    convert_materials(const ParameterRegister &declarations,
                      const ParameterInput<dim> &input,
                      Parameters<dim> &parameters)
    {
      for (std::size_t i = 0; i < input.materials.size(); ++i)
        {
          MaterialParameters material;
          material.name             = input.material_names[i];
          material.law              = input.materials[i].law;
          const std::string section = "Materials/" + material.name;
          if (material.law == MechanicalLaw::neo_hookean)
            convert_solid(declarations, section, input.materials[i], material);
          else
            convert_fluid(declarations, section, input.materials[i], material);
          material.magnetic = convert_magnetic(
            declarations, section, input.materials[i], parameters.magnetics.law, input.temperature);
          parameters.materials.push_back(material);
        }
    }

    /** That the shape is given, all of it and nothing else. */
    template <int dim>
    void
    check_shape(const ParameterRegister &declarations,
                const std::string &section,
                const BodyParameters<dim> &body)
    {
      const std::vector<std::string> corners = {"Lower corner", "Upper corner"};
      const std::vector<std::string> axis    = {"Axis", "Length"};
      if (body.shape == Shape::box)
        {
          check_given(declarations, section, corners, {"Centre", "Radius"}, "Shape = box");
          if constexpr (dim == 3)
            check_given(declarations, section, {}, axis, "Shape = box");
          for (int d = 0; d < dim; ++d)
            if (!(body.upper_corner[d] > body.lower_corner[d]))
              throw declarations.error(section + "/Upper corner",
                                       std::string("along ") + axis_names[d] +
                                         " it must lie above " + section + "/Lower corner (" +
                                         to_text(body.lower_corner[d]) + " m).");
          return;
        }

      const bool cylinder      = (body.shape == Shape::cylinder);
      const std::string reason = cylinder ? "Shape = cylinder" : "Shape = sphere";
      check_given(declarations, section, {"Centre", "Radius"}, corners, reason);
      if constexpr (dim == 3)
        check_given(declarations,
                    section,
                    cylinder ? axis : std::vector<std::string>(),
                    cylinder ? std::vector<std::string>() : axis,
                    reason);
      if (cylinder && !(norm(body.axis) > 0.))
        throw declarations.error(section + "/Axis", "it must have a length greater than 0.");
    }

    template <int dim>
    void
    check_inside_box(const ParameterRegister &declarations,
                     const std::string &section,
                     const BodyParameters<dim> &body,
                     const Lattice<dim> &lattice)
    {
      const Extent<dim> reach = extent(body);
      for (int d = 0; d < dim; ++d)
        {
          const double lower = lattice.lower_corner[d], upper = lattice.upper_corner()[d];
          const double tolerance = 1e-6 * lattice.spacing;
          const bool below       = reach.lower[d] < lower - tolerance;
          if (below || reach.upper[d] > upper + tolerance)
            throw declarations.error(
              section + (body.shape == Shape::box ? (below ? "/Lower corner" : "/Upper corner")
                                                  : "/Centre"),
              "the body reaches to " + std::string(1, axis_names[d]) + " = " +
                to_text(below ? reach.lower[d] : reach.upper[d]) +
                " m, outside of the box, which is from " + to_text(lower) + " to " +
                to_text(upper) + " m there. Move the body or enlarge the box.");
        }
    }

    template <int dim>
    void
    check_bodies(const ParameterRegister &declarations,
                 const ParameterInput<dim> &input,
                 const Parameters<dim> &parameters)
    {
      const std::string list = "Bodies/List of bodies";
      if (parameters.bodies.empty())
        throw declarations.error(list, "a scene needs at least one body.");

      for (const BodyParameters<dim> &body : parameters.bodies)
        {
          const std::string section = "Bodies/" + body.name;
          const auto &names         = input.material_names;
          if (std::find(names.begin(), names.end(), body.material) == names.end())
            throw declarations.error(section + "/Material",
                                     "there is no material of this name. Materials/List of "
                                     "materials is '" +
                                       comma_separated(names) + "'" +
                                       did_you_mean(body.material, names));
          check_shape(declarations, section, body);
          check_inside_box(declarations, section, body, parameters.lattice);
        }

      for (std::size_t i = 0; i < parameters.bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (overlap(parameters.bodies[i], parameters.bodies[j]))
            throw declarations.error(list,
                                     "the bodies '" + parameters.bodies[j].name + "' and '" +
                                       parameters.bodies[i].name +
                                       "' overlap at the start; move them apart.");
    }

    /** A solid magnet excludes material: none may be seeded inside. */
    template <int dim>
    void
    check_magnet_clear_of_bodies(const ParameterRegister &declarations,
                                 const std::string &section,
                                 const SourceParameters<dim> &source,
                                 const Vector<dim> &centre,
                                 const Parameters<dim> &parameters)
    {
      for (const BodyParameters<dim> &body : parameters.bodies)
        {
          const double gap = distance(body, centre) - source.radius;
          if (gap < -1e-9 * source.radius)
            throw declarations.error(section + "/Position",
                                     "this solid magnet (radius " + to_text(source.radius) +
                                       " m, at " + components(centre) + " m) overlaps the body '" +
                                       body.name + "' by " + to_text(-gap) +
                                       " m at the start. Move one of them, or set " + section +
                                       "/Contact = none.");
        }
    }

    template <int dim>
    void
    check_sources(const ParameterRegister &declarations, const Parameters<dim> &parameters)
    {
      for (const SourceParameters<dim> &source : parameters.sources)
        {
          const std::string section             = "Magnets/" + source.name;
          const std::vector<std::string> field  = {"Field"};
          const std::vector<std::string> sphere = {"Position", "Magnetization", "Radius"};
          const auto at_start = [&](const std::string &name, const std::string &expressions) {
            return MotionScript<dim>(expressions, declarations.where(section + "/" + name))
              .value(0.);
          };
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
            check_magnet_clear_of_bodies(declarations, section, source, centre, parameters);
        }
    }

    template <int dim>
    void
    check_times(const ParameterRegister &declarations, const Parameters<dim> &parameters)
    {
      const TimeStepParameters &step = parameters.time_step;
      if (step.fixed_step > 0.)
        check_given(declarations, "Time step", {}, {"Maximum"}, "a given Time step/Time step");
      if (step.fixed_step > parameters.output.frame_interval)
        throw declarations.error("Time step/Time step",
                                 "it must not be longer than Output/Frame interval (" +
                                   to_text(parameters.output.frame_interval) + " s).");
    }

    template <int dim>
    void
    convert_checkpoint(const ParameterRegister &declarations,
                       const ParameterInput<dim> &input,
                       CheckpointParameters &checkpoint)
    {
      const std::regex frames("([1-9][0-9]{0,8}) frames?");
      std::smatch number;
      if (const auto seconds = seconds_from(input.checkpoint_every))
        checkpoint.wall_interval = *seconds;
      else if (std::regex_match(input.checkpoint_every, number, frames))
        checkpoint.every_n_frames = std::stoi(number[1]);
      else if (input.checkpoint_every != "never")
        throw declarations.error(
          "Checkpoint every",
          "must be a wall time (90 s, 10 min, 2 h), a number of frames (20 frames), "
          "or never.");

      if (const auto seconds = seconds_from(input.end_wall_time))
        checkpoint.end_wall_time = *seconds;
      else if (input.end_wall_time != "never")
        throw declarations.error("End wall time",
                                 "must be a wall time (90 s, 10 min, 11.5 h) or never.");
    }

    /** What is allowed but probably not meant. */
    template <int dim>
    void
    collect_warnings(const ParameterRegister &declarations, Parameters<dim> &parameters)
    {
      const bool magnetic = parameters.mesh.carries_potential;
      parameters.warnings = declarations.warnings();
      if (magnetic && parameters.sources.empty())
        parameters.warnings.push_back(
          declarations.where("Magnets/List of magnets") +
          " is empty: there are magnetic bodies, but nothing magnetizes "
          "them.");
      if (!magnetic && !parameters.sources.empty())
        parameters.warnings.push_back(declarations.where("Magnets/List of magnets") +
                                      " is not empty, but no body is magnetic: no magnet pulls.");
      for (const MaterialParameters &material : parameters.materials)
        if (std::none_of(parameters.bodies.begin(),
                         parameters.bodies.end(),
                         [&](const BodyParameters<dim> &body) {
                           return body.material == material.name;
                         }))
          parameters.warnings.push_back(declarations.where("Materials/List of materials") +
                                        ": no body is made of '" + material.name + "'.");
    }
  } // namespace

  template <int dim>
  void
  validate(const ParameterRegister &declarations,
           const ParameterInput<dim> &input,
           Parameters<dim> &parameters)
  {
    check_box(declarations, input, parameters.lattice);
    convert_materials(declarations, input, parameters);
    check_bodies(declarations, input, parameters);
    check_sources(declarations, parameters);
    check_times(declarations, parameters);
    convert_checkpoint(declarations, input, parameters.checkpoint);

    parameters.magnetics.shielded = parameters.mesh.shielded;
    parameters.mesh.carries_potential =
      std::any_of(parameters.bodies.begin(), parameters.bodies.end(), [&](const auto &body) {
        return parameters.material_of(body).magnetic.is_magnetic();
      });
    collect_warnings(declarations, parameters);
  }

  template void
  validate(const ParameterRegister &, const ParameterInput<2> &, Parameters<2> &);
  template void
  validate(const ParameterRegister &, const ParameterInput<3> &, Parameters<3> &);
} // namespace magmpm
