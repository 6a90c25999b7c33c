#pragma once

#include <magmpm/base/tensor.h>

namespace magmpm
{
  /** Where a rigid thing is: a point X of its own frame lies at x = position + rotation X [m]. */
  template <int dim>
  struct Pose
  {
    Vector<dim> position;
    Matrix<dim> rotation = identity<dim>(); ///< orthogonal, determinant 1

    Vector<dim>
    to_world(const Vector<dim> &own) const
    {
      return position + rotation * own;
    }

    Vector<dim>
    to_own(const Vector<dim> &world) const
    {
      return transpose(rotation) * (world - position);
    }
  };

  /** How a rigid thing moves: the point at x with v = velocity + angular_velocity x (x - position). */
  template <int dim>
  struct RigidMotion
  {
    Vector<dim> velocity;                             ///< of the origin of its frame [m/s]
    Vector<n_axial_components<dim>> angular_velocity; ///< [rad/s]

    Vector<dim>
    velocity_at(const Vector<dim> &from_position) const
    {
      return velocity + rotation_velocity<dim>(angular_velocity, from_position);
    }
  };

  /**
   * The rotation by |angle| about the direction of @p angle (Rodrigues' formula); in 2D by the angle
   * itself, counterclockwise.
   *
   * @param angle  axis times angle [rad].
   */
  template <int dim>
  inline Matrix<dim>
  rotation_by(const Vector<n_axial_components<dim>> &angle)
  {
    const double size = norm(angle);
    // sin(a)/a and (1 - cos(a))/a^2, the latter without cancellation.
    const double sinc      = size > 0. ? std::sin(size) / size : 1.;
    const double half_sinc = size > 0. ? std::sin(0.5 * size) / (0.5 * size) : 1.;
    Matrix<dim> generator; // X -> angle x X
    for (int d = 0; d < dim; ++d)
      {
        Vector<dim> direction;
        direction[d]             = 1.;
        const Vector<dim> column = rotation_velocity<dim>(angle, direction);
        for (int c = 0; c < dim; ++c)
          generator(c, d) = column[c];
      }
    return identity<dim>() + sinc * generator +
           (0.5 * half_sinc * half_sinc) * (generator * generator);
  }

  /** Axis times angle [rad] of a rotation, by no more than half a turn: what rotation_by() takes. */
  template <int dim>
  Vector<n_axial_components<dim>>
  rotation_vector(const Matrix<dim> &rotation);
} // namespace magmpm
