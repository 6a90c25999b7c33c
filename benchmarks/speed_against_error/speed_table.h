#pragma once

#include <speed_against_error/measurement.h>

#include <fstream>

namespace magmpm::benchmarks
{
  /** All measurements of one experiment, printed and written as they come. */
  class SpeedTable
  {
  public:
    /** @throw RunError  if the CSV file cannot be written. */
    SpeedTable(std::ostream &terminal, const std::string &csv_file);

    /** What follows is of another experiment. */
    void
    start_experiment(const ExperimentKind kind);

    /** A row, with the whole series of a contender by growing resolution. */
    void
    add(const Measurement &measurement);

    /** Time of each contender to 3 % and 1 % error, and the ratios of the fastest ones. */
    void
    finish_experiment();

  private:
    std::ostream &terminal;
    std::ofstream csv;
    ExperimentKind kind = ExperimentKind::sphere_in_uniform_field;
    std::vector<Measurement> measurements;

    /** Those of each contender, in the order of their first measurements. */
    std::vector<std::vector<const Measurement *>>
    series() const;

    void
    print_times_to_error(const std::size_t error_number, const double error) const;
  };
} // namespace magmpm::benchmarks
