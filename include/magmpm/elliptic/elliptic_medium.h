#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/lattice/cell_quadrature.h>

#include <array>

namespace magmpm
{
  /** Vectors at the points of QGauss(3) in a cell, x fastest. */
  template <int dim>
  using PointVectors = std::array<Vector<dim>, n_points<dim>>;

  /** Vectors at the points of QGauss(2), one in each octant of a cell, x fastest. */
  template <int dim>
  using OctantVectors = std::array<Vector<dim>, n_octants<dim>>;

  /** Matrices there. */
  template <int dim>
  using OctantMatrices = std::array<Matrix<dim>, n_octants<dim>>;

  /** How a medium answers. */
  enum class MediumResponse
  {
    full,
    weak_field ///< A is that of grad phi = 0 at every gradient, and p is affine
  };

  /**
   * What fills the lattice cells of an elliptic problem, div q(grad phi) = 0: what it adds to the flux of
   * the vacuum, q = grad phi + p(grad phi). p is the derivative of a convex energy density, so that
   * A = dp/d(grad phi) is symmetric positive semidefinite. A linear medium with a source s inside has
   * p = A grad phi - s. Cells that it does not fill have q = grad phi, which costs nothing.
   *
   * It is evaluated at one point in each octant. Along a normal, grad phi is linear in a cell: two
   * numbers, which can meet the jumps of a medium at two points. At more it locks, that is, thin
   * plates and whatever is strongly permeable become too stiff. These points do not see some potentials
   * of a cell, such as P_2(x) P_2(y), which vacuum alone then holds; stabilization() gives them a part of the
   * medium's stiffness.
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
     * The flux in the octants of a cell that it fills.
     *
     * @param response  that of weak fields gives a start for Newton's method: from the other side, where a
     *                  medium is saturated and says little of its stiffness, steps overshoot.
     * @param flux      grad phi on entry, p on return.
     * @param tangent   A on return.
     * @return the integral of the energy density of p over the cell.
     */
    virtual double
    respond(const unsigned int lattice_cell,
            const MediumResponse response,
            OctantVectors<dim> &flux,
            OctantMatrices<dim> &tangent) const = 0;

    /**
     * s, not negative: the energy of a cell that it fills is more by s/2 times the difference between the
     * exact integral of |grad phi|^2 and that by the octants, which is not negative either, and of order
     * h^4 where the potential is smooth.
     */
    virtual double
    stabilization(const unsigned int lattice_cell) const = 0;

    /** The largest eigenvalue of A in weak fields, or what comes near it, of this rank's cells. */
    virtual double
    largest_weak_tangent() const = 0;
  };
} // namespace magmpm
