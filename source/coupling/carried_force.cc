#include <magmpm/coupling/carried_force.h>
#include <magmpm/coupling/extrapolation.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/magnetic_transfer.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** What carries the force, and the rate of each, component by component. */
    struct Carried
    {
      ParticleProperty value, rate;
    };

    constexpr Carried carried_quantities[] = {
      {ParticleProperty::magnetic_acceleration, ParticleProperty::magnetic_acceleration_rate},
      {ParticleProperty::magnetic_acceleration_gradient,
       ParticleProperty::magnetic_acceleration_gradient_rate}};

    /** Calls f(values, rates), the numbers of all particles, for each component of what they carry. */
    template <int dim, typename Function>
    void
    for_carried_components(ParticleSet<dim> &particles, const Function &f)
    {
      for (const Carried &carried : carried_quantities)
        for (int c = 0; c < particles.n_components(carried.value); ++c)
          f(particles.component(carried.value, c), particles.component(carried.rate, c));
    }

    /** The rate of an extrapolation by all components of a quantity together. */
    template <int dim, int n>
    void
    set_rate(const Carried &carried, const double way, ParticleSet<dim> &particles)
    {
      for (std::size_t p = 0; p < particles.size(); ++p)
        {
          Vector<n> now, before;
          for (int c = 0; c < n; ++c)
            {
              now[c]    = particles.component(carried.value, c)[p];
              before[c] = particles.component(carried.rate, c)[p];
            }
          const Vector<n> rate = extrapolation_rate(before, now, way);
          for (int c = 0; c < n; ++c)
            particles.component(carried.rate, c)[p] = rate[c];
        }
    }
  } // namespace

  template <int dim>
  void
  carry_force(const BlockPartition<dim> &partition,
              const Lattice<dim> &lattice,
              const NodeField<dim, SingleScalar> &masses,
              const NodeField<dim, SingleVector> &force,
              std::vector<Body<dim>> &bodies)
  {
    constexpr auto vector       = SingleVector::value;
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, SingleVector> accelerations(blocks.size());
    for_nodes(blocks, [&](const int slot, const int n) {
      const double mass = masses.get(SingleScalar::value, slot, n);
      accelerations.set(vector, slot, n, (mass > 0. ? 1. / mass : 0.) * force.get(vector, slot, n));
    });
    partition.update_ghosts(accelerations);
    accelerations_to_particles(accelerations, blocks, lattice, bodies);
  }

  template <int dim>
  void
  recall_carried_force(const double way, Body<dim> &body)
  {
    for_carried_components(body.particles, [&](const double *values, double *rates) {
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        rates[p] = values[p] - way * rates[p];
    });
  }

  template <int dim>
  void
  set_rate_of_carried_force(const double way, Body<dim> &body)
  {
    if (!body.magnetic.is_magnetic())
      return;
    set_rate<dim, dim>(carried_quantities[0], way, body.particles);
    set_rate<dim, dim * dim>(carried_quantities[1], way, body.particles);
  }

  template <int dim>
  void
  advance_carried_force(const double way, Body<dim> &body)
  {
    if (way == 0.)
      return;
    for_carried_components(body.particles, [&](double *values, const double *rates) {
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        values[p] += way * rates[p];
    });
  }

  template <int dim>
  void
  freeze_carried_force(const double way, Body<dim> &body)
  {
    advance_carried_force(-way, body);
    for_carried_components(body.particles, [&](const double *, double *rates) {
      std::fill_n(rates, body.particles.size(), 0.);
    });
  }

  template <int dim>
  double
  work_since_solve(const double way, const Body<dim> &body)
  {
    using Property = ParticleProperty;
    if (!body.magnetic.is_magnetic())
      return 0.;
    const ParticleSet<dim> &particles = body.particles;
    const double *mass                = particles.component(Property::mass, 0);
    double work                       = 0.;
    for (int d = 0; d < dim; ++d)
      {
        const double *a    = particles.component(Property::magnetic_acceleration, d);
        const double *rate = particles.component(Property::magnetic_acceleration_rate, d);
        const double *x    = particles.component(Property::position, d);
        const double *then = particles.component(Property::position_at_solve, d);
        for (std::size_t p = 0; p < particles.size(); ++p)
          work += mass[p] * (a[p] - 0.5 * way * rate[p]) * (x[p] - then[p]);
      }
    return work;
  }

  template <int dim>
  void
  drop_carried_force(Body<dim> &body)
  {
    const std::size_t n = body.particles.size();
    for_carried_components(body.particles, [&](double *values, double *rates) {
      std::fill_n(values, n, 0.);
      std::fill_n(rates, n, 0.);
    });
    for (int d = 0; d < body.particles.n_components(ParticleProperty::magnetic_field); ++d)
      std::fill_n(body.particles.component(ParticleProperty::magnetic_field, d), n, 0.);
  }

#define INSTANTIATE(dim)                                                   \
  template void carry_force(const BlockPartition<dim> &,                   \
                            const Lattice<dim> &,                          \
                            const NodeField<dim, SingleScalar> &,          \
                            const NodeField<dim, SingleVector> &,          \
                            std::vector<Body<dim>> &);                     \
  template void recall_carried_force<dim>(const double, Body<dim> &);      \
  template void set_rate_of_carried_force<dim>(const double, Body<dim> &); \
  template void advance_carried_force<dim>(const double, Body<dim> &);     \
  template void freeze_carried_force<dim>(const double, Body<dim> &);      \
  template double work_since_solve<dim>(const double, const Body<dim> &);  \
  template void drop_carried_force<dim>(Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
