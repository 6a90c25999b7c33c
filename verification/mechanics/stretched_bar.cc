
#include <magmpm/base/constants.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/materials/parameter_conversion.h>

#include <verification/mechanics/free_solid.h>
#include <verification/mechanics/stretched_bar.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    using Points = std::vector<FreeSolid<2>::Point>;

    constexpr double height = 1., length = 6. * height, grip = height; // m
    constexpr int cells   = 4;                                         // over the height
    constexpr double hold = 0.2; // of the run, at the largest stretch
    using constants::pi;

    FreeSolidParameters<2>
    parameters_of(const StretchedBar &bar)
    {
      FreeSolidParameters<2> parameters;
      parameters.spacing        = height / cells;
      const double shift        = bar.offset * parameters.spacing;
      parameters.lower_corner   = {{3. + shift, 1. + shift}};
      parameters.upper_corner   = {{3. + length + shift, 1. + height + shift}};
      parameters.poisson_ratio  = bar.poisson_ratio;
      parameters.elastic_factor = bar.elastic_factor;
      return parameters;
    }

    /** How far the grips are at a time, in units of the run: 0 to 1 and back. */
    double
    pulled(const double time)
    {
      constexpr double ramp = 0.5 - 0.5 * hold;
      if (time < ramp)
        return 0.5 - 0.5 * std::cos(pi * time / ramp);
      if (time < ramp + hold)
        return 1.;
      return 0.5 + 0.5 * std::cos(pi * std::min(1., (time - ramp - hold) / ramp));
    }

    /** Force per height of a bar stretched by @p stretch [Pa]. */
    double
    exact_force(const LameModuli &moduli, const double stretch)
    {
      const auto pressure = [&](const double across) {
        return moduli.lame_lambda * std::log(stretch * across);
      };
      double low = 0.2, high = 2.;
      for (int n = 0; n < 80; ++n)
        {
          const double across = 0.5 * (low + high);
          const bool is_wide  = moduli.shear_modulus * (across * across - 1.) + pressure(across) >
                               0.;
          (is_wide ? high : low) = across;
        }
      return (moduli.shear_modulus * (stretch * stretch - 1.) + pressure(low)) / stretch;
    }

    struct MiddleThird
    {
      double stretch; ///< by the places
      double force;   ///< mean of the nominal stress along the bar [Pa]
    };

    MiddleThird
    middle_third(const Points &points, const double centre)
    {
      double volume = 0., start = 0., place = 0., force = 0.;
      const auto for_middle = [&](const auto &f) {
        for (const auto &point : points)
          if (std::abs(point.start[0] - centre) < (length - 2. * grip) / 6. + 1e-9)
            f(point);
      };
      for_middle([&](const auto &point) {
        volume += point.volume;
        start += point.volume * point.start[0];
        place += point.volume * point.position[0];
        force += point.volume * point.stress(0, 0) / point.deformation(0, 0);
      });
      double product = 0., square = 0.;
      for_middle([&](const auto &point) {
        const double from_start = point.start[0] - start / volume;
        product += point.volume * from_start * (point.position[0] - place / volume);
        square += point.volume * from_start * from_start;
      });
      return {product / square, force / volume};
    }

    /** rms of (1 - S)^2 times the Kirchhoff pressure [Pa]. */
    double
    noise(const Points &points, const double spacing)
    {
      Lattice<2> lattice;
      lattice.spacing = spacing;
      std::vector<double> values;
      for (const auto &point : points)
        values.push_back(0.5 * trace(point.stress));
      for (int round = 0; round < 2; ++round)
        {
          std::map<Index<2>, std::pair<double, double>> sums;
          for (std::size_t p = 0; p < points.size(); ++p)
            for_stencil(lattice, points[p].position, [&](const auto &node, const double weight) {
              sums[node].first += weight * points[p].volume * values[p];
              sums[node].second += weight * points[p].volume;
            });
          for (std::size_t p = 0; p < points.size(); ++p)
            for_stencil(lattice, points[p].position, [&](const auto &node, const double weight) {
              values[p] -= weight * sums[node].first / sums[node].second;
            });
        }
      double square = 0., volume = 0.;
      for (std::size_t p = 0; p < points.size(); ++p)
        {
          square += points[p].volume * values[p] * values[p];
          volume += points[p].volume;
        }
      return std::sqrt(square / volume);
    }
  } // namespace

  StretchErrors
  errors_of_stretching(const StretchedBar &bar)
  {
    const FreeSolidParameters<2> parameters = parameters_of(bar);
    const LameModuli moduli = lame_moduli(parameters.youngs_modulus, bar.poisson_ratio);
    const double plane      = 1. - bar.poisson_ratio * bar.poisson_ratio;
    const double bar_speed  = std::sqrt(parameters.youngs_modulus / plane / parameters.density);
    const double end_time   = bar.periods * 2. * length / bar_speed;
    const double centre     = 0.5 * (parameters.lower_corner[0] + parameters.upper_corner[0]);
    const double way        = 0.5 * (length - 2. * grip) * (bar.stretch - 1.);
    const double ungripped  = 0.5 * length - grip;

    FreeSolid<2> solid(parameters);
    solid.set_grips([&](const double time, const double time_step) -> Grips {
      const double now  = way * pulled(time / end_time);
      const double then = way * pulled((time + time_step) / end_time);
      return {centre - ungripped - now, centre + ungripped + now, (then - now) / time_step};
    });
    StretchErrors errors = {};
    double lowest = 0., largest_work = 0., force = 0., stretch = 0., stress = 0.;
    int n_steps = 0, n_held = 0, n_samples = 0;
    while (solid.time() < end_time)
      {
        solid.step();
        const bool is_held = (solid.time() > 0.52 * end_time && solid.time() < 0.6 * end_time);
        force += is_held ? solid.force_of_grips() : 0.;
        n_held += is_held;
        if (++n_steps % 10 != 0)
          continue;
        const double left = solid.energy() - solid.work_of_grips();
        largest_work      = std::max(largest_work, solid.work_of_grips());
        errors.gained     = std::max(errors.gained, left);
        lowest            = std::min(lowest, left);
        errors.rise       = std::max(errors.rise, left - lowest);
        if (!is_held)
          continue;
        const MiddleThird middle = middle_third(solid.points(), centre);
        stretch += middle.stretch;
        stress += middle.force;
        if (n_samples++ == 0)
          errors.noise = noise(solid.points(), parameters.spacing) / parameters.youngs_modulus;
      }
    const double exact = exact_force(moduli, stretch / n_samples);
    errors.force       = force / n_held / height / exact - 1.;
    errors.stress      = stress / n_samples / exact - 1.;
    errors.gained /= largest_work;
    errors.rise /= largest_work;
    return errors;
  }
} // namespace magmpm::verification
