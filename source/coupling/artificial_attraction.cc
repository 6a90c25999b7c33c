#include <magmpm/base/number_text.h>
#include <magmpm/coupling/artificial_attraction.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/simulation/particle_reductions.h>

namespace magmpm
{
  template <int dim>
  double
  matched_acceleration(const Parameters<dim> &parameters,
                       const std::vector<Body<dim>> &bodies,
                       const MPI_Comm communicator)
  {
    PointAttraction<dim> attraction = parameters.attraction;
    attraction.acceleration         = 1.;
    Vector<dim> magnetic, artificial;
    for (const ParticleSums<dim> &sums : sums_over_ranks(bodies, parameters, communicator))
      magnetic += sums.magnetic_force;
    for (const Body<dim> &body : bodies)
      artificial += force_of(attraction, body);
    artificial = parallel::sum(artificial, communicator);
    if (!(norm(magnetic) > 0. && norm(artificial) > 0.))
      throw RunError("'Attraction/Strength = match magnets' finds no force to match: that of the "
                     "magnets is " +
                     to_text(norm(magnetic)) + " N, that of an attraction of 1 m/s^2 is " +
                     to_text(norm(artificial)) +
                     " N. Switch the magnets on at t = 0, take a Point outside of the bodies, or "
                     "give the acceleration.");
    return norm(magnetic) / norm(artificial);
  }

  template <int dim>
  std::string
  description(const PointAttraction<dim> &attraction)
  {
    return "attraction: g0 = " + to_text(attraction.acceleration) + " m/s^2 at " +
           with_prefix(attraction.reference_distance, "m") + " from (" +
           components(attraction.point) + ") m" +
           (attraction.matches_magnets ? ", in total what the magnets exert at the start" : "");
  }

#define INSTANTIATE(dim)                                                      \
  template double matched_acceleration(                                       \
    const Parameters<dim> &, const std::vector<Body<dim>> &, const MPI_Comm); \
  template std::string description(const PointAttraction<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
