#pragma once

#include <magmpm/base/tensor.h>

#include <functional>
#include <optional>
#include <vector>

namespace magmpm
{
  /** What acts on a magnet: the torque is about its position. In 2D per metre of depth. */
  template <int dim>
  struct ForceAndTorque
  {
    Vector<dim> force;                      ///< [N], in 2D [N/m]
    Vector<n_axial_components<dim>> torque; ///< [N m], in 2D [N]

    template <typename F>
    void
    for_each_number(F &&f)
    {
      f(force);
      f(torque);
    }
  };

  /** A field at a point: H [A/m] and G(i,j) = dH_i/dx_j [A/m^2]. */
  template <int dim>
  struct LocalField
  {
    Vector<dim> field;
    Matrix<dim> gradient;
  };

  /** The field that acts on a source, at any point [m]. */
  template <int dim>
  using ActingField = std::function<LocalField<dim>(const Vector<dim> &)>;

  /**
   * A part of a magnetized volume. Of a point dipole, which has no volume, the only one counts 1, and
   * its amplitude is the moment.
   */
  template <int dim>
  struct VolumeElement
  {
    Vector<dim> position; ///< [m]
    double volume;        ///< [m^3], in 2D [m^2]
  };

  /**
   * The field of a kind of source at rest in the origin: a pure function of the point, linear in an
   * amplitude, which is the magnetization [A/m], the moment of a dipole [A m^2], or, in the first
   * component, the current [A]. The axis of what has one is z. Everything is finite at every point; each
   * kind says by which convention.
   */
  template <int dim>
  class SourceField
  {
  public:
    virtual ~SourceField() = default;

    /** H [A/m] at @p point [m]. */
    virtual Vector<dim>
    field(const Vector<dim> &amplitude, const Vector<dim> &point) const = 0;

    /** G(i,j) = dH_i/dx_j [A/m^2] at @p point [m]. */
    virtual Matrix<dim>
    field_gradient(const Vector<dim> &amplitude, const Vector<dim> &point) const = 0;

    /** Whether the magnetized volume is at @p point [m]; its surface belongs to the outside. */
    virtual bool
    is_inside(const Vector<dim> & /*point*/) const
    {
      return false;
    }

    /** A vector that tells the size of the field nearby [A/m], proportional to the amplitude. */
    virtual Vector<dim>
    strength(const Vector<dim> &amplitude) const = 0;

    /** Whether no rotation about strength() changes the field. */
    virtual bool
    is_axisymmetric(const Vector<dim> &amplitude) const = 0;

    /**
     * The farthest point of the source from the origin [m], for how far a rotation moves it; zero for
     * a point, a sphere, and what has no end.
     */
    virtual double
    reach() const = 0;

    /** What @p acting does to the source; nothing if the source has no end, in 3D. */
    virtual std::optional<ForceAndTorque<dim>>
    force_and_torque(const Vector<dim> &amplitude, const ActingField<dim> &acting) const = 0;
  };

  /**
   * Force and torque on volume that is magnetized by @p magnetization [A/m]:
   *   F = sum mu_0 V (M.grad)H,   T = sum mu_0 V [x x (M.grad)H + M x H].
   */
  template <int dim>
  ForceAndTorque<dim>
  act_on(const std::vector<VolumeElement<dim>> &elements,
         const Vector<dim> &magnetization,
         const ActingField<dim> &acting);
} // namespace magmpm
