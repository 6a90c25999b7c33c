#include <magmpm/base/exceptions.h>

#include <speed_against_error/speed_table.h>

#include <cmath>
#include <cstdio>
#include <ostream>

namespace magmpm::benchmarks
{
  namespace
  {
    template <typename... Values>
    std::string
    formatted(const char *format, const Values... values)
    {
      char text[512];
      std::snprintf(text, sizeof(text), format, values...);
      return text;
    }

    /** "1.2e-03", or "-". */
    std::string
    error_text(const double error)
    {
      return std::isfinite(error) ? formatted("%.1e", error) : "-";
    }

    /** "2.3", with the sign of what is only a bound; "-" for no number. */
    std::string
    ratio_text(const TimeToError &paper, const TimeToError &magmpm)
    {
      using Kind = TimeToError::Kind;
      if (!std::isfinite(paper.seconds) || !std::isfinite(magmpm.seconds))
        return "-";
      if (paper.kind == Kind::at_most)
        return "-";
      return std::string(magmpm.kind == Kind::at_most ? "> " : "") +
             formatted("%.2g", paper.seconds / magmpm.seconds) +
             (paper.kind == Kind::extrapolated || magmpm.kind == Kind::extrapolated
                ? " (extrapolated)"
                : "");
    }

    /** The contender that is there first. */
    struct Fastest
    {
      std::string name = "-";
      TimeToError time;

      void
      consider(const std::string &other_name, const TimeToError &other)
      {
        if (std::isfinite(other.seconds) &&
            !(std::isfinite(time.seconds) && time.seconds <= other.seconds))
          {
            name = other_name;
            time = other;
          }
      }
    };
  } // namespace

  SpeedTable::SpeedTable(std::ostream &terminal, const std::string &csv_file)
    : terminal(terminal)
    , csv(csv_file)
  {
    if (!csv)
      throw RunError("The file '" + csv_file + "' cannot be written.");
    csv << "scene,scheme,contender,resolution,runs,unknowns,cold_newton_steps,cold_cg_iterations,"
           "ns_per_unknown_and_iteration,warm_newton_steps,warm_cg_iterations,cold_seconds,"
           "warm_seconds,moment_error,force_error,field_error,virial_error"
        << std::endl;
  }

  void
  SpeedTable::start_experiment(const ExperimentKind new_kind)
  {
    kind = new_kind;
    measurements.clear();
    terminal << formatted("\n%s\n%-24s %5s %4s %9s %6s %4s %8s %6s %4s %8s %8s %8s %8s %8s %8s\n",
                          to_string(kind),
                          "",
                          "R/dx",
                          "runs",
                          "unknowns",
                          "Newton",
                          "CG",
                          "ns/(u i)",
                          "warm N",
                          "CG",
                          "cold s",
                          "warm s",
                          "moment",
                          "force",
                          "rms H",
                          "virial");
  }

  void
  SpeedTable::add(const Measurement &m)
  {
    measurements.push_back(m);
    const StateErrors errors = m.rms_errors();
    terminal << formatted("%-24s %5d %4d %9llu %6d %4d %8.1f %6d %4d %8.4f %8.4f %8s %8s %8s %8s\n",
                          m.contender.c_str(),
                          m.resolution,
                          m.n_runs,
                          m.n_unknowns,
                          m.cold.newton_steps,
                          m.cold.cg_iterations,
                          m.nanoseconds_per_unknown_and_iteration(),
                          m.warm.newton_steps,
                          m.warm.cg_iterations,
                          m.cold.seconds,
                          m.warm.seconds,
                          error_text(errors.moment).c_str(),
                          error_text(errors.force).c_str(),
                          error_text(errors.field).c_str(),
                          error_text(errors.virial).c_str())
             << std::flush;
    csv << formatted("%s,%s,\"%s\",%d,%d,%llu,%d,%d,%.2f,%d,%d,%.6g,%.6g,%.4e,%.4e,%.4e,%.4e\n",
                     to_string(kind),
                     to_string(m.scheme),
                     m.contender.c_str(),
                     m.resolution,
                     m.n_runs,
                     m.n_unknowns,
                     m.cold.newton_steps,
                     m.cold.cg_iterations,
                     m.nanoseconds_per_unknown_and_iteration(),
                     m.warm.newton_steps,
                     m.warm.cg_iterations,
                     m.cold.seconds,
                     m.warm.seconds,
                     errors.moment,
                     errors.force,
                     errors.field,
                     errors.virial)
        << std::flush;
  }

  std::vector<std::vector<const Measurement *>>
  SpeedTable::series() const
  {
    std::vector<std::vector<const Measurement *>> result;
    for (const Measurement &measurement : measurements)
      {
        auto found = result.begin();
        while (found != result.end() && found->front()->contender != measurement.contender)
          ++found;
        if (found == result.end())
          found = result.insert(result.end(), {{}});
        found->push_back(&measurement);
      }
    return result;
  }

  void
  SpeedTable::print_times_to_error(const std::size_t error_number, const double error) const
  {
    terminal << formatted("\nseconds to %g %% error of %s, %s\n%-24s %26s %26s\n",
                          100. * error,
                          error_names[error_number],
                          to_string(kind),
                          "",
                          "cold",
                          "warm");
    Fastest fastest[std::size(all_schemes)][2]; // cold and warm
    for (const auto &one : series())
      {
        const auto time = [&](SolveCost Measurement::*cost) {
          return time_to_error(one, error_members[error_number], cost, error);
        };
        const TimeToError times[2] = {time(&Measurement::cold), time(&Measurement::warm)};
        terminal << formatted("%-24s %26s %26s\n",
                              one.front()->contender.c_str(),
                              times[0].text().c_str(),
                              times[1].text().c_str());
        for (int i = 0; i < 2; ++i)
          fastest[static_cast<int>(one.front()->scheme)][i].consider(one.front()->contender,
                                                                     times[i]);
      }
    for (const int scheme : {1, 2})
      for (int i = 0; i < 2; ++i)
        terminal << formatted("%s, '%s' over '%s': %s\n",
                              i == 0 ? "cold" : "warm",
                              fastest[scheme][i].name.c_str(),
                              fastest[0][i].name.c_str(),
                              ratio_text(fastest[scheme][i].time, fastest[0][i].time).c_str());
  }

  void
  SpeedTable::finish_experiment()
  {
    if (measurements.empty())
      return;
    for (std::size_t i = 0; i < std::size(error_members); ++i)
      if (std::isfinite(measurements.front().rms_errors().*error_members[i]))
        for (const double error : {0.03, 0.01})
          print_times_to_error(i, error);
  }
} // namespace magmpm::benchmarks
