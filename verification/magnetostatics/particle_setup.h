#pragma once

#include <magmpm/magnets/external_field.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_sort.h>

#include <mpi.h>

#include <verification/magnetostatics/magnetic_setup.h>

#include <vector>

namespace magmpm::verification
{
  /** A magnetic body given by its particles. */
  template <int dim>
  struct PointBody
  {
    std::vector<Vector<dim>> points; ///< the same on all ranks [m]
    double volume           = 0.;    ///< of the whole body as it is, in equal parts [m^dim]
    Matrix<dim> deformation = identity<dim>(); ///< F of all particles
    MagneticParameters magnetic;               ///< of the undeformed material
  };

  /**
   * Bodies of particles and sources at one instant, through mesh, partition, P2G, the potential and the
   * force, as a step of a scene takes them, with no motion. All functions but the constructor's
   * are collective, and their results are those of all ranks.
   */
  template <int dim>
  class ParticleSetup : private MagneticSetup<dim>
  {
  public:
    using MagneticSetup<dim>::MagneticSetup;

    /** Puts bodies in place of those before; mesh and partition follow. */
    void
    set_bodies(const std::vector<PointBody<dim>> &point_bodies);

    /** Finds the potential and the force, on the nodes and carried by the particles. */
    SolveReport
    solve(const ExternalField<dim> &sources);

    /** Sum of f_i [N]. */
    Vector<dim>
    force() const;

    /** Sum of m_p a_p over a body's particles [N]. */
    Vector<dim>
    force_on_body(const std::size_t body) const;

    /** S(a,b) = sum of f_a (x - centre)_b over the nodes [J]. */
    Matrix<dim>
    virial(const Vector<dim> &centre) const;

    /** The same of the forces that the particles carry. */
    Matrix<dim>
    virial_of_particles(const Vector<dim> &centre) const;

    /** The medium of this rank at the quadrature points; sampled when first asked for. */
    const std::vector<MaterialSample<dim>> &
    samples() const;

    /**
     * The integral of f(sample) over the box.
     *
     * @tparam Value  of f: double, Vector<dim> or Matrix<dim>.
     */
    template <typename Value, typename Function>
    Value
    integral(const Function &f) const
    {
      Value sum = {};
      for (const MaterialSample<dim> &sample : samples())
        sum += sample.weight * f(sample);
      return parallel::sum(sum, communicator);
    }

    /** Dipole moment, int M [A m^2]. */
    Vector<dim>
    moment() const
    {
      return integral<Vector<dim>>([](const auto &sample) { return sample.magnetization; });
    }

  private:
    using MagneticSetup<dim>::communicator;
    using MagneticSetup<dim>::lattice;
    using MagneticSetup<dim>::mesh;
    using MagneticSetup<dim>::partition;
    using MagneticSetup<dim>::problem;

    std::vector<Body<dim>> bodies;
    NodeField<dim, SingleVector> node_force;
    mutable std::vector<MaterialSample<dim>> medium; ///< empty: not asked for since the last solve

    void
    seed(const PointBody<dim> &point_body);

    void
    distribute_particles();

    NodeField<dim, NodeContent>
    magnetic_content();

    /** {momentum, mass}, ghosts updated. */
    NodeField<dim, SingleScalar>
    node_mass();

    /** Lets the particles carry the force, as accelerations. */
    void
    hand_force_to_particles(const NodeField<dim, SingleScalar> &mass);

    /** f_a (x - centre)_b over particles p with f = m a. */
    template <typename Action>
    void
    for_all_forces_of_particles(const std::size_t body, const Action &action) const;
  };
} // namespace magmpm::verification
