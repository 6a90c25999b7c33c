#pragma once

#include <magmpm/materials/magnetization.h>
#include <magmpm/materials/material_parameters.h>
#include <magmpm/materials/neo_hookean.h>
#include <magmpm/materials/viscoelastic_fluid.h>
#include <magmpm/particles/body_parameters.h>
#include <magmpm/particles/particle_set.h>

#include <string>
#include <variant>
#include <vector>

namespace magmpm
{
  template <int dim>
  using Material = std::variant<NeoHookean<dim>, ViscoelasticFluid<dim>>;

  /**
   * A named body: its material and this rank's particles of it. Particles of one body obey one law,
   * so a kernel call works on one run of one body in one block.
   */
  template <int dim>
  struct Body
  {
    Body(const BodyParameters<dim> &parameters, const MaterialParameters &material);

    std::string name;
    Material<dim> material;
    MagneticParameters magnetic;
    Transfer transfer;
    double surface_tension; ///< [N/m], of fluids; 0: none
    int contact_group;
    ParticleSet<dim> particles;

    /** Particles of the block in slot s, an owned one: run_begin[s] to run_begin[s + 1]. */
    std::vector<std::size_t> run_begin;
  };

  template <int dim>
  inline bool
  is_fluid(const Body<dim> &body)
  {
    return std::holds_alternative<ViscoelasticFluid<dim>>(body.material);
  }

  /** Stands for bodies of all contact groups. */
  inline constexpr int every_group = -1;

  template <int dim>
  inline bool
  is_in_group(const Body<dim> &body, const int group)
  {
    return group == every_group || body.contact_group == group;
  }
} // namespace magmpm
