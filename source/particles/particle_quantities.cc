#include <magmpm/particles/particle_quantities.h>
#include <magmpm/particles/particle_state.h>

namespace magmpm
{
  template <int dim>
  double
  particle_volume_ratio(const Body<dim> &body, const std::size_t p)
  {
    return std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        return law.volume_ratio(load_state<dim, Law>(body.particles.arrays(), p));
      },
      body.material);
  }

  template <int dim>
  double
  particle_von_mises_stress(const Body<dim> &body, const std::size_t p)
  {
    const auto particles = body.particles.arrays();
    return std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        return law.von_mises_stress(load_state<dim, Law>(particles, p),
                                    load_matrix<dim>(particles.affine_velocity, p));
      },
      body.material);
  }

  template <int dim>
  Vector<dim>
  particle_magnetization(const Body<dim> &body, const MagnetizationModel &law, const std::size_t p)
  {
    if (!body.magnetic.is_magnetic())
      return {};
    return diluted_magnetization(body.magnetic,
                                 law,
                                 particle_volume_ratio(body, p),
                                 body.particles.vector(ParticleProperty::magnetic_field, p));
  }

  template <int dim>
  const std::vector<ParticleQuantity<dim>> &
  particle_quantities()
  {
    using At                                             = WrittenParticle<dim>;
    static const std::vector<ParticleQuantity<dim>> list = {
      {"velocity",
       "m/s",
       [](const At &at) { return at.body.particles.vector(ParticleProperty::velocity, at.p); }},
      {"J", "-", [](const At &at) { return particle_volume_ratio(at.body, at.p); }},
      {"von_mises_stress",
       "Pa",
       [](const At &at) { return particle_von_mises_stress(at.body, at.p); }},
      {"magnetization",
       "A/m",
       [](const At &at) { return particle_magnetization(at.body, at.law, at.p); }},
      {"body", "-", [](const At &at) { return static_cast<double>(at.number_of_body); }}};
    return list;
  }

#define INSTANTIATE(dim)                                                     \
  template Vector<dim> particle_magnetization(                               \
    const Body<dim> &, const MagnetizationModel &, std::size_t);             \
  template double particle_volume_ratio(const Body<dim> &, std::size_t);     \
  template double particle_von_mises_stress(const Body<dim> &, std::size_t); \
  template const std::vector<ParticleQuantity<dim>> &particle_quantities();

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
