#include <magmpm/coupling/carried_force.h>
#include <magmpm/coupling/extrapolation.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  void
  recall_carried_force(const double way, Body<dim> &body)
  {
    if (!body.magnetic.is_magnetic())
      return;
    ParticleSet<dim> &particles = body.particles;
    for (int d = 0; d < dim; ++d)
      {
        const double *a = particles.component(ParticleProperty::magnetic_acceleration, d);
        double *rate    = particles.component(ParticleProperty::magnetic_acceleration_rate, d);
        for (std::size_t p = 0; p < particles.size(); ++p)
          rate[p] = a[p] - way * rate[p];
      }
  }

  template <int dim>
  void
  set_rate_of_carried_force(const double way, Body<dim> &body)
  {
    if (!body.magnetic.is_magnetic())
      return;
    ParticleSet<dim> &particles = body.particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        const Vector<dim> now    = particles.vector(ParticleProperty::magnetic_acceleration, p);
        const Vector<dim> before = particles.vector(ParticleProperty::magnetic_acceleration_rate,
                                                    p);
        const Vector<dim> rate   = extrapolation_rate(before, now, way);
        for (int d = 0; d < dim; ++d)
          particles.component(ParticleProperty::magnetic_acceleration_rate, d)[p] = rate[d];
      }
  }

  template <int dim>
  void
  advance_carried_force(const double way, Body<dim> &body)
  {
    if (!body.magnetic.is_magnetic() || way == 0.)
      return;
    ParticleSet<dim> &particles = body.particles;
    for (int d = 0; d < dim; ++d)
      {
        double *a          = particles.component(ParticleProperty::magnetic_acceleration, d);
        const double *rate = particles.component(ParticleProperty::magnetic_acceleration_rate, d);
        for (std::size_t p = 0; p < particles.size(); ++p)
          a[p] += way * rate[p];
      }
  }

  template <int dim>
  void
  freeze_carried_force(const double way, Body<dim> &body)
  {
    advance_carried_force(-way, body);
    for (int d = 0; d < dim && body.magnetic.is_magnetic(); ++d)
      std::fill_n(body.particles.component(ParticleProperty::magnetic_acceleration_rate, d),
                  body.particles.size(),
                  0.);
  }

  template <int dim>
  void
  drop_carried_force(Body<dim> &body)
  {
    for (const ParticleProperty property : {ParticleProperty::magnetic_acceleration,
                                            ParticleProperty::magnetic_acceleration_rate,
                                            ParticleProperty::magnetic_field})
      for (int d = 0; d < dim && body.magnetic.is_magnetic(); ++d)
        std::fill_n(body.particles.component(property, d), body.particles.size(), 0.);
  }

#define INSTANTIATE(dim)                                                   \
  template void recall_carried_force<dim>(const double, Body<dim> &);      \
  template void set_rate_of_carried_force<dim>(const double, Body<dim> &); \
  template void advance_carried_force<dim>(const double, Body<dim> &);     \
  template void freeze_carried_force<dim>(const double, Body<dim> &);      \
  template void drop_carried_force<dim>(Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
