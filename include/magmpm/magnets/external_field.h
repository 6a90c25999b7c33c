#pragma once

#include <magmpm/magnets/magnetic_source.h>
#include <magmpm/magnets/source_parameters.h>

#include <memory>
#include <vector>

namespace magmpm
{
  /** What of a source ExternalField::change_since_remembered() compares. */
  template <int dim>
  struct SourceSnapshot
  {
    Vector<dim> strength; ///< [A/m]
    Pose<dim> pose;
  };

  /** H_ext, the sum of the fields of all sources of a scene. */
  template <int dim>
  class ExternalField
  {
  public:
    /**
     * The sources as they are at time zero.
     *
     * @throw InputError  names the source, what is wrong with it, and what is allowed.
     */
    explicit ExternalField(const std::vector<SourceParameters<dim>> &parameters);

    /** Moves all sources to where they are at @p time >= 0 [s]. */
    void
    set_time(const double time);

    /** Puts a source somewhere from outside, see MagneticSource::set_pose(). @param source  its number. */
    void
    set_pose(const std::size_t source, const Pose<dim> &pose);

    /** H_ext [A/m] at @p point [m]. */
    Vector<dim>
    field(const Vector<dim> &point) const;

    /** G(i,j) = dH_i/dx_j [A/m^2] of H_ext at @p point [m]. */
    Matrix<dim>
    field_gradient(const Vector<dim> &point) const;

    /** The magnetization of the magnets [A/m] at @p point [m]. */
    Vector<dim>
    magnetization(const Vector<dim> &point) const;

    /** Whether a solid source is at @p point [m]: no material can be there. */
    bool
    is_solid(const Vector<dim> &point) const;

    /**
     * For points where material is.
     *
     * @throw RunError  if @p point [m] is inside of a source that refuses material, the core of a point
     *                  dipole.
     */
    void
    check_material_at(const Vector<dim> &point) const;

    /**
     * What all the other sources do to @p source, one of sources(), by its
     * MagneticSource::force_and_torque(); none if that gives none.
     */
    std::optional<ForceAndTorque<dim>>
    force_and_torque(const MagneticSource<dim> &source) const;

    /** Whether there is no field at any time: no source, or all of them constant and zero. */
    bool
    is_absent() const;

    /** Whether the field never changes in time. */
    bool
    is_constant() const;

    /** How much the sources changed. */
    struct Change
    {
      /**
       * The largest |S - S'|/max(|S|, |S'|) of a source, S and S' its strength() now and then; of a
       * source that is not symmetric about it, no less than 2 sin(a/2), a the angle that it turned by.
       */
      double relative_strength;
      /** The largest way that a point of a source moved, as the crow flies, or more [m]. */
      double displacement;
    };

    /** Keeps the present state of the sources for change_since_remembered(). */
    void
    remember();

    /** What remember() kept, by source; of an earlier run, if @p snapshots come from a checkpoint. */
    const std::vector<SourceSnapshot<dim>> &
    remembered() const
    {
      return kept;
    }

    void
    remember(const std::vector<SourceSnapshot<dim>> &snapshots);

    /** Zeros if nothing changed; infinite as long as nothing was remembered. */
    Change
    change_since_remembered() const;

    /** All sources, in the order of their parameters; owned by this, which alone moves them. */
    const std::vector<const MagneticSource<dim> *> &
    sources() const
    {
      return views;
    }

    /** The sources that no material can be inside of; owned by this. */
    const std::vector<const MagneticSource<dim> *> &
    solid_sources() const
    {
      return solids;
    }

  private:
    std::vector<std::unique_ptr<MagneticSource<dim>>> all_sources;
    std::vector<const MagneticSource<dim> *> views; ///< of all_sources
    std::vector<const MagneticSource<dim> *> solids;
    std::vector<const MagneticSource<dim> *> refusing; ///< those that refuse material
    std::vector<SourceSnapshot<dim>> kept;
    bool has_remembered = false;
  };
} // namespace magmpm
