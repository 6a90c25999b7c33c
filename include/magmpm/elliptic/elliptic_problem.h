#pragma once

#include <magmpm/elliptic/elliptic_medium.h>
#include <magmpm/elliptic/elliptic_parameters.h>
#include <magmpm/elliptic/elliptic_report.h>
#include <magmpm/mesh/background_mesh.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace magmpm::parallel
{
  class PhaseTimer;
}

namespace magmpm
{
  template <int dim>
  struct EllipticSolution;

  /**
   * A nonlinear elliptic problem on the mesh: finds the potential phi with div q(grad phi) = 0, q the
   * flux that a medium answers (EllipticMedium), with FE_Q(2), open or shielded faces (OpenBoundary),
   * Newton's method with the exact tangent, and CG preconditioned by geometric or algebraic multigrid.
   * What the medium and the potential are is the business of its user. Unlike most headers of this
   * room, this one is for other rooms: it includes nothing of deal.II.
   */
  template <int dim>
  class EllipticProblem
  {
  public:
    /**
     * @param mesh     may still be unrefined; it and @p timer must outlive this object.
     * @param unknown  what messages call the potential.
     */
    EllipticProblem(const BackgroundMesh<dim> &mesh,
                    const EllipticParameters &parameters,
                    const std::string &unknown,
                    parallel::PhaseTimer &timer);
    ~EllipticProblem();

    /**
     * Sets everything up for the present state of the mesh, if that is another one than last time: the
     * potential is then zero. To be called before all that follows. Collective.
     */
    void
    follow_mesh();

    /**
     * Lower nodes of this rank's lattice cells: mesh cells of the finest edge, the only ones that a medium
     * can fill. They are known by their number in this list.
     */
    const std::vector<Index<dim>> &
    lattice_cells() const;

    /** The middle of the box [m]. */
    Vector<dim>
    middle() const;

    /**
     * What is beyond the faces -x, +x, -y, ... of the box: a mirror where @p shielded, elsewhere open space
     * with the field of a dipole at @p centre [m].
     */
    void
    set_boundary(const std::array<bool, 2 * dim> &shielded, const Vector<dim> &centre);

    /**
     * Solves for this medium. Starts from the last potential, or from the last two continued, and from
     * zero after a change of the mesh. Collective.
     *
     * @throw RunError if Newton's method or CG does not converge, with the residuals.
     */
    EllipticReport
    solve(const EllipticMedium<dim> &medium);

    /**
     * Calls action(lattice cell, grad phi at its points and in its octants) for the lattice cells of this
     * rank that are wanted. Collective.
     */
    void
    for_gradients(const std::function<bool(const unsigned int)> &is_wanted,
                  const std::function<void(const unsigned int,
                                           const PointVectors<dim> &,
                                           const OctantVectors<dim> &)> &action) const;

    /** Degrees of freedom of the potential, of all ranks; zero before the first follow_mesh(). */
    unsigned long long
    n_unknowns() const;

    /**
     * The potential of the last solve and the space it lives in, for output and tests; valid until the
     * next one. Includes elliptic_space.h to be read.
     */
    const EllipticSolution<dim> &
    solution() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace magmpm
