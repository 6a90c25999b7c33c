#include <verification/catch.h>

#include <speed_against_error/measurement.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::benchmarks;

namespace
{
  Measurement
  measurement(const int resolution, const double seconds, const double error)
  {
    Measurement result(Scheme::magmpm, "made up", resolution);
    Outcome outcome;
    outcome.cold.seconds = seconds;
    outcome.warm.seconds = 0.5 * seconds;
    result.add(outcome, {error, error, error, error});
    return result;
  }

  TimeToError
  cold_time(const std::vector<Measurement> &measurements, const double error)
  {
    std::vector<const Measurement *> series;
    for (const Measurement &m : measurements)
      series.push_back(&m);
    return time_to_error(series, &StateErrors::moment, &Measurement::cold, error);
  }
} // namespace

// The time to an error, of made-up measurements. Where time is a power of the error, the line of
// the logarithms is exact between measurements and beyond them.
TEST_CASE("Time to an error is read off the line through the logarithms", "[benchmarks]")
{
  // seconds = 1e-4 error^-2
  const std::vector<Measurement> power = {
    measurement(2, 0.01, 0.1), measurement(4, 0.04, 0.05), measurement(8, 0.16, 0.025)};
  const TimeToError between = cold_time(power, 0.03);
  CHECK(between.kind == TimeToError::Kind::interpolated);
  CHECK(between.seconds == Approx(1e-4 / (0.03 * 0.03)));

  const TimeToError coarsest = cold_time(power, 0.2);
  CHECK(coarsest.kind == TimeToError::Kind::at_most);
  CHECK(coarsest.seconds == Approx(0.01));
  CHECK(coarsest.text() == "< 0.01");

  const TimeToError beyond = cold_time(power, 0.0125);
  CHECK(beyond.kind == TimeToError::Kind::extrapolated);
  CHECK(beyond.seconds == Approx(1e-4 / (0.0125 * 0.0125)));
  CHECK(beyond.text() == "0.64 (extrapolated 2.0x)");

  CHECK(cold_time(power, 0.005).text() == "not reached");

  // It stays where it is.
  const std::vector<Measurement> flat = {
    measurement(2, 0.01, 0.1), measurement(4, 0.04, 0.0201), measurement(8, 0.16, 0.02)};
  CHECK(cold_time(flat, 0.015).text() == "not reached");
}

// A measurement that happens to be good between worse ones, as where two errors cancel. It does not
// count: the error has been reached where all finer lattices have it too.
TEST_CASE("Time to an error is not that of a lucky lattice", "[benchmarks]")
{
  const std::vector<Measurement> lucky = {measurement(2, 0.01, 0.1),
                                          measurement(4, 0.02, 0.001),
                                          measurement(8, 0.04, 0.04),
                                          measurement(16, 0.16, 0.01)};
  CHECK(cold_time(lucky, 0.02).seconds == Approx(0.08));
}

// Runs of different sign, times that differ. Errors count by their root mean square, which no
// change of sign makes smaller; of the times the smallest is the one that others disturbed least.
TEST_CASE("Measurements keep rms errors and the best times", "[benchmarks]")
{
  Measurement m(Scheme::paper, "made up", 4);
  Outcome outcome;
  outcome.cold.seconds = 2.;
  outcome.warm.seconds = 1.;
  m.add(outcome, {0.03, 0., 0., 0.});
  outcome.cold.seconds = 1.5;
  outcome.warm.seconds = 1.2;
  m.add(outcome, {-0.04, 0., 0., 0.});
  CHECK(m.n_runs == 2);
  CHECK(m.rms_errors().moment == Approx(std::sqrt(0.5 * (0.03 * 0.03 + 0.04 * 0.04))));
  CHECK(m.cold.seconds == 1.5);
  CHECK(m.warm.seconds == 1.);
}
