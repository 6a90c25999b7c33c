#include <magmpm/geometry/placed_shape.h>
#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/magnets/make_source.h>
#include <magmpm/motion/expression.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/input_file.h>
#include <magmpm/base/number_text.h>
#include <magmpm/parameters/section_validation.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** The parameters of a kind of source; those of its motion are common to all but the field. */
    struct KindOfSource
    {
      SourceType type;
      std::string name;
      std::vector<std::string> needed, allowed;
      bool is_magnetized; ///< by Magnetization or Remanence
      bool is_solid;      ///< may have a surface
    };

    const std::vector<KindOfSource> kinds = {
      {SourceType::uniform_field, "uniform field", {"Field"}, {}, false, false},
      {SourceType::point_dipole, "point dipole", {"Moment", "Radius"}, {}, false, false},
      {SourceType::magnetized_sphere, "magnetized sphere", {"Radius"}, {}, true, true},
      {SourceType::cuboid, "cuboid", {"Size"}, {}, true, true},
      {SourceType::cylinder, "cylinder", {"Radius", "Length"}, {"Axis"}, true, true},
      {SourceType::current_loop,
       "current loop",
       {"Current", "Radius", "Conductor radius"},
       {"Axis"},
       false,
       false},
      {SourceType::straight_wire,
       "straight wire",
       {"Current", "Conductor radius"},
       {"Length", "Axis"},
       false,
       false},
      {SourceType::magnetized_mesh, "magnetized mesh", {"File"}, {"Scale"}, true, true}};

    const std::vector<std::string> ways_to_magnetize = {"Magnetization", "Remanence"};
    const std::vector<std::string> ways_to_move      = {"Position",
                                                        "Rotation",
                                                        "Strength",
                                                        "Key frames"};

    const KindOfSource &
    kind_of(const SourceType type)
    {
      return *std::find_if(kinds.begin(), kinds.end(), [&](const KindOfSource &kind) {
        return kind.type == type;
      });
    }

    /** That all that the kind of source needs is given, and nothing that only others have. */
    void
    check_given_for(const ParameterRegister &declarations,
                    const std::string &section,
                    const KindOfSource &kind)
    {
      const auto is_in = [](const std::string &name, const std::vector<std::string> &names) {
        return std::find(names.begin(), names.end(), name) != names.end();
      };
      std::vector<std::string> unused;
      const auto add_unused = [&](const std::vector<std::string> &names) {
        for (const std::string &name : names)
          if (!is_in(name, kind.needed) && !is_in(name, kind.allowed) &&
              declarations.is_declared(section + "/" + name))
            unused.push_back(name);
      };
      for (const KindOfSource &other : kinds)
        {
          add_unused(other.needed);
          add_unused(other.allowed);
        }
      if (!kind.is_magnetized)
        add_unused(ways_to_magnetize);
      if (kind.type == SourceType::uniform_field)
        add_unused(ways_to_move);
      check_given(declarations, section, kind.needed, unused, "Type = " + kind.name);
    }

    void
    check_strength(const ParameterRegister &declarations,
                   const std::string &section,
                   const KindOfSource &kind)
    {
      if (!kind.is_magnetized)
        return;
      const auto given = given_of(declarations, section, ways_to_magnetize);
      if (given.empty())
        throw declarations.error(section + "/Magnetization",
                                 "Type = " + kind.name +
                                   " needs it. Or give Remanence, mu_0 times as much [T].");
      if (given.size() > 1)
        throw declarations.error(
          section + "/Remanence",
          "the magnetization is given in two ways. Give either Magnetization "
          "or Remanence.");
    }

    template <int dim>
    void
    check_motion(const ParameterRegister &declarations,
                 const std::string &section,
                 const KindOfSource &kind,
                 SourceParameters<dim> &source)
    {
      const std::string key_frames = section + "/Key frames";
      if (!declarations.given(key_frames))
        {
          if (!declarations.given(section + "/Position"))
            throw declarations.error(section + "/Position",
                                     "Type = " + kind.name + " needs it, or Key frames.");
          if (source.interpolation != KeyFrameInterpolation::linear)
            throw declarations.error(section + "/Interpolation",
                                     "it is used between Key frames only, which are not given.");
        }
      else
        {
          const auto others = given_of(declarations, section, {"Position", "Rotation", "Strength"});
          if (!others.empty())
            throw declarations.error(section + "/" + others.front(),
                                     "Key frames say this already. Give either of them.");
          // A table begins with a number, which is no name of a file.
          if (!is_key_frame_table(source.key_frames))
            source.key_frames = find_input_file(declarations, key_frames, source.key_frames);
        }
      if (dim == 2 && source.type == SourceType::straight_wire)
        check_given(declarations, section, {}, {"Rotation"}, "a wire, which is along z in 2D,");
    }

    template <int dim>
    void
    check_sizes(const ParameterRegister &declarations,
                const std::string &section,
                const SourceParameters<dim> &source)
    {
      if (source.type == SourceType::cuboid)
        for (int d = 0; d < dim; ++d)
          if (!(source.size[d] > 0.))
            throw declarations.error(section + "/Size", "all edges must be greater than 0.");
      if constexpr (dim == 3)
        if (declarations.given(section + "/Axis") && !(norm(source.axis) > 0.))
          throw declarations.error(section + "/Axis", "it must have a length greater than 0.");
      if (source.type == SourceType::current_loop && !(source.conductor_radius < source.radius))
        throw declarations.error(section + "/Conductor radius",
                                 "it must be smaller than the Radius of the loop (" +
                                   to_text(source.radius) + " m).");
    }

    /** Each expression by itself, so that the message says where it stands. */
    template <int dim>
    void
    check_expressions(const ParameterRegister &declarations,
                      const std::string &section,
                      const SourceParameters<dim> &source)
    {
      const auto where = [&](const std::string &name) {
        return declarations.where(section + "/" + name);
      };
      const std::pair<const char *, const std::string &> vectors[] = {
        {"Field", source.field},
        {"Magnetization", source.magnetization},
        {"Remanence", source.remanence},
        {"Moment", source.moment},
        {"Position", source.position}};
      for (const auto &[name, expression] : vectors)
        if (declarations.given(section + "/" + name))
          read_expression<dim>(expression, where(name));
      for (const auto &[name, expression] :
           {std::pair<const char *, const std::string &>("Current", source.current),
            std::pair<const char *, const std::string &>("Strength", source.strength)})
        if (declarations.given(section + "/" + name))
          read_expression<1>(expression, where(name));
      if (declarations.given(section + "/Rotation"))
        read_expression<n_axial_components<dim>>(source.rotation, where("Rotation"));
      if (declarations.given(section + "/Key frames"))
        read_key_frames<dim>(source.key_frames, source.interpolation, where("Key frames"));
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
          const bool is_solid = source.contact() != ContactCondition::none;
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
    make_checked(const ParameterRegister &declarations,
                 const std::string &section,
                 SourceParameters<dim> &source)
    {
      if (source.type != SourceType::magnetized_mesh)
        return make_source(source);
      const std::string file = section + "/File";
      source.file            = find_input_file(declarations, file, source.file);
      try
        {
          return make_source(source);
        }
      catch (const InputError &error)
        {
          throw InputError(declarations.where(file) + ": " + error.what());
        }
    }
  } // namespace

  template <int dim>
  void
  check_sources(const ParameterRegister &declarations,
                Parameters<dim> &parameters,
                const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes)
  {
    for (SourceParameters<dim> &source : parameters.sources)
      {
        const std::string section = "Magnets/" + source.name;
        const KindOfSource &kind  = kind_of(source.type);
        check_given_for(declarations, section, kind);
        check_strength(declarations, section, kind);
        if (source.contact != ContactCondition::none && !kind.is_solid)
          throw declarations.error(section + "/Contact",
                                   "a " + kind.name + " has no surface; set it to none.");
        if (source.friction > 0. &&
            (source.contact == ContactCondition::none || source.contact == ContactCondition::stick))
          throw declarations.error(section + "/Friction",
                                   "there is friction with Contact = slip or separate only.");
        if (source.type != SourceType::uniform_field)
          check_motion(declarations, section, kind, source);
        check_sizes(declarations, section, source);
        check_expressions(declarations, section, source);
        const auto made = make_checked(declarations, section, source);
        check_free_magnet(declarations, section, source);
        if (source.contact != ContactCondition::none || made->refuses_material())
          check_clear_of_bodies(
            declarations,
            section,
            *made,
            source.type == SourceType::magnetized_sphere || made->refuses_material() ? source.radius
                                                                                     : 0.,
            parameters,
            body_shapes);
      }
  }

  template void
  check_sources(const ParameterRegister &,
                Parameters<2> &,
                const std::vector<std::unique_ptr<Shape<2>>> &);
  template void
  check_sources(const ParameterRegister &,
                Parameters<3> &,
                const std::vector<std::unique_ptr<Shape<3>>> &);
} // namespace magmpm
