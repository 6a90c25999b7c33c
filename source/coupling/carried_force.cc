#include <magmpm/coupling/carried_force.h>
#include <magmpm/coupling/extrapolation.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/magnetic_transfer.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  NodeField<dim, SingleVector>
  accelerations_to_carry(const BlockPartition<dim> &partition,
                         const Lattice<dim> &lattice,
                         const NodeField<dim, SingleScalar> &masses,
                         const NodeField<dim, SingleVector> &force,
                         std::vector<Body<dim>> &bodies)
  {
    constexpr auto vector       = SingleVector::value;
    const BlockSet<dim> &blocks = partition.blocks();
    const auto per_mass         = [&](const int slot, const int node, const Vector<dim> &f) {
      const double mass = masses.get(SingleScalar::value, slot, node);
      return (mass > 0. ? 1. / mass : 0.) * f;
    };
    NodeField<dim, SingleVector> accelerations(blocks.size()), carried(blocks.size());
    for_nodes(blocks, [&](const int slot, const int n) {
      accelerations.set(vector, slot, n, per_mass(slot, n, force.get(vector, slot, n)));
    });
    partition.update_ghosts(accelerations);

    carried_force_on_lattice(bodies, blocks, lattice, accelerations, carried);
    partition.add_ghosts_to_owners(carried, Parity());
    for_nodes(blocks, [&](const int slot, const int n) {
      const Vector<dim> missing = force.get(vector, slot, n) - carried.get(vector, slot, n);
      accelerations.add(vector, slot, n, per_mass(slot, n, missing));
    });
    partition.update_ghosts(accelerations);
    return accelerations;
  }

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
    for (const ParticleProperty property : {ParticleProperty::magnetic_acceleration,
                                            ParticleProperty::magnetic_acceleration_rate,
                                            ParticleProperty::magnetic_field})
      for (int d = 0; d < dim && body.magnetic.is_magnetic(); ++d)
        std::fill_n(body.particles.component(property, d), body.particles.size(), 0.);
  }

#define INSTANTIATE(dim)                                                   \
  template NodeField<dim, SingleVector> accelerations_to_carry(            \
    const BlockPartition<dim> &,                                           \
    const Lattice<dim> &,                                                  \
    const NodeField<dim, SingleScalar> &,                                  \
    const NodeField<dim, SingleVector> &,                                  \
    std::vector<Body<dim>> &);                                             \
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
