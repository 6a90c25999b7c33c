#pragma once

#include <magmpm/motion/pose.h>

namespace magmpm
{
  /** Numbers of the motion of a rigid body: of its velocity, then of its angular velocity. */
  template <int dim>
  inline constexpr int n_rigid_components = dim + n_axial_components<dim>;

  /** Velocity [m/s] and angular velocity [rad/s] as one vector; or momentum and angular momentum. */
  template <int dim>
  using RigidVector = Vector<n_rigid_components<dim>>;

  template <int dim>
  using RigidMatrix = Matrix<n_rigid_components<dim>>;

  template <int dim>
  inline RigidVector<dim>
  rigid_vector(const Vector<dim> &linear, const Vector<n_axial_components<dim>> &angular)
  {
    RigidVector<dim> result;
    for (int d = 0; d < dim; ++d)
      result[d] = linear[d];
    for (int k = 0; k < n_axial_components<dim>; ++k)
      result[dim + k] = angular[k];
    return result;
  }

  template <int dim>
  inline RigidMotion<dim>
  motion_of(const RigidVector<dim> &vector)
  {
    RigidMotion<dim> motion;
    for (int d = 0; d < dim; ++d)
      motion.velocity[d] = vector[d];
    for (int k = 0; k < n_axial_components<dim>; ++k)
      motion.angular_velocity[k] = vector[dim + k];
    return motion;
  }

  /** The momentum and angular momentum that @p impulse [N s] gives, @p from_centre [m] where it acts. */
  template <int dim>
  inline RigidVector<dim>
  momentum_of(const Vector<dim> &impulse, const Vector<dim> &from_centre)
  {
    return rigid_vector<dim>(impulse, cross(from_centre, impulse));
  }

  /** Of a matrix that has one. */
  template <int n>
  Matrix<n>
  inverse(const Matrix<n> &matrix);
} // namespace magmpm
