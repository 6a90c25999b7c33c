#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/smoothed_volume.h>

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

  /** What drives the two ends of a solid along x: nodes beyond a place move outward. */
  struct Grips
  {
    double lower, upper; ///< nodes up to here and from here on [m]
    double speed;        ///< of both, outward [m/s]
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

    /** Where the grips are at the start of a step, and how fast in it: of the time and the step [s]. */
    void
    set_grips(const std::function<Grips(double, double)> &grips);

    void
    step();

    double
    time() const
    {
      return now;
    }

    /** Kinetic, that of the affine velocities too, and elastic [J]. */
    double
    energy();

    /** What the grips did so far [J]. */
    double
    work_of_grips() const
    {
      return work;
    }

    /** The mean of the outward forces of the two grips in the last step [N]. */
    double
    force_of_grips() const
    {
      return force;
    }

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
      Matrix<dim>
        stress; ///< Kirchhoff, that from outside left out [Pa]; smoothed before the last step
      double volume;
    };

    std::vector<Point>
    points() const;

  private:
    /** Brings the particles to the arenas where they are now. */
    void
    sort();

    void
    smooth_volume();

    void
    add_stress(const double time_step);

    /** What grips do to the lattice. */
    struct Effect
    {
      double work    = 0.; ///< [J]
      double impulse = 0.; ///< outward, of both together [N s]
    };

    /** Gives the nodes in the grips their velocity. */
    Effect
    drive(const Grips &grips, NodeField<dim> &velocity) const;

    /** P v, and what particles take. */
    void
    filter(const double time_step);

    /** What is there of momentum becomes velocity. @param mass  of the nodes. */
    void
    divide(const NodeField<dim> &mass, NodeField<dim> &momentum) const;

    const FreeSolidParameters<dim> parameters;
    Lattice<dim> lattice;
    std::vector<Body<dim>> bodies;
    std::vector<Vector<dim>> starts; ///< by the number that a particle keeps
    double speed_of_sound;
    std::function<Matrix<dim>(const Vector<dim> &, const Matrix<dim> &)> stress_from_outside;
    std::function<Grips(double, double)> grips_at;

    BlockSet<dim> blocks;
    NodeField<dim> motion, filtered, taken;
    NodeField<dim, NodeStrain> strain;
    double now = 0., way = 0., max_speed = 0.;
    double work = 0., force = 0.; // of the grips
  };
} // namespace magmpm::verification
