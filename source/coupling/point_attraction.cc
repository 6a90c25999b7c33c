#include <magmpm/coupling/point_attraction.h>

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

#define INSTANTIATE(dim)                                                            \
  template struct PointAttraction<dim>;                                             \
  template double attract(const PointAttraction<dim> &, const double, Body<dim> &); \
  template Vector<dim> force_of(const PointAttraction<dim> &, const Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
