#include <magmpm/particles/particle_set.h>

namespace magmpm
{
  template <int dim>
  ParticleSet<dim>::ParticleSet(const bool stores_deformation_gradient,
                                const bool is_magnetic,
                                const bool smooths_volume)
    : component_counts{dim,
                       dim,
                       dim * dim,
                       stores_deformation_gradient ? dim * dim : 1,
                       1,
                       1,
                       is_magnetic ? dim : 0,
                       is_magnetic ? dim * dim : 0,
                       is_magnetic ? dim : 0,
                       is_magnetic ? dim * dim : 0,
                       is_magnetic ? dim : 0,
                       is_magnetic ? dim : 0,
                       stores_deformation_gradient ? n_symmetric_components<dim> : 0,
                       stores_deformation_gradient ? 1 : 0,
                       smooths_volume ? 1 : 0}
  {
    int n = 0;
    for (int q = 0; q < n_particle_properties; ++q)
      {
        first_component[q] = n;
        n += component_counts[q];
      }
    components.resize(n);
    resize(0);
  }

  template <int dim>
  void
  ParticleSet<dim>::resize(const std::size_t n_particles)
  {
    identities.resize(n_particles);
    for (std::size_t i = 0; i < components.size(); ++i)
      components[i].resize(i * stagger + n_particles);
  }

  namespace
  {
    template <int dim, typename Number, typename Set>
    ParticleArrays<dim, Number>
    arrays_of(Set &particles)
    {
      ParticleArrays<dim, Number> arrays = {};
      const auto assign = [&particles](const ParticleProperty property, Number **pointers) {
        for (int c = 0; c < particles.n_components(property); ++c)
          pointers[c] = particles.component(property, c);
      };
      assign(ParticleProperty::position, arrays.position);
      assign(ParticleProperty::velocity, arrays.velocity);
      assign(ParticleProperty::affine_velocity, arrays.affine_velocity);
      assign(ParticleProperty::deformation, arrays.deformation);
      assign(ParticleProperty::mass, &arrays.mass);
      assign(ParticleProperty::volume, &arrays.volume);
      assign(ParticleProperty::magnetic_acceleration, arrays.magnetic_acceleration);
      assign(ParticleProperty::magnetic_acceleration_gradient,
             arrays.magnetic_acceleration_gradient);
      assign(ParticleProperty::magnetic_field, arrays.magnetic_field);
      assign(ParticleProperty::half_extent, arrays.half_extent);
      assign(ParticleProperty::exposed_faces, &arrays.exposed_faces);
      assign(ParticleProperty::volumetric_stress, &arrays.volumetric_stress);
      return arrays;
    }
  } // namespace

  template <int dim>
  ParticleArrays<dim>
  ParticleSet<dim>::arrays()
  {
    return arrays_of<dim, double>(*this);
  }

  template <int dim>
  ParticleArrays<dim, const double>
  ParticleSet<dim>::arrays() const
  {
    return arrays_of<dim, const double>(*this);
  }

  template <int dim>
  void
  ParticleSet<dim>::append_record(const std::size_t p, std::vector<double> &records) const
  {
    // Identities stay far below 2^53, so that a double holds them exactly.
    records.push_back(static_cast<double>(identities[p]));
    for (std::size_t i = 0; i < components.size(); ++i)
      records.push_back(column(i)[p]);
  }

  template <int dim>
  void
  ParticleSet<dim>::append_from_records(const double *records, const std::size_t n_particles)
  {
    for (std::size_t i = 0; i < n_particles; ++i)
      {
        identities.push_back(static_cast<std::uint64_t>(*records++));
        for (auto &component : components)
          component.push_back(*records++);
      }
  }

  template <int dim>
  void
  ParticleSet<dim>::reorder(const std::vector<std::uint32_t> &order)
  {
    for (std::size_t i = 0; i < components.size(); ++i)
      {
        reordered.resize(i * stagger + order.size());
        for (std::size_t p = 0; p < order.size(); ++p)
          reordered[i * stagger + p] = column(i)[order[p]];
        components[i].swap(reordered);
      }
    std::vector<std::uint64_t> ids(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      ids[i] = identities[order[i]];
    identities.swap(ids);
  }

  template class ParticleSet<2>;
  template class ParticleSet<3>;
} // namespace magmpm
