#include <magmpm/base/constants.h>

#include <verification/capillarity/gauss_rule.h>
#include <verification/capillarity/magnetic_drop_shape.h>

#include <cmath>
#include <cstddef>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi = constants::pi;

    /** The last value of x, on the axis. */
    double
    axis(const int dim)
    {
      return dim == 2 ? 0.5 * pi : 1.;
    }

    /** Narrower towards the axis, where the tip is. */
    std::vector<double>
    ray_edges(const int dim)
    {
      std::vector<double> edges = {0., 0.5, 0.8, 0.94, 1.};
      for (double &edge : edges)
        edge *= axis(dim);
      return edges;
    }

    /** What turns squares of slopes along x into those of the gradient: |grad f|^2 = f_r^2 + w f_x^2/r^2. */
    double
    metric(const int dim, const double x)
    {
      return dim == 2 ? 1. : 1. - x * x;
    }

    /** Distance from the equator over that from the centre, and its slope. */
    PlaneGradient
    elevation(const int dim, const double x)
    {
      return dim == 2 ? PlaneGradient{std::sin(x), std::cos(x)} : PlaneGradient{x, 1.};
    }

    /** t and the factors of the squares of slopes along t and x. */
    struct RayPoint
    {
      bool is_inside;
      double t, along, across;
    };

    RayPoint
    ray_point(const int dim, const double y)
    {
      if (y < 1.)
        return {true, y, std::pow(y, dim - 1), std::pow(y, dim - 3)};
      return {false, 2. - y, std::pow(2. - y, 3 - dim), std::pow(2. - y, 1 - dim)};
    }
  } // namespace

  MagneticDropEnergy::MagneticDropEnergy(const MagneticDrop &drop, const double bond_number)
    : drop(drop)
    , bond_number(bond_number)
    , turn(drop.dim == 2 ? 4. : 4. * pi)
    , elements(ray_edges(drop.dim), {0., 0.6, 1., 1.2, 1.5, 2.}, 5, {true, false, true, true})
  {
  }

  PlaneGradient
  MagneticDropEnergy::mode(const int n, const double x) const
  {
    if (drop.dim == 2)
      return {std::cos(2. * n * (0.5 * pi - x)), 2. * n * std::sin(2. * n * (0.5 * pi - x))};
    const ValueAndSlope p = legendre(2 * n, x);
    return {p.value, p.slope};
  }

  QuadraticForm
  MagneticDropEnergy::form(const ElementPoint &point, const Ray &ray) const
  {
    const RayPoint p    = ray_point(drop.dim, point.y);
    const double radius = std::exp(ray.log_radius);
    const double mu     = (p.is_inside ? 1. + drop.susceptibility : 1.) *
                      std::pow(radius, drop.dim - 2);
    const double lean = p.t * ray.slope, across = mu * p.across * metric(drop.dim, point.x);
    QuadraticForm form = {across, -across * lean, mu * p.along + across * lean * lean};
    if (p.is_inside)
      {
        const double scale = drop.susceptibility * std::pow(radius, drop.dim - 1) *
                             std::pow(p.t, drop.dim - 2);
        const PlaneGradient z = elevation(drop.dim, point.x);
        form.f                = scale * metric(drop.dim, point.x) * z.y;
        form.h                = scale * p.t * z.x - form.f * lean;
      }
    return form;
  }

  double
  MagneticDropEnergy::magnetic_energy(std::vector<Ray> &rays) const
  {
    const std::vector<ElementPoint> &points = elements.points();
    const std::size_t per_ray               = points.size() / rays.size();
    std::vector<QuadraticForm> forms;
    for (std::size_t i = 0; i < points.size(); ++i)
      forms.push_back(form(points[i], rays[i / per_ray]));
    const std::vector<PlaneGradient> slopes = elements.solve(forms);

    const double factor = -0.5 * bond_number * turn;
    double sum          = drop.susceptibility * axis(drop.dim) / drop.dim; // the volume
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        Ray &ray               = rays[i / per_ray];
        const QuadraticForm &q = forms[i];
        const auto [x, y]      = slopes[i];
        const double squares   = q.a * x * x + 2. * q.b * x * y + q.c * y * y,
                     source    = 2. * (q.f * x + q.h * y);
        const double weight    = factor * points[i].weight;
        sum += points[i].weight * (squares - source);
        // phi makes the energy stationary, so that its change does not count; a and f tell how the lean comes in.
        const double t = ray_point(drop.dim, points[i].y).t;
        ray.by_log_radius += weight * ((drop.dim - 2.) * squares - (drop.dim - 1.) * source);
        ray.by_slope -= weight * 2. * t * y * (q.a * x + q.b * y - q.f);
      }
    return factor * sum;
  }

  ValueAndGradient
  MagneticDropEnergy::operator()(const std::vector<double> &modes) const
  {
    std::vector<Ray> rays;
    std::vector<double> weights;
    for (const ElementPoint &point : elements.points())
      {
        if (rays.empty() || point.x != rays.back().x)
          {
            rays.push_back({point.x, 0., 0.});
            weights.push_back(0.);
            for (std::size_t n = 1; n <= modes.size(); ++n)
              {
                const PlaneGradient shape = mode(n, point.x);
                rays.back().log_radius += modes[n - 1] * shape.x;
                rays.back().slope += modes[n - 1] * shape.y;
              }
          }
        weights.back() += 0.5 * point.weight; // over both rectangles, each of height 1
      }
    double volume = 0.;
    std::vector<double> mean(modes.size(), 0.); // of each mode over the volume
    for (std::size_t i = 0; i < rays.size(); ++i)
      {
        const double part = weights[i] * std::exp(drop.dim * rays[i].log_radius);
        volume += part;
        for (std::size_t n = 1; n <= modes.size(); ++n)
          mean[n - 1] += part * mode(n, rays[i].x).x;
      }
    for (Ray &ray : rays)
      ray.log_radius -= std::log(volume / axis(drop.dim)) / drop.dim;

    ValueAndGradient result = {magnetic_energy(rays), std::vector<double>(modes.size(), 0.)};
    for (std::size_t i = 0; i < rays.size(); ++i)
      {
        Ray &ray            = rays[i];
        const double w      = metric(drop.dim, ray.x),
                     longer = std::sqrt(1. + w * ray.slope * ray.slope);
        const double shell  = turn * weights[i] * std::exp((drop.dim - 1) * ray.log_radius);
        result.value += shell * longer;
        ray.by_log_radius += (drop.dim - 1) * shell * longer;
        ray.by_slope += shell * w * ray.slope / longer;
        for (std::size_t n = 1; n <= modes.size(); ++n)
          {
            const PlaneGradient shape = mode(n, ray.x);
            result.gradient[n - 1] += ray.by_log_radius * (shape.x - mean[n - 1] / volume) +
                                      ray.by_slope * shape.y;
          }
      }
    return result;
  }

  double
  MagneticDropEnergy::log_aspect(const std::vector<double> &modes) const
  {
    double sum = 0.;
    for (std::size_t n = 1; n <= modes.size(); ++n)
      sum += modes[n - 1] * (mode(n, axis(drop.dim)).x - mode(n, 0.).x);
    return sum;
  }

  double
  MagneticDropEnergy::moment_aspect(const std::vector<double> &modes) const
  {
    double along = 0., across = 0.;
    for (const ElementPoint &point : elements.points())
      {
        double log_radius = 0.;
        for (std::size_t n = 1; n <= modes.size(); ++n)
          log_radius += modes[n - 1] * mode(n, point.x).x;
        const double weight = point.weight * std::exp((drop.dim + 2) * log_radius);
        const double square = std::pow(elevation(drop.dim, point.x).x, 2);
        along += weight * square;
        across += weight * (1. - square) / (drop.dim - 1.);
      }
    return std::sqrt(along / across);
  }

  MagneticDropShape
  magnetic_drop_shape(const MagneticDrop &drop,
                      const double bond_number,
                      const std::vector<double> &start,
                      const int n_modes)
  {
    const MagneticDropEnergy energy(drop, bond_number);
    std::vector<double> modes = start;
    modes.resize(n_modes, 0.);
    const Minimum minimum = minimize(energy, modes, 0.05, 1e-7);
    return {minimum.place,
            std::exp(energy.log_aspect(minimum.place)),
            energy.moment_aspect(minimum.place),
            minimum.value};
  }
} // namespace magmpm::verification
