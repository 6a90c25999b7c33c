#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/lattice/cell_stencil.h>

#include <array>

namespace magmpm
{
  /** Vectors at the quadrature points of a cell, x fastest. */
  template <int dim>
  using PointVectors = std::array<Vector<dim>, n_points<dim>>;

  /** Matrices at the quadrature points of a cell, x fastest. */
  template <int dim>
  using PointMatrices = std::array<Matrix<dim>, n_points<dim>>;

  /**
   * What fills the lattice cells of an elliptic problem, div q(grad phi) = 0: the flux q that it answers
   * to the gradient of the potential. q is the derivative of a strictly convex energy density, so that
   * K = dq/d(grad phi) is symmetric positive definite. A linear medium with a source s inside has
   * q = K grad phi - s. Cells that it does not fill have q = grad phi, which costs nothing.
   */
  template <int dim>
  class EllipticMedium
  {
  public:
    virtual ~EllipticMedium() = default;

    /** Whether q is affine in grad phi: then one linear system is the solution. */
    virtual bool
    is_linear() const = 0;

    /** Whether the cell holds any of it; lattice cells are numbered by EllipticProblem. */
    virtual bool
    fills(const unsigned int lattice_cell) const = 0;

    /**
     * The flux at the points of a cell that it fills.
     *
     * @param flux     grad phi on entry, q on return.
     * @param tangent  K on return.
     * @return the integral over the cell of the energy density less |grad phi|^2/2.
     */
    virtual double
    respond(const unsigned int lattice_cell,
            PointVectors<dim> &flux,
            PointMatrices<dim> &tangent) const = 0;
  };
} // namespace magmpm
