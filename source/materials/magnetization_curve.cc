#include <magmpm/materials/magnetization_curve.h>

namespace magmpm
{
  namespace
  {
    /** dM/dH at the points, for monotone cubics between them (Fritsch and Butland 1984). */
    std::vector<double>
    slopes_of(const std::vector<double> &h, const std::vector<double> &m)
    {
      const std::size_t n = h.size() - 1;
      std::vector<double> widths, secants, slopes(n + 1, 0.);
      for (std::size_t k = 0; k < n; ++k)
        {
          widths.push_back(h[k + 1] - h[k]);
          secants.push_back((m[k + 1] - m[k]) / widths[k]);
        }
      // Harmonic means; zero where the curve is level on one side.
      for (std::size_t k = 1; k < n; ++k)
        if (secants[k - 1] > 0. && secants[k] > 0.)
          slopes[k] = 3. * (widths[k - 1] + widths[k]) /
                      ((widths[k - 1] + 2. * widths[k]) / secants[k - 1] +
                       (2. * widths[k - 1] + widths[k]) / secants[k]);
      // At the end the derivative of the parabola through three points, if M goes on rising with it.
      const double bend = (secants[n - 1] - secants[n - 2]) / (widths[n - 1] + widths[n - 2]);
      slopes[n] = std::clamp(secants[n - 1] + bend * widths[n - 1], 0., 3. * secants[n - 1]);

      // Up to the first point a H + c H^3, which meets the second one too if that keeps M rising.
      const double chord = m[1] / h[1];
      const double c     = (m[2] / h[2] - chord) / (h[2] * h[2] - h[1] * h[1]);
      const double limit = std::min(2. * chord, 3. * secants[1]);
      slopes[1]          = std::clamp(chord + 2. * c * h[1] * h[1], 0., limit);
      slopes[0]          = 0.5 * (3. * chord - slopes[1]);
      return slopes;
    }
  } // namespace

  MagnetizationCurve::MagnetizationCurve(const std::vector<double> &fields,
                                         const std::vector<double> &magnetizations)
  {
    std::vector<double> h = {0.}, m = {0.};
    h.insert(h.end(), fields.begin(), fields.end());
    m.insert(m.end(), magnetizations.begin(), magnetizations.end());
    const std::vector<double> slopes = slopes_of(h, m);
    double coenergy                  = 0.;
    for (std::size_t k = 0; k + 1 < h.size(); ++k)
      {
        const double width  = h[k + 1] - h[k];
        const double secant = (m[k + 1] - m[k]) / width;
        Piece piece         = {h[k],
                               {m[k],
                                slopes[k],
                                (3. * secant - 2. * slopes[k] - slopes[k + 1]) / width,
                                (slopes[k] + slopes[k + 1] - 2. * secant) / (width * width)},
                               coenergy};
        if (k == 0) // but for rounding it is this already
          piece.coefficients[2] = 0.;
        const double *c = piece.coefficients;
        coenergy += width * (c[0] + width * (c[1] / 2. + width * (c[2] / 3. + width * c[3] / 4.)));
        pieces.push_back(piece);
        begins.push_back(piece.begin);
      }
    last_field    = h.back();
    last_coenergy = coenergy;
    tail          = slopes.back() * last_field * last_field;
    saturation    = m.back() + slopes.back() * last_field;
  }
} // namespace magmpm
