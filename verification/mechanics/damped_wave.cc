#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <verification/mechanics/damped_wave.h>

#include <cmath>

namespace magmpm::verification
{
  double
  DampedWave::value(const double time) const
  {
    return std::exp(-decay * time) *
             (cosine * std::cos(frequency * time) + sine * std::sin(frequency * time)) +
           offset;
  }

  double
  DampedWave::amplitude() const
  {
    return std::hypot(cosine, sine);
  }

  DampedWave
  fit_damped_wave(const Course &course, const double frequency, const bool has_offset)
  {
    const int n = has_offset ? 5 : 4;
    DampedWave wave;
    wave.frequency = frequency;
    for (int i = 0; i < 30; ++i)
      {
        dealii::FullMatrix<double> matrix(n, n);
        dealii::Vector<double> right(n), change(n);
        for (const auto &[time, amplitude] : course)
          {
            const double e         = std::exp(-wave.decay * time);
            const double c         = e * std::cos(wave.frequency * time),
                         s         = e * std::sin(wave.frequency * time);
            const double swing     = wave.value(time) - wave.offset;
            const double slopes[5] = {
              c, s, -time * swing, time * (wave.sine * c - wave.cosine * s), 1.};
            for (int a = 0; a < n; ++a)
              {
                right[a] += slopes[a] * (amplitude - wave.value(time));
                for (int b = 0; b < n; ++b)
                  matrix(a, b) += slopes[a] * slopes[b];
              }
          }
        // At first the amplitude is zero, and nothing depends on decay and frequency.
        for (int a = 2; i == 0 && a < 4; ++a)
          matrix(a, a) = 1.;
        matrix.gauss_jordan();
        matrix.vmult(change, right);
        wave.cosine += change[0];
        wave.sine += change[1];
        wave.decay += change[2];
        wave.frequency += change[3];
        if (has_offset)
          wave.offset += change[4];
      }
    return wave;
  }

  double
  misfit(const Course &course, const DampedWave &wave)
  {
    double squares = 0.;
    for (const auto &[time, amplitude] : course)
      squares += std::pow(amplitude - wave.value(time), 2) / static_cast<double>(course.size());
    return std::sqrt(squares);
  }
} // namespace magmpm::verification
