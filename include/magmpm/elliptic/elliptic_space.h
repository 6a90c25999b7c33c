#pragma once

#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <magmpm/elliptic/simd_lanes.h>
#include <magmpm/mesh/background_mesh.h>

#include <limits>
#include <memory>
#include <vector>

namespace magmpm
{
  /** Degree of the potential: with cells of edge 2 dx its support points are the lattice nodes. */
  inline constexpr int potential_degree = 2;

  /** Stands for a cell that has no entry in a table. */
  inline constexpr unsigned int invalid_entry = std::numeric_limits<unsigned int>::max();

  /** deal.II's MatrixFree, with as many cells in a batch as a SIMD register has numbers. */
  template <int dim, typename Number>
  using CellBatches = dealii::MatrixFree<dim, Number, CellLanes<Number>>;

  /**
   * All cells of @p dof_handler, or those of a level, with two rules: 0 is QGauss(3), which is exact for the
   * Laplacian, and 1 QGauss(2), for media.
   *
   * @param level  dealii::numbers::invalid_unsigned_int: the active cells.
   */
  template <int dim, typename Number>
  std::shared_ptr<const CellBatches<dim, Number>>
  make_cell_batches(const dealii::Mapping<dim> &mapping,
                    const dealii::DoFHandler<dim> &dof_handler,
                    const dealii::AffineConstraints<double> &constraints,
                    const unsigned int level);

  /** Coefficients of the potential; also its residual and the steps of Newton's method. */
  using PotentialVector = dealii::LinearAlgebra::distributed::Vector<double>;

  /**
   * The FE_Q(2) space of the potential on one state of the mesh: degrees of freedom, hanging
   * nodes, deal.II's MatrixFree, and the lattice cells (locally owned cells of the finest edge, 2 dx or
   * dx, the only ones that a medium can fill). Built anew after each change of the mesh. Other rooms
   * meet it by elliptic_problem.h, which does not include deal.II.
   */
  template <int dim>
  class EllipticSpace
  {
  public:
    using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

    /** @param with_levels  also number the degrees of freedom on the levels, for multigrid. */
    EllipticSpace(const BackgroundMesh<dim> &mesh, const bool with_levels);

    const BackgroundMesh<dim> &mesh;

    const dealii::FE_Q<dim> fe;
    const dealii::MappingQ1<dim> mapping;
    dealii::DoFHandler<dim> dof_handler;
    dealii::IndexSet relevant_dofs;

    dealii::AffineConstraints<double> constraints; ///< hanging nodes

    std::shared_ptr<const CellBatches<dim, double>> matrix_free;

    /** Lower node of every lattice cell. */
    std::vector<Index<dim>> lattice_cells;

    /** Entry in lattice_cells, or invalid_entry, by active_cell_index(). */
    std::vector<unsigned int> lattice_cell_of_active_cell;

    /** The same by lane of matrix_free: lane + n_lanes * batch. */
    std::vector<unsigned int> lattice_cell_of_lane;

    /** Corners of the box. */
    Vector<dim> lower_corner, upper_corner;

    unsigned int
    lattice_cell(const unsigned int batch, const unsigned int lane) const
    {
      return lattice_cell_of_lane[batch * CellLanes<double>::size() + lane];
    }

    /** A vector of this space with the ghosts that matrix_free needs; zero. */
    PotentialVector
    make_vector() const;

    /** A copy with all locally relevant values, hanging nodes included, for output and assembly. */
    PotentialVector
    with_ghosts(const PotentialVector &potential) const;

  private:
    void
    find_lattice_cells();
  };

  /** A potential and the space it belongs to. */
  template <int dim>
  struct EllipticSolution
  {
    std::unique_ptr<const EllipticSpace<dim>> space;
    PotentialVector potential; ///< hanging nodes not filled in
  };
} // namespace magmpm
