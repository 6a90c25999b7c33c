#pragma once

#include <magmpm/magnets/external_field.h>
#include <magmpm/materials/magnetization.h>

#include <baselines/paper_scheme/node_grid.h>

#include <vector>

namespace magmpm::paper_scheme
{
  /** A material point, as the scheme sees it. */
  template <int dim>
  struct Particle
  {
    Vector<dim> position;    ///< [m]
    double volume;           ///< undeformed, V_0 [m^dim]
    MagneticContent content; ///< of the full material
  };

  /** A node that particles reach (n_i > 0), and its state at the last solve. */
  template <int dim>
  struct MaterialNode
  {
    Index<dim> node;
    Vector<dim> position;        ///< [m]
    MagneticContent content;     ///< smeared: sum of N_i V_0 {M_s, chi_0} over dx^dim
    double volume;               ///< sum of N_i V_0 [m^dim]
    bool has_particle;           ///< in the cell of edge dx around it
    Vector<dim> source_field;    ///< H_ext [A/m]
    Vector<dim> self_difference; ///< G phi = -h [A/m]

    /** H [A/m]. */
    Vector<dim>
    field() const
    {
      return source_field - self_difference;
    }
  };

  /**
   * Transfers particles to the grid with quadratic B-splines, Eqs. (25)-(29), and evaluates the
   * sources on the nodes they reach.
   *
   * @return the nodes with material, x fastest.
   * @throw InputError if a particle lies closer than 2.5 dx to a face of the box.
   */
  template <int dim>
  std::vector<MaterialNode<dim>>
  material_nodes(const NodeGrid<dim> &grid,
                 const std::vector<Particle<dim>> &particles,
                 const ExternalField<dim> &sources);
} // namespace magmpm::paper_scheme
