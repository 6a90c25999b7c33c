
#include <verification/mechanics/elastica.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    /** The curvature at the free end of a beam that starts with the curvature @p start; midpoint rule. */
    double
    integrate(const double q, const BeamLoad load, const double start, Elastica &shape)
    {
      constexpr int n_steps = 4000;
      const double ds       = 1. / n_steps;
      double curvature      = start;
      shape                 = {};
      for (int n = 0; n < n_steps; ++n)
        {
          const double rest   = (load == BeamLoad::weight ? 1. - (n + 0.5) * ds : 1.);
          const double middle = shape.angle + 0.5 * ds * curvature;
          const double change = -q * rest * std::cos(middle);
          shape.mean_reach += ds * (shape.reach + 0.5 * ds * std::cos(middle));
          shape.mean_height += ds * (shape.height + 0.5 * ds * std::sin(middle));
          shape.reach += ds * std::cos(middle);
          shape.height += ds * std::sin(middle);
          shape.angle += ds * (curvature + 0.5 * ds * change);
          curvature += ds * change;
        }
      return curvature;
    }
  } // namespace

  Elastica
  elastica(const double q, const BeamLoad load)
  {
    Elastica shape;
    double lower = 0., upper = q; // of the curvature at the clamp: q, or q/2, if it hardly bends
    for (int n = 0; n < 60; ++n)
      {
        const double middle = 0.5 * (lower + upper);
        if (integrate(q, load, middle, shape) > 0.)
          upper = middle;
        else
          lower = middle;
      }
    return shape;
  }
} // namespace magmpm::verification
