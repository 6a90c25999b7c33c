#pragma once

#include <magmpm/particles/body.h>

#include <baselines/plain_particles/plain_lattice.h>

#include <variant>
#include <vector>

namespace magmpm::baselines
{
  template <int dim, typename Law>
  struct PlainParticle
  {
    Vector<dim> position;
    Vector<dim> velocity;
    Matrix<dim> affine_velocity;
    typename Law::State deformation;
    double mass;
    double volume; ///< undeformed
  };

  /** Particles of one law, an array of structures. */
  template <int dim, typename Law>
  struct PlainBody
  {
    Law law;
    std::vector<PlainParticle<dim, Law>> particles;
  };

  /**
   * The step of the material point method as one writes it down: particle by particle and node by
   * node, scalar numbers, an array of structures, a dense lattice in the bounding box of the
   * particles. The kernels of magmpm are compared with it, their results and their speed. Without
   * magnetic forces.
   */
  template <int dim>
  class PlainParticles
  {
  public:
    /** Copies of the bodies' particles, in their order. */
    PlainParticles(const Lattice<dim> &lattice, const std::vector<Body<dim>> &bodies);

    std::size_t
    size() const;

    /** Brings the particles of each body into the order of their base nodes. */
    void
    sort();

    /** P2G as particles_to_lattice(), Eq. (28). */
    void
    particles_to_lattice(const double time_step);

    /**
     * Momentum to velocity, with gravity [m/s^2] along the last axis; on nodes at or below @p floor,
     * counted along that axis, not downward.
     */
    void
    update_lattice(const double time_step, const double gravity, const int floor);

    /** G2P and advection as lattice_to_particles(), Eqs. (35-37). */
    void
    lattice_to_particles(const double time_step);

    /** The lattice since the last call of one of the three functions above. */
    const PlainLattice<dim> &
    nodes() const
    {
      return plain_lattice;
    }

    /** The bodies with the particles as they are now, in their present order. */
    void
    copy_to(std::vector<Body<dim>> &bodies) const;

  private:
    using AnyBody =
      std::variant<PlainBody<dim, NeoHookean<dim>>, PlainBody<dim, ViscoelasticFluid<dim>>>;

    Lattice<dim> lattice;
    std::vector<AnyBody> bodies;
    PlainLattice<dim> plain_lattice;
  };
} // namespace magmpm::baselines
