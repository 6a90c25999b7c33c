#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>

#include <functional>
#include <vector>

namespace magmpm::verification
{
  /** An elastic box in free space; lengths in metres. */
  template <int dim>
  struct FreeSolidParameters
  {
    Vector<dim> lower_corner, upper_corner; ///< above the origin, which is a node
    double spacing;                         ///< dx
    double youngs_modulus = 1e6;            // Pa
    double poisson_ratio  = 0.;
    double density        = 1000.; // kg/m^3
    Transfer transfer     = Transfer::fmpm;
    double elastic_factor = 0.4; ///< dt c/dx
    double damping_rate   = 0.;  ///< 1/s, of the velocity against frame_velocity
    Vector<dim> frame_velocity;
  };

  /**
   * The particle kernels in a loop of their own, on one rank and without boundaries, for scenes that no
   * parameter file can state: particles that start with any velocity, and stresses from outside.
   */
  template <int dim>
  class FreeSolid
  {
  public:
    explicit FreeSolid(const FreeSolidParameters<dim> &parameters);

    /** v and grad v of all particles at the start. */
    void
    set_velocity(const std::function<Vector<dim>(const Vector<dim> &)> &velocity,
                 const std::function<Matrix<dim>(const Vector<dim> &)> &gradient);

    /**
     * A stress per undeformed volume beside the material's, of the start place and F [Pa]. It need not be
     * symmetric: then it is a couple.
     */
    void
    set_stress(const std::function<Matrix<dim>(const Vector<dim> &, const Matrix<dim> &)> &stress);

    void
    step();

    double
    time() const
    {
      return now;
    }

    /** Kinetic, that of the affine velocities too, and elastic [J]. */
    double
    energy() const;

    Vector<n_axial_components<dim>>
    angular_momentum() const;

    double
    wave_speed() const
    {
      return speed_of_sound;
    }

    /** One particle: where it was, where it is, how it is deformed. */
    struct Point
    {
      Vector<dim> start, position, velocity;
      Matrix<dim> deformation;
      double volume;
    };

    std::vector<Point>
    points() const;

  private:
    void
    add_stress(const double time_step);

    /** What is there of momentum becomes velocity. @param mass  of the nodes. */
    void
    divide(const NodeField<dim> &mass, NodeField<dim> &momentum) const;

    const FreeSolidParameters<dim> parameters;
    Lattice<dim> lattice;
    std::vector<Body<dim>> bodies;
    std::vector<Vector<dim>> starts; ///< by the number that a particle keeps
    double speed_of_sound;
    std::function<Matrix<dim>(const Vector<dim> &, const Matrix<dim> &)> stress_from_outside;

    BlockSet<dim> blocks;
    NodeField<dim> motion, filtered, taken;
    double now = 0., way = 0., max_speed = 0.;
  };
} // namespace magmpm::verification
