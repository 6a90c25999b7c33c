#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/magnets/source_field.h>
#include <magmpm/motion/pose.h>

#include <optional>
#include <string>
#include <utility>

namespace magmpm
{
  /**
   * Something that makes a known magnetic field: a magnet, a coil, a field from far away. Outside
   * of its own magnetized volume the field has no divergence and no curl.
   *
   * In 2D everything is infinite along z. Field and gradient are those at the time last set.
   */
  template <int dim>
  class MagneticSource
  {
  public:
    explicit MagneticSource(std::string name)
      : source_name(std::move(name))
    {
    }

    virtual ~MagneticSource() = default;

    /** Moves the source to where it is at @p time >= 0 [s], and gives it its strength then. */
    virtual void
    set_time(const double time) = 0;

    /** H [A/m] at @p point [m]. */
    virtual Vector<dim>
    field(const Vector<dim> &point) const = 0;

    /**
     * G(i,j) = dH_i/dx_j [A/m^2] at @p point [m]; symmetric and free of trace outside the source.
     */
    virtual Matrix<dim>
    field_gradient(const Vector<dim> &point) const = 0;

    /** The magnetization M [A/m] at @p point [m]: with H, B = mu_0 (H + M). */
    virtual Vector<dim>
    magnetization(const Vector<dim> & /*point*/) const
    {
      return {};
    }

    /** Whether the field never changes in time. */
    virtual bool
    is_constant() const = 0;

    /**
     * The amplitude of the source as a vector, whose length is about the largest field that it makes
     * outside of itself [A/m]. Field and gradient are proportional to it.
     */
    virtual Vector<dim>
    strength() const = 0;

    /** Whether no rotation about strength() changes the field. */
    virtual bool
    is_axisymmetric() const
    {
      return true;
    }

    /** The farthest point of the source from its position, where a rotation moves it [m]. */
    virtual double
    reach() const
    {
      return 0.;
    }

    /** Whether it is somewhere; otherwise nothing acts on it. */
    virtual bool
    has_place() const
    {
      return true;
    }

    /** Where the source is; at rest in the origin if it has no place. */
    virtual const Pose<dim> &
    pose() const = 0;

    /**
     * Puts a source somewhere from outside (a free magnet, which forces move). From then on set_time()
     * leaves its pose alone, and is_constant() is false unless it has no strength for ever. What has no
     * place cannot be put anywhere.
     */
    virtual void
    set_pose(const Pose<dim> &pose) = 0;

    /** Another number than before whenever strength or pose have changed. */
    unsigned long
    revision() const
    {
      return n_changes;
    }

    /** The space that the source fills, in the frame of pose(); null: none. */
    virtual const Shape<dim> *
    shape() const
    {
      return nullptr;
    }

    /** Whether no material can be inside of shape(), since it meets a surface. */
    virtual bool
    is_solid() const
    {
      return false;
    }

    /** Whether material must not be inside of shape(), though it does not meet a surface there. */
    virtual bool
    refuses_material() const
    {
      return false;
    }

    /**
     * What another field does to this source; none if it has no place, or no end (in 3D). The acting
     * field must not contain the source's own.
     */
    virtual std::optional<ForceAndTorque<dim>>
    force_and_torque(const ActingField<dim> & /*acting*/) const
    {
      return {};
    }

    const std::string &
    name() const
    {
      return source_name;
    }

  protected:
    /** To be called when strength or pose have become others. */
    void
    note_change()
    {
      ++n_changes;
    }

  private:
    std::string source_name;
    unsigned long n_changes = 0;
  };
} // namespace magmpm
