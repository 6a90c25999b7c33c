#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/source_kinds.h>

#include <algorithm>
#include <type_traits>

namespace magmpm
{
  namespace
  {
    const std::vector<std::string> ways_to_magnetize = {"Magnetization", "Remanence"};
    const std::vector<std::string> ways_to_move      = {"Position",
                                                        "Rotation",
                                                        "Strength",
                                                        "Key frames"};

    /** A row of the table, of the kind with these parameters. */
    template <int dim, typename Kind>
    KindOfSource<dim>
    kind(const std::string &name,
         const std::vector<std::string> &needed,
         const std::vector<std::string> &allowed,
         const bool is_magnetized,
         SourceKind<dim> (*read)(const GivenMagnet<dim> &))
    {
      return {name, needed, allowed, is_magnetized, Kind::interior, read};
    }

    template <int dim>
    std::vector<KindOfSource<dim>>
    make_kinds()
    {
      using Given                          = GivenMagnet<dim>;
      using Kind                           = SourceKind<dim>;
      std::vector<KindOfSource<dim>> kinds = {
        kind<dim, UniformFieldParameters<dim>>("uniform field",
                                               {"Field"},
                                               {},
                                               false,
                                               [](const Given &given) -> Kind {
                                                 return UniformFieldParameters<dim>{
                                                   given.vector("Field", given.input.field)};
                                               }),
        kind<dim, PointDipoleParameters<dim>>("point dipole",
                                              {"Moment", "Radius"},
                                              {},
                                              false,
                                              [](const Given &given) -> Kind {
                                                return PointDipoleParameters<dim>{
                                                  given.vector("Moment", given.input.moment),
                                                  given.input.radius};
                                              }),
        kind<dim, MagnetizedSphereParameters<dim>>(
          "magnetized sphere",
          {"Radius"},
          {},
          true,
          [](const Given &given) -> Kind {
            return MagnetizedSphereParameters<dim>{given.magnetization(), given.input.radius};
          }),
        kind<dim, CuboidParameters<dim>>(
          "cuboid",
          {"Size"},
          {},
          true,
          [](const Given &given) -> Kind {
            return CuboidParameters<dim>{given.magnetization(), given.input.size};
          }),
        kind<dim, StraightWireParameters<dim>>("straight wire",
                                               {"Current", "Conductor radius"},
                                               {"Length", "Axis"},
                                               false,
                                               [](const Given &given) -> Kind {
                                                 return StraightWireParameters<dim>{
                                                   given.scalar("Current", given.input.current),
                                                   given.input.conductor_radius,
                                                   given.input.length,
                                                   given.input.axis};
                                               })};
      if constexpr (dim == 3)
        {
          kinds.push_back(kind<3, CylinderParameters>(
            "cylinder", {"Radius", "Length"}, {"Axis"}, true, [](const Given &given) -> Kind {
              return CylinderParameters{
                given.magnetization(), given.input.radius, given.input.length, given.input.axis};
            }));
          kinds.push_back(kind<3, CurrentLoopParameters>(
            "current loop",
            {"Current", "Radius", "Conductor radius"},
            {"Axis"},
            false,
            [](const Given &given) -> Kind {
              return CurrentLoopParameters{given.scalar("Current", given.input.current),
                                           given.input.radius,
                                           given.input.conductor_radius,
                                           given.input.axis};
            }));
          kinds.push_back(kind<3, MagnetizedMeshParameters>(
            "magnetized mesh", {"File"}, {"Scale"}, true, [](const Given &given) -> Kind {
              return MagnetizedMeshParameters{
                given.magnetization(), given.input.file, given.input.scale};
            }));
        }
      return kinds;
    }

    /** That what is magnetized is so in one way. */
    template <int dim>
    void
    check_magnetization(const GivenMagnet<dim> &magnet)
    {
      const ParameterRegister &declarations = magnet.declarations;
      const auto given = given_of(declarations, magnet.section, ways_to_magnetize);
      if (given.empty())
        throw declarations.error(magnet.section + "/Magnetization",
                                 "Type = " + magnet.input.kind->name +
                                   " needs it. Or give Remanence, mu_0 times as much [T].");
      if (given.size() > 1)
        throw declarations.error(
          magnet.section + "/Remanence",
          "the magnetization is given in two ways. Give either Magnetization "
          "or Remanence.");
    }
  } // namespace

  template <int dim>
  const std::vector<KindOfSource<dim>> &
  kinds_of_source()
  {
    static const std::vector<KindOfSource<dim>> kinds = make_kinds<dim>();
    return kinds;
  }

  template <int dim>
  void
  check_given_for_kind(const GivenMagnet<dim> &magnet)
  {
    const KindOfSource<dim> &own = *magnet.input.kind;
    const auto is_in = [](const std::string &name, const std::vector<std::string> &names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::vector<std::string> unused;
    const auto add_unused = [&](const std::vector<std::string> &names) {
      for (const std::string &name : names)
        if (!is_in(name, own.needed) && !is_in(name, own.allowed) &&
            magnet.declarations.is_declared(magnet.section + "/" + name))
          unused.push_back(name);
    };
    for (const KindOfSource<dim> &other : kinds_of_source<dim>())
      {
        add_unused(other.needed);
        add_unused(other.allowed);
      }
    if (!own.is_magnetized)
      add_unused(ways_to_magnetize);
    if (own.name == kinds_of_source<dim>().front().name)
      add_unused(ways_to_move);
    check_given(magnet.declarations, magnet.section, own.needed, unused, "Type = " + own.name);
    if (own.is_magnetized)
      check_magnetization(magnet);
  }

  template <int dim>
  void
  check_sizes(const GivenMagnet<dim> &magnet)
  {
    const ParameterRegister &declarations = magnet.declarations;
    const std::string &section            = magnet.section;
    const MagnetInput<dim> &input         = magnet.input;
    for (int d = 0; d < dim && magnet.has("Size"); ++d)
      if (!(input.size[d] > 0.))
        throw declarations.error(section + "/Size", "all edges must be greater than 0.");
    if constexpr (dim == 3)
      if (magnet.has("Axis") && !(norm(input.axis) > 0.))
        throw declarations.error(section + "/Axis", "it must have a length greater than 0.");
    // A loop has both.
    if (magnet.has("Radius") && magnet.has("Conductor radius") &&
        !(input.conductor_radius < input.radius))
      throw declarations.error(section + "/Conductor radius",
                               "it must be smaller than the Radius of the loop (" +
                                 to_text(input.radius) + " m).");
  }

#define INSTANTIATE(dim)                                                 \
  template const std::vector<KindOfSource<dim>> &kinds_of_source<dim>(); \
  template void check_given_for_kind(const GivenMagnet<dim> &);          \
  template void check_sizes(const GivenMagnet<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
