#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/coupling/attraction.h>
#include <magmpm/parallel/reduce.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  template <int dim>
  bool
  PointAttraction<dim>::acts_on(const std::string &body) const
  {
    return bodies.empty() || std::find(bodies.begin(), bodies.end(), body) != bodies.end();
  }

  template <int dim>
  Vector<dim>
  PointAttraction<dim>::at(const Vector<dim> &position) const
  {
    const Vector<dim> way = point - position;
    const double distance = std::max(norm(way), core_radius);
    return (acceleration * std::pow(reference_distance / distance, exponent) / distance) * way;
  }

  template <int dim>
  double
  attract(const PointAttraction<dim> &attraction, const double time_step, Body<dim> &body)
  {
    double largest_square = 0.;
    if (attraction.acts_on(body.name))
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        {
          const Vector<dim> acceleration = attraction.at(body.particles.position(p));
          largest_square                 = std::max(largest_square, norm_square(acceleration));
          for (int d = 0; d < dim; ++d)
            body.particles.component(ParticleProperty::velocity, d)[p] += time_step *
                                                                          acceleration[d];
        }
    return std::sqrt(largest_square);
  }

  template <int dim>
  Vector<dim>
  force_of(const PointAttraction<dim> &attraction, const Body<dim> &body)
  {
    Vector<dim> force;
    if (attraction.acts_on(body.name))
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        force += body.particles.component(ParticleProperty::mass, 0)[p] *
                 attraction.at(body.particles.position(p));
    return force;
  }

  template <int dim>
  Attraction<dim>::Attraction(const PointAttraction<dim> &parameters)
    : attraction(parameters)
  {
  }

  template <int dim>
  void
  Attraction<dim>::begin(const Vector<dim> &magnetic_force,
                         const std::vector<Body<dim>> &bodies,
                         const MPI_Comm communicator)
  {
    if (!attraction.matches_magnets)
      return;
    attraction.acceleration = 1.;
    Vector<dim> unit_force;
    for (const Body<dim> &body : bodies)
      unit_force += force_of(attraction, body);
    unit_force = parallel::sum(unit_force, communicator);
    if (!(norm(magnetic_force) > 0. && norm(unit_force) > 0.))
      throw RunError("'Attraction/Strength = match magnets' finds no force to match: that of the "
                     "magnets is " +
                     to_text(norm(magnetic_force)) + " N, that of an attraction of 1 m/s^2 is " +
                     to_text(norm(unit_force)) +
                     " N. Switch the magnets on at t = 0, take a Point outside of the bodies, or "
                     "give the acceleration.");
    attraction.acceleration = norm(magnetic_force) / norm(unit_force);
  }

  template <int dim>
  void
  Attraction<dim>::act(const Clock &clock, std::vector<Body<dim>> &bodies)
  {
    max_acceleration = 0.;
    if (!attraction.is_wanted())
      return;
    for (Body<dim> &body : bodies)
      max_acceleration = std::max(max_acceleration, attract(attraction, clock.time_step, body));
  }

  template <int dim>
  std::string
  Attraction<dim>::description() const
  {
    if (!attraction.is_wanted())
      return "";
    return "attraction: g0 = " + to_text(attraction.acceleration) + " m/s^2 at " +
           with_prefix(attraction.reference_distance, "m") + " from (" +
           components(attraction.point) + ") m" +
           (attraction.matches_magnets ? ", in total what the magnets exert at the start" : "");
  }

  template <int dim>
  void
  Attraction<dim>::limit_step(StepConditions &conditions) const
  {
    conditions.acceleration += max_acceleration;
  }

  template <int dim>
  void
  Attraction<dim>::reduce(parallel::Reduction &reduction)
  {
    reduction.max(max_acceleration);
  }

  template <int dim>
  SectionTitle
  Attraction<dim>::title() const
  {
    return {"attraction", 1};
  }

  template <int dim>
  std::string
  Attraction<dim>::save() const
  {
    return pack(std::make_pair(attraction.acceleration, max_acceleration));
  }

  template <int dim>
  void
  Attraction<dim>::load(const std::string &bytes)
  {
    std::pair<double, double> record;
    unpack(bytes, record);
    // A number that was given may be another one in the run that goes on.
    if (attraction.matches_magnets)
      attraction.acceleration = record.first;
    max_acceleration = record.second;
  }

#define INSTANTIATE(dim)                                                            \
  template class Attraction<dim>;                                                   \
  template struct PointAttraction<dim>;                                             \
  template double attract(const PointAttraction<dim> &, const double, Body<dim> &); \
  template Vector<dim> force_of(const PointAttraction<dim> &, const Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
