#include <magmpm/results/statistics_columns.h>

namespace magmpm
{
  namespace
  {
    /** Units of what adds up over a body: in 2D they are per metre of depth. */
    template <int dim>
    struct Units;

    template <>
    struct Units<2>
    {
      static constexpr const char *energy           = "J/m";
      static constexpr const char *momentum         = "kg/s";
      static constexpr const char *angular_momentum = "kg m/s";
      static constexpr const char *force            = "N/m";
      static constexpr const char *magnetic_moment  = "A m";
    };

    template <>
    struct Units<3>
    {
      static constexpr const char *energy           = "J";
      static constexpr const char *momentum         = "kg m/s";
      static constexpr const char *angular_momentum = "kg m^2/s";
      static constexpr const char *force            = "N";
      static constexpr const char *magnetic_moment  = "A m^2";
    };
  } // namespace

  void
  add_vector(std::vector<StatisticsColumn> &columns,
             const std::string &name,
             const int n_components,
             const std::string &unit)
  {
    for (int i = 0; i < n_components; ++i)
      columns.push_back({name + ' ' + component_letter(i, n_components), unit});
  }

  template <int dim>
  std::vector<StatisticsColumn>
  statistics_columns(const std::vector<std::string> &bodies,
                     const std::vector<std::string> &phases,
                     const std::vector<StatisticsColumn> &rigid)
  {
    using Unit = Units<dim>;

    std::vector<StatisticsColumn> columns = {{"step", ""},
                                             {"time", "s"},
                                             {"dt", "s"},
                                             {"limit of dt", ""},
                                             {"particles", ""},
                                             {"lost particles", ""},
                                             {"held particles", ""},
                                             {"migrated particles", ""},
                                             {"fewest particles of a rank", ""},
                                             {"load imbalance", "-"},
                                             {"mesh changes", ""},
                                             {"kinetic energy", Unit::energy},
                                             {"elastic energy", Unit::energy},
                                             {"gravitational energy", Unit::energy},
                                             {"magnetic energy", Unit::energy}};
    add_vector(columns, "momentum", dim, Unit::momentum);
    add_vector(columns, "angular momentum", n_axial_components<dim>, Unit::angular_momentum);
    add_vector(columns, "centre of mass", dim, "m");
    columns.insert(columns.end(),
                   {{"max |v|", "m/s"},
                    {"min J", "-"},
                    {"max J", "-"},
                    {"density error", "-"},
                    {"max |H|", "A/m"},
                    {"max |M|", "A/m"}});

    for (const std::string &body : bodies)
      {
        add_vector(columns, body_column(body, "magnetic force"), dim, Unit::force);
        add_vector(columns, body_column(body, "magnetic moment"), dim, Unit::magnetic_moment);
      }

    columns.insert(columns.end(), rigid.begin(), rigid.end());
    columns.insert(columns.end(),
                   {{"magnetic solves", ""},
                    {"Newton steps", ""},
                    {"line search steps", ""},
                    {"CG iterations", ""},
                    {"Newton residual", "-"},
                    {"dropped magnetic force", Unit::force},
                    {"clipped fractions", ""},
                    {"clipped corrections", ""},
                    {"potential unknowns", ""}});
    for (const std::string &phase : phases)
      columns.push_back({phase_column(phase), "s"});
    return columns;
  }

  template std::vector<StatisticsColumn>
  statistics_columns<2>(const std::vector<std::string> &,
                        const std::vector<std::string> &,
                        const std::vector<StatisticsColumn> &);
  template std::vector<StatisticsColumn>
  statistics_columns<3>(const std::vector<std::string> &,
                        const std::vector<std::string> &,
                        const std::vector<StatisticsColumn> &);
} // namespace magmpm
