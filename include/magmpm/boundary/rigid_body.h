#pragma once

#include <magmpm/boundary/mass_properties.h>
#include <magmpm/boundary/rigid_vector.h>
#include <magmpm/boundary/surface_contact.h>
#include <magmpm/geometry/shape.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace magmpm
{
  /**
   * A rigid body: a shape that moves as one piece. What moves a kinematic one is a script; a free one
   * has mass and inertia, and obeys Newton's and Euler's equations
   *   m dV/dt = F,   dL/dt = T,   L = R diag(I) R^T omega,
   * with L about the centre of mass in the frame of the world, so that the gyroscopic term is in the
   * rotation alone.
   *
   * Its own frame has the axes of the shape's and its origin in the centroid of the shape, which is
   * the centre of mass. In 2D everything is per metre of depth.
   */
  template <int dim>
  class RigidBody
  {
  public:
    using Axial = Vector<n_axial_components<dim>>;

    /**
     * A kinematic body, its shape in the world as given, at rest.
     *
     * @param shape  shared: copies of a body have the same.
     */
    RigidBody(std::string name,
              std::shared_ptr<const Shape<dim>> shape,
              const SurfaceContact &contact);

    /** Gives the body mass, and makes it free. @param mass  greater than 0 [kg]. */
    void
    set_free(const double mass);

    bool
    is_free() const
    {
      return properties.has_value();
    }

    /** Of a kinematic body: where its shape is now, and how that moves (about the shape's origin). */
    void
    place(const Pose<dim> &pose_of_shape, const RigidMotion<dim> &motion_of_shape);

    /** Of a kinematic body: where its own frame is now, and how that moves. */
    void
    move_to(const Pose<dim> &pose, const RigidMotion<dim> &motion);

    /** Of a free body: its motion now, about the centre of mass. */
    void
    set_motion(const RigidMotion<dim> &motion);

    /** Of a free body: moves it to @p pose, with the angular momentum that it has. */
    void
    set_pose(const Pose<dim> &pose);

    /** Of a free body: impulse [N s] and angular impulse about the centre of mass [N m s]. */
    void
    add_impulse(const Vector<dim> &impulse, const Axial &angular_impulse);

    /**
     * Of a free body: moves it for @p time_step [s] with the momentum and angular momentum that it
     * has. The rotation is that of Dullweber, Leimkuhler & McLachlan, J. Chem. Phys. 107 (1997) 5840:
     * rotations about the principal axes one after the other, symmetrically; symplectic, of second
     * order, and without any error in the angular momentum. Exact in 2D.
     */
    void
    advance(const double time_step);

    /** The frame of the body. */
    const Pose<dim> &
    pose() const
    {
      return current_pose;
    }

    /** The frame of the shape. */
    Pose<dim>
    pose_of_shape() const;

    /** About the origin of the frame of the body. */
    RigidMotion<dim>
    motion() const;

    /** How the frame of the shape moves, about its own origin. */
    RigidMotion<dim>
    motion_of_shape() const;

    /** [m/s] */
    Vector<dim>
    velocity_at(const Vector<dim> &point) const
    {
      return motion().velocity_at(point - current_pose.position);
    }

    /** Of its fastest point, or above [m/s]. */
    double
    max_speed() const;

    /** Nearest point of the surface, in the world. */
    SurfaceDistance<dim>
    surface_distance(const Vector<dim> &point) const;

    /** Whether @p point is within @p distance [m] of the ball around the origin that holds the shape. */
    bool
    is_near(const Vector<dim> &point, const double distance) const
    {
      const double reach = radius + distance;
      return norm_square(point - current_pose.position) < reach * reach;
    }

    /** Of the smallest ball around the origin of the frame that holds the shape, or above [m]. */
    double
    bounding_radius() const
    {
      return radius;
    }

    /** Points of the surface in the frame of the body, at most @p spacing [m] apart. */
    std::vector<Vector<dim>>
    surface_points(const double spacing) const;

    const SurfaceContact &
    contact() const
    {
      return surface_contact;
    }

    const std::string &
    name() const
    {
      return body_name;
    }

    const Shape<dim> &
    shape() const
    {
      return *body_shape;
    }

    /** [kg]; of a free body. */
    double
    mass() const
    {
      return properties->mass;
    }

    /** About the centre of mass, in the world [kg m^2]; of a free body. */
    Matrix<n_axial_components<dim>>
    inertia() const;

    /** About the centre of mass [kg m^2/s]; of a free body. */
    const Axial &
    angular_momentum() const
    {
      return momentum_of_rotation;
    }

    /** [J]; of a free body. */
    double
    kinetic_energy() const;

    /** Appends all that changes of a free body, for a checkpoint. */
    void
    append_record(std::vector<double> &record) const;

    /** Takes from @p record at @p place what append_record() wrote, and moves @p place on. */
    void
    read_record(const std::vector<double> &record, std::size_t &place);

  private:
    /** Components of @p axial along the principal axes. */
    Axial
    along_axes(const Axial &axial) const;

    /** Rotates about the principal axis @p k as fast as the angular momentum says. */
    void
    turn(const int k, const double time_step);

    std::string body_name;
    std::shared_ptr<const Shape<dim>> body_shape;
    SurfaceContact surface_contact;
    Vector<dim> centroid; ///< in the frame of the shape [m]
    double radius = 0.;   ///< [m]
    std::optional<MassProperties<dim>> properties;

    Pose<dim> current_pose;
    Vector<dim> velocity;       ///< of the origin [m/s]
    Axial angular_velocity;     ///< of a kinematic body [rad/s]
    Axial momentum_of_rotation; ///< of a free body, about its centre of mass [kg m^2/s]
  };
} // namespace magmpm
