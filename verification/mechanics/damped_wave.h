#pragma once

#include <utility>
#include <vector>

namespace magmpm::verification
{
  /** Times and amplitudes. */
  using Course = std::vector<std::pair<double, double>>;

  /** offset + exp(-b t) (C cos(omega t) + S sin(omega t)). */
  struct DampedWave
  {
    double cosine = 0., sine = 0., decay = 0., frequency = 0., offset = 0.;

    double
    value(const double time) const;

    /** At t = 0, without the offset. */
    double
    amplitude() const;
  };

  /**
   * Least squares by Gauss and Newton.
   *
   * @param frequency   to start with.
   * @param has_offset  whether it may swing about another value than zero.
   */
  DampedWave
  fit_damped_wave(const Course &course, const double frequency, const bool has_offset = false);

  /** rms of what the fit leaves. */
  double
  misfit(const Course &course, const DampedWave &wave);
} // namespace magmpm::verification
