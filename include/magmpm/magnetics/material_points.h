#pragma once

#include <magmpm/magnetics/cell_stencil.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/materials/magnetization.h>

#include <limits>
#include <vector>

namespace magmpm
{
  /**
   * The magnetic medium at the quadrature points of the mesh: what the potential problem knows of
   * material. Content comes from node fields through quadratic B-splines of spacing dx; the field of
   * the sources is evaluated here, and only where material is.
   *
   * The medium is the smeared one: content interpolated from the nodes, M = M(content, H). (A sharp
   * indicator and the two-phase laminate of a cut cell belong here: they change reinit() and
   * response(), whose M, tangent and coenergy density are those of the mixture at a point.)
   */
  template <int dim>
  class MaterialPoints
  {
  public:
    static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

    /**
     * Finds the cells with material among @p lattice_cells and evaluates content and sources there.
     *
     * @param lattice_cells  lower nodes of this rank's mesh cells of edge 2 dx.
     * @param content        on the nodes of @p blocks, ghosts updated: lanes {volume fraction [-],
     *                       density of saturation magnetization [A/m], of susceptibility [-], of
     *                       grains [1/m^3]}.
     */
    void
    reinit(const std::vector<Index<dim>> &lattice_cells,
           const BlockSet<dim> &blocks,
           const NodeField<dim> &content,
           const ExternalField<dim> &sources,
           const Lattice<dim> &lattice,
           const MagnetizationLaw law);

    /** The slot of the owned active block that holds a lattice cell, or invalid_slot. */
    int
    slot(const unsigned int lattice_cell) const
    {
      return cells[lattice_cell].slot;
    }

    /** The cell's lower node within its block. */
    const Index<dim> &
    corner(const unsigned int lattice_cell) const
    {
      return cells[lattice_cell].corner;
    }

    /** Number of the first quadrature point of a lattice cell, or none where no material is. */
    unsigned int
    first_point(const unsigned int lattice_cell) const
    {
      return lattice_cell == none ? none : cells[lattice_cell].first_point;
    }

    /** The lower node of a lattice cell [m]. */
    const Vector<dim> &
    cell_position(const unsigned int lattice_cell) const
    {
      return cells[lattice_cell].position;
    }

    /** Of the quadrature point @p q of every cell from the lower node of the cell [m]. */
    const Vector<dim> &
    point_position(const int q) const
    {
      return positions[q];
    }

    /** Points in cells with material. */
    unsigned int
    size() const
    {
      return static_cast<unsigned int>(points.size());
    }

    /** Magnetization, its tangent and its coenergy density in the field of the sources plus @p self_field. */
    MagneticResponse<dim>
    response(const unsigned int point, const Vector<dim> &self_field) const;

    /** H of the sources [A/m]; zero at points without material. */
    const Vector<dim> &
    source_field(const unsigned int point) const
    {
      return points[point].field;
    }

    /** dH_i/dx_j of the sources [A/m^2]; zero at points without material. */
    const Matrix<dim> &
    source_gradient(const unsigned int point) const
    {
      return points[point].gradient;
    }

    /** Of the quadrature point @p q (0 .. n_points - 1) of every cell; they sum to (2 dx)^dim. */
    double
    weight(const int q) const
    {
      return weights[q];
    }

    double
    volume_fraction(const unsigned int point) const
    {
      return points[point].volume_fraction;
    }

    /** Sum over this rank's points of w |M(H of the sources)| {1, x}: weight and first moment. */
    std::pair<double, Vector<dim>>
    magnetized_weight() const
    {
      return {total_weight, first_moment};
    }

  private:
    struct Cell
    {
      int slot = invalid_slot;
      Index<dim> corner;
      Vector<dim> position;
      unsigned int first_point = none;
    };

    struct Point
    {
      MagneticContent content;
      double volume_fraction;
      Vector<dim> field;
      Matrix<dim> gradient;
    };

    CellStencil<dim> stencil;
    MagnetizationLaw law;
    std::vector<Cell> cells;
    std::vector<Point> points;
    double total_weight = 0.;
    Vector<dim> first_moment;

    std::array<double, n_points<dim>> weights;
    std::array<Vector<dim>, n_points<dim>> positions; ///< from the lower node of a cell [m]

    void
    add_cell(const Index<dim> &lower_node,
             const PointValues<dim> &content,
             const ExternalField<dim> &sources,
             const Lattice<dim> &lattice);
  };
} // namespace magmpm
