#pragma once

#include <magmpm/results/statistics_file.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * The columns of statistics.csv for a scene, in their order. doc/statistics.md says what each one
   * means; a test holds that it names them all. They are the same for every scene of a dimension
   * but for the bodies and phases: a scene without magnetic material has zeros in the magnetic
   * columns.
   *
   * Vectors are columns "name x", ... (StatisticsFile::set of a Vector); what belongs to a body is
   * "body: name" (body_column()), the seconds of a phase "wall time: phase" (phase_column()). In 2D
   * what adds up over the body is per metre of depth: J/m, kg/s, N/m, A m.
   *
   * @param bodies  names of the bodies.
   * @param phases  names of the timer sections, the verbs of the algorithm.
   * @param rigid   columns of magnets and rigid bodies (rigid_body_columns()).
   */
  template <int dim>
  std::vector<StatisticsColumn>
  statistics_columns(const std::vector<std::string> &bodies,
                     const std::vector<std::string> &phases,
                     const std::vector<StatisticsColumn> &rigid = {});

  /** Adds the columns of a vector (StatisticsFile::set()). */
  void
  add_vector(std::vector<StatisticsColumn> &columns,
             const std::string &name,
             const int n_components,
             const std::string &unit);

  /** Name of the column (or, for a vector, columns) @p quantity of one body. */
  inline std::string
  body_column(const std::string &body, const std::string &quantity)
  {
    return body + ": " + quantity;
  }

  /** Name of the column with the seconds of one phase of the algorithm. */
  inline std::string
  phase_column(const std::string &phase)
  {
    return "wall time: " + phase;
  }
} // namespace magmpm
