#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/parallel/gather.h>
#include <magmpm/particles/make_material.h>
#include <magmpm/particles/particle_quantities.h>
#include <magmpm/simulation/runaway_check.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /** A particle beyond a limit, and how many times it is beyond. */
    struct Runaway
    {
      double excess        = -1.;
      std::size_t particle = 0;
    };

    template <int dim>
    Runaway
    worst_particle(const Body<dim> &body, const RunawayLimits &limits, const double max_speed)
    {
      Runaway worst;
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        {
          const double volume_ratio = particle_volume_ratio(body, p);
          const double speed        = norm(body.particles.vector(ParticleProperty::velocity, p));
          double excess = std::max(volume_ratio / limits.max_volume_ratio, speed / max_speed);
          if (volume_ratio <= limits.min_volume_ratio)
            excess = std::max(excess, limits.min_volume_ratio / std::max(volume_ratio, 1e-300));
          if (!std::isfinite(volume_ratio) || !std::isfinite(speed))
            excess = std::numeric_limits<double>::infinity();
          if (excess > worst.excess)
            worst = {excess, p};
        }
      return worst;
    }

    template <int dim>
    std::string
    describe(const Body<dim> &body,
             const std::size_t p,
             const RunawayLimits &limits,
             const double max_speed,
             const Clock &clock,
             const std::string &limit)
    {
      const Vector<dim> velocity = body.particles.vector(ParticleProperty::velocity, p);
      std::ostringstream text;
      text
        << "particle " << body.particles.ids()[p] << " of body '" << body.name
        << "' ran away at t = " << clock.time + clock.time_step << " s (step " << clock.step + 1
        << ", dt = " << clock.time_step << " s, limit: " << limit
        << "): J = " << particle_volume_ratio(body, p) << " (allowed: " << limits.min_volume_ratio
        << " to " << limits.max_volume_ratio << "), speed " << norm(velocity)
        << " m/s (allowed: up to " << max_speed << " m/s), velocity (" << components(velocity)
        << ") m/s, position (" << components(body.particles.position(p))
        << ") m. The last frame written is good. Take a smaller time step, a stiffer material or "
           "a weaker field; the limits are parameters of the section 'Runaway limits'.";
      return text.str();
    }
  } // namespace

  template <int dim>
  double
  undeformed_wave_speed(const Body<dim> &body)
  {
    return undeformed_wave_speed<dim>(body.material);
  }

  template <int dim>
  void
  check_for_runaways(const std::vector<Body<dim>> &bodies,
                     const std::vector<ParticleExtremes> &extremes,
                     const RunawayLimits &limits,
                     const Clock &clock,
                     const std::string &limit,
                     const MPI_Comm communicator)
  {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        const double max_speed = limits.max_speed_ratio * undeformed_wave_speed(bodies[b]);
        if (extremes[b].max_volume_ratio <= limits.max_volume_ratio &&
            extremes[b].max_inverse_volume_ratio * limits.min_volume_ratio <= 1. &&
            extremes[b].speed <= max_speed)
          continue;

        const Runaway worst = worst_particle(bodies[b], limits, max_speed);
        const std::string description =
          (worst.excess < 0.
             ? ""
             : describe(bodies[b], worst.particle, limits, max_speed, clock, limit));
        const auto excesses     = parallel::all_gather(worst.excess, communicator);
        const auto descriptions = parallel::all_gather(description, communicator);
        const auto rank = std::max_element(excesses.begin(), excesses.end()) - excesses.begin();
        throw RunError(descriptions[rank]);
      }
  }

#define INSTANTIATE(dim)                                                  \
  template double undeformed_wave_speed(const Body<dim> &);               \
  template void check_for_runaways(const std::vector<Body<dim>> &,        \
                                   const std::vector<ParticleExtremes> &, \
                                   const RunawayLimits &,                 \
                                   const Clock &,                         \
                                   const std::string &,                   \
                                   const MPI_Comm);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
