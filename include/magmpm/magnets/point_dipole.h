#pragma once

#include <magmpm/magnets/magnetized_sphere.h>
#include <magmpm/magnets/source_parts.h>

namespace magmpm
{
  /** Of a point dipole; in 2D a line dipole. */
  template <int dim>
  struct PointDipoleParameters
  {
    static constexpr Interior interior = Interior::refuses;

    TimeFunction<Vector<dim>> moment; ///< in its own frame [A m^2], in 2D per metre [A m]
    double radius = 0.;               ///< of its core [m]
  };

  /**
   * A dipole of moment m in a point; in 2D a line dipole of moment per length m. With r, n the distance
   * and direction from it (Jackson, Classical Electrodynamics, section 5.6),
   *   3D:  H = (3 (m.n) n - m)/(4 pi r^3),     2D:  H = (2 (m.n) n - m)/(2 pi r^2).
   * It has a core of radius c, in which no material can be. There the field is that inside of a sphere
   * (in 2D a cylinder) of radius c that has the moment m uniformly: finite, and without meaning.
   */
  template <int dim>
  class PointDipole : public SourceField<dim>
  {
  public:
    /** @param core_radius  greater than 0 [m]. */
    explicit PointDipole(const double core_radius);

    /** @param moment  [A m^2], in 2D [A m]. */
    Vector<dim>
    field(const Vector<dim> &moment, const Vector<dim> &point) const override;

    Matrix<dim>
    field_gradient(const Vector<dim> &moment, const Vector<dim> &point) const override;

    /** The field at a pole of the core [A/m]. */
    Vector<dim>
    strength(const Vector<dim> &moment) const override;

    bool
    is_axisymmetric(const Vector<dim> &moment) const override;

    double
    reach() const override;

    /** Exact: F = mu_0 (m.grad)H, T = mu_0 m x H. */
    std::optional<ForceAndTorque<dim>>
    force_and_torque(const Vector<dim> &moment, const ActingField<dim> &acting) const override;

  private:
    const MagnetizedSphere<dim> core;
    const double inverse_core_volume; ///< [1/m^3], in 2D [1/m^2]
  };

  /** @throw InputError  if a length is not positive; names the source. */
  template <int dim>
  SourceParts<dim>
  make_parts(const PointDipoleParameters<dim> &parameters, const std::string &name);
} // namespace magmpm
