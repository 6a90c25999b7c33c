#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/boundary/rigid_body_parameters.h>

#include <optional>
#include <string>
#include <vector>

namespace magmpm
{
  /** A rigid body of a scene, and what moves it if forces do not. */
  template <int dim>
  struct MovedBody
  {
    /** What a script says where it is. */
    enum class Frame
    {
      body, ///< RigidBody::pose()
      shape ///< RigidBody::pose_of_shape()
    };

    RigidBody<dim> body;
    TimeFunction<Pose<dim>> script; ///< of a body that is not free
    Frame frame = Frame::body;
    std::optional<std::size_t> source; ///< the number of the magnet that it is, if it is one
  };

  /**
   * A body of @p shape, which lies at @p pose at the start; free, if its properties say so.
   *
   * @param shape  shared: copies of the body have the same.
   */
  template <int dim>
  RigidBody<dim>
  make_rigid_body(const std::string &name,
                  const std::shared_ptr<const Shape<dim>> &shape,
                  const RigidBodyProperties<dim> &properties,
                  const Pose<dim> &pose = {});

  /** Those of the section 'Rigid bodies'. @throw InputError  if a shape cannot be made. */
  template <int dim>
  std::vector<MovedBody<dim>>
  make_rigid_bodies(const std::vector<RigidBodyParameters<dim>> &parameters);

  /** All rigid bodies of a scene and their poses, which nobody else has. The same on all ranks. */
  template <int dim>
  class RigidBodies
  {
  public:
    /** The bodies at time zero. */
    explicit RigidBodies(const std::vector<MovedBody<dim>> &moved);

    /** Moves scripted bodies to where they are at @p time >= 0 [s]. */
    void
    set_time(const double time);

    std::vector<RigidBody<dim>> &
    all()
    {
      return bodies;
    }

    const std::vector<RigidBody<dim>> &
    all() const
    {
      return bodies;
    }

    bool
    any_is_free() const;

    /** Whether a magnet is free. */
    bool
    any_magnet_is_free() const;

    /** The magnet that body number @p body is, by its number among the sources. */
    std::optional<std::size_t>
    source_of(const std::size_t body) const
    {
      return origins[body].source;
    }

    /** All that changes of free bodies. */
    std::vector<double>
    record() const;

    /** Takes what record() gave, or nothing if it is empty. */
    void
    restore(const std::vector<double> &record);

  private:
    /** MovedBody without the body. */
    struct Origin
    {
      TimeFunction<Pose<dim>> script;
      typename MovedBody<dim>::Frame frame;
      std::optional<std::size_t> source;
    };

    std::vector<RigidBody<dim>> bodies;
    std::vector<Origin> origins; ///< by body
  };
} // namespace magmpm
