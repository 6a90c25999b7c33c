#pragma once

#include <magmpm/base/tensor.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace magmpm
{
  /** What a particle carries. */
  enum class ParticleProperty : int
  {
    position,
    velocity,
    affine_velocity, ///< the matrix C of APIC, by rows
    deformation,     ///< F by rows (solid), or J (fluid)
    mass,
    volume, ///< undeformed
    magnetic_acceleration,
    magnetic_acceleration_gradient,      ///< by rows
    magnetic_acceleration_rate,          ///< see carried_force.h
    magnetic_acceleration_gradient_rate, ///< likewise
    magnetic_field,                      ///< H at the last solve
    position_at_solve,                   ///< of the potential
    half_extent, ///< of solids: how far it fills its surroundings, undeformed; see ParticleExtent
    exposed_faces, ///< of solids: sum of 2^face over the sides on which nothing of the body was next to it
    volumetric_stress ///< of nearly incompressible solids; see smoothed_volume.h
  };

  inline constexpr int n_particle_properties = 15;

  /** Numbers of a symmetric matrix: the lower triangle, by rows. */
  template <int dim>
  inline constexpr int n_symmetric_components = dim *(dim + 1) / 2;

  /**
   * The arrays of a particle set as the kernels see them: one pointer per component.
   *
   * @tparam Number  double, or const double.
   */
  template <int dim, typename Number = double>
  struct ParticleArrays
  {
    Number *position[dim];
    Number *velocity[dim];
    Number *affine_velocity[dim * dim];
    Number *deformation[dim * dim]; ///< only the first one if the deformation is J
    Number *mass;
    Number *volume;
    Number *magnetic_acceleration[dim];                ///< null without magnetic material
    Number *magnetic_acceleration_gradient[dim * dim]; ///< likewise
    Number *magnetic_field[dim];                       ///< null without magnetic material
    Number *half_extent[n_symmetric_components<dim>];  ///< null of fluids
    Number *exposed_faces;                             ///< likewise
    Number *volumetric_stress;                         ///< null unless nearly incompressible
  };

  /**
   * Particles of one body as a structure of arrays: an array per component of each quantity, all in
   * the same order. The order is that of the last sort.
   */
  template <int dim>
  class ParticleSet
  {
  public:
    /**
     * @param stores_deformation_gradient  F; otherwise the volume ratio J alone.
     * @param is_magnetic                  whether magnetic quantities are stored at all.
     * @param smooths_volume               whether the volumetric stress is.
     */
    ParticleSet(const bool stores_deformation_gradient,
                const bool is_magnetic,
                const bool smooths_volume = false);

    std::size_t
    size() const
    {
      return identities.size();
    }

    void
    resize(const std::size_t n_particles);

    /** Components of a quantity that are stored; zero if it is not. */
    int
    n_components(const ParticleProperty quantity) const
    {
      return component_counts[static_cast<int>(quantity)];
    }

    double *
    component(const ParticleProperty quantity, const int c)
    {
      return column(first_component[static_cast<int>(quantity)] + c);
    }

    const double *
    component(const ParticleProperty quantity, const int c) const
    {
      return column(first_component[static_cast<int>(quantity)] + c);
    }

    /** A number per particle that stays with it and does not depend on the number of ranks. */
    const std::vector<std::uint64_t> &
    ids() const
    {
      return identities;
    }

    std::vector<std::uint64_t> &
    ids()
    {
      return identities;
    }

    Vector<dim>
    position(const std::size_t p) const
    {
      return vector(ParticleProperty::position, p);
    }

    Vector<dim>
    vector(const ParticleProperty quantity, const std::size_t p) const
    {
      Vector<dim> result;
      for (int d = 0; d < dim; ++d)
        result[d] = component(quantity, d)[p];
      return result;
    }

    ParticleArrays<dim>
    arrays();

    ParticleArrays<dim, const double>
    arrays() const;

    /** Numbers that describe one particle completely when it is sent to another rank. */
    int
    record_size() const
    {
      return static_cast<int>(components.size()) + 1;
    }

    void
    append_record(const std::size_t p, std::vector<double> &records) const;

    /** Takes in @p n_particles from as many records, one after the other. */
    void
    append_from_records(const double *records, const std::size_t n_particles);

    /** New order: particle order[i] comes to place i; particles not named are dropped. */
    void
    reorder(const std::vector<std::uint32_t> &order);

  private:
    /**
     * Numbers that column i leaves free before its first one, per column. Large arrays begin at the
     * same place of a page of memory, and so do all numbers of a particle: the first-level cache has
     * room for a few of these only, unless the columns are shifted against one another.
     */
    static constexpr std::size_t stagger = 24;

    double *
    column(const int i)
    {
      return components[i].data() + i * stagger;
    }

    const double *
    column(const int i) const
    {
      return components[i].data() + i * stagger;
    }

    std::array<int, n_particle_properties> component_counts;
    std::array<int, n_particle_properties> first_component;
    std::vector<std::vector<double>> components;
    std::vector<std::uint64_t> identities;
    std::vector<double> reordered; ///< memory of reorder()
  };
} // namespace magmpm
