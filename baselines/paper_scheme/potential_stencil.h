#pragma once

#include <baselines/paper_scheme/coefficient_rows.h>
#include <baselines/paper_scheme/node_vector.h>

#include <vector>

namespace magmpm::paper_scheme
{
  /** A node with material: where, and what the discretization needs of it. */
  template <int dim>
  struct MaterialTangent
  {
    Index<dim> node;
    Matrix<dim> tangent; ///< dM/dH [-]
  };

  /**
   * The Jacobian of the scheme, dx^dim G^T (I + dM/dH) G, with G the central differences of the
   * paper and, at open faces, the Robin terms. Free of a matrix: a stencil of 2 dim + 1 points and
   * spacing 2 dx on every node, and the products of two axes where material is anisotropic.
   */
  template <int dim>
  class PotentialStencil
  {
  public:
    explicit PotentialStencil(const NodeGrid<dim> &grid);

    /** The paper's shielding: no normal difference on any face. */
    void
    shield();

    /**
     * Open space, d(phi)/dn + (dim-1) (n.r)/r^2 phi = 0 on all faces, r from @p centre [m].
     *
     * Central differences split the nodes into 2^dim lattices of spacing 2 dx, each of which
     * carries 1/2^dim of the energy; each gets the condition on its own outermost nodes, half a
     * cell (dx) within its faces: on the two outermost layers of nodes, at half the area.
     *
     * @throw InputError if @p centre is not within the box.
     */
    void
    open(const Vector<dim> &centre);

    /** Sets dM/dH on the nodes with material, zero elsewhere. */
    void
    set_material(const std::vector<MaterialTangent<dim>> &material);

    /** @p y = J @p x. @return x.y */
    double
    apply(const NodeVector &x, NodeVector &y) const;

    /** Of the Jacobian. */
    void
    compute_diagonal(NodeVector &diagonal) const;

    /** The seven-point part of the Jacobian, without Robin terms. */
    const CoefficientRows<dim> &
    coefficients() const
    {
      return rows;
    }

    const NodeGrid<dim> &
    node_grid() const
    {
      return grid;
    }

    /** Whether constants on the 2^dim sublattices are in the null space, as no face is open. */
    bool
    is_singular() const
    {
      return robin.empty();
    }

  private:
    struct Robin
    {
      std::ptrdiff_t node;
      double coefficient; ///< [m^(dim-2)]
    };

    /** Off-diagonal entries of dM/dH at a node, times w of the vacuum. */
    struct Anisotropy
    {
      std::ptrdiff_t node;
      Matrix<dim> coefficient;
    };

    const NodeGrid<dim> grid;
    CoefficientRows<dim> rows;
    std::vector<Robin> robin;
    std::vector<Anisotropy> anisotropies;

    void
    open_layer(const Vector<dim> &centre, const int axis, const int layer, const int side);

    void
    apply_to_line(const std::ptrdiff_t line, const double *x, double *y) const;
  };

  /** G x: central differences, zero across the faces of the box. */
  template <int dim>
  inline Vector<dim>
  central_difference(const NodeGrid<dim> &grid, const NodeVector &x, const Index<dim> &node)
  {
    const std::ptrdiff_t i = grid.number(node);
    Vector<dim> result;
    for (int a = 0; a < dim; ++a)
      if (node[a] > 0 && node[a] < grid.n_cells[a])
        result[a] = (x[i + grid.stride(a)] - x[i - grid.stride(a)]) / (2. * grid.spacing);
    return result;
  }

  /**
   * Removes from @p x its mean on each of the 2^dim sublattices of spacing 2 dx. Their constants
   * are the null space of the central differences with the paper's Neumann condition.
   */
  template <int dim>
  void
  remove_sublattice_means(const NodeGrid<dim> &grid, NodeVector &x);
} // namespace magmpm::paper_scheme
