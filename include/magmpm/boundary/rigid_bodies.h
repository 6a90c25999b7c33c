#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/boundary/rigid_body_parameters.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/motion/pose_function.h>

#include <optional>
#include <string>
#include <vector>

namespace magmpm
{
  /**
   * All rigid bodies of a scene: the magnets that are solid or free, then those of the section 'Rigid
   * bodies'. A magnet that is not free goes where its source goes; a source that is free goes where
   * its body goes. The same on all ranks.
   */
  template <int dim>
  class RigidBodies
  {
  public:
    /**
     * The bodies at time zero.
     *
     * @param sources  made of @p source_parameters; must outlive this.
     * @throw InputError  if a motion cannot be read.
     */
    RigidBodies(const std::vector<SourceParameters<dim>> &source_parameters,
                const std::vector<RigidBodyParameters<dim>> &parameters,
                const ExternalField<dim> &sources);

    /**
     * Moves scripted bodies to where they are at @p time [s], and magnets and their sources to each
     * other. The sources must have been moved to that time.
     */
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

    /** The source that body number @p body is, by its place in ExternalField::sources(). */
    std::optional<std::size_t>
    source_of(const std::size_t body) const
    {
      return origins[body].source;
    }

    /** All that changes of free bodies. */
    std::vector<double>
    record() const;

    /** Takes what record() gave, or nothing if it is empty, and brings sources of free magnets there. */
    void
    restore(const std::vector<double> &record);

  private:
    /** What a body that is not free follows, or the source that follows it. */
    struct Origin
    {
      std::optional<std::size_t> source;
      std::optional<TimeFunction<Pose<dim>>> script;
    };

    void
    add_source(const SourceParameters<dim> &parameters, const std::size_t source);

    void
    add_body(const RigidBodyParameters<dim> &parameters);

    const ExternalField<dim> &sources;
    std::vector<RigidBody<dim>> bodies;
    std::vector<Origin> origins; ///< by body
  };

  /** The mass of a body that fills @p shape [kg]: as given, or of its density [kg/m^3]. */
  template <int dim>
  double
  mass_of(const Shape<dim> &shape, const double mass, const double density);
} // namespace magmpm
