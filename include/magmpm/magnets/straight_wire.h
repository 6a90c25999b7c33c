#pragma once

#include <magmpm/magnets/current_element.h>
#include <magmpm/magnets/source_parts.h>

namespace magmpm
{
  /** Of a straight wire; in 2D along z. */
  template <int dim>
  struct StraightWireParameters
  {
    static constexpr Interior interior = Interior::open;

    TimeFunction<double> current; ///< along its axis [A]
    double conductor_radius = 0.; ///< [m]
    double length           = 0.; ///< 0: without ends [m]; in 2D always
    Vector<dim> axis;             ///< in 3D: in its own frame, of any length; zero: along z
  };

  /**
   * A straight wire along z with the current I in that direction; in 2D across the plane, towards the
   * viewer. At the distance rho from it,
   *   without ends:  H = I/(2 pi rho),
   *   of length L:   H = I/(4 pi rho) (z_0/R_0 - z_1/R_1),  z_0 = z + L/2, z_1 = z - L/2, R^2 = rho^2 + z^2,
   * round the wire by the right hand (Biot and Savart). A wire with ends is a piece of a circuit: the
   * curl of H vanishes only for all of a circuit together.
   *
   * The conductor is round, of radius a: where rho < a the field is that at a times rho/a, as of a
   * uniform current, and zero on the axis.
   */
  template <int dim>
  class StraightWire : public SourceField<dim>
  {
  public:
    /**
     * @param conductor_radius  greater than 0 [m].
     * @param length            0: without ends [m]; in 2D always.
     */
    explicit StraightWire(const double conductor_radius, const double length = 0.);

    /** @param current  [A], the first component. */
    Vector<dim>
    field(const Vector<dim> &current, const Vector<dim> &point) const override;

    Matrix<dim>
    field_gradient(const Vector<dim> &current, const Vector<dim> &point) const override;

    /** I/(2 pi a), the field at the surface of the conductor [A/m]; in 3D along the wire. */
    Vector<dim>
    strength(const Vector<dim> &current) const override;

    bool
    is_axisymmetric(const Vector<dim> &current) const override;

    double
    reach() const override;

    /** In 2D exact, F = mu_0 I e_z x H; in 3D by 64 pieces, none without ends. */
    std::optional<ForceAndTorque<dim>>
    force_and_torque(const Vector<dim> &current, const ActingField<dim> &acting) const override;

  private:
    /** H = I f (e_z x r), and the derivatives of f by rho, divided by rho, and by z. */
    struct Factor
    {
      double f;         ///< [1/m^2]
      double slope_rho; ///< [1/m^4]
      double slope_z;   ///< [1/m^3]
    };

    Factor
    factor(const Vector<dim> &point) const;

    const double conductor_radius, half_length;
    std::vector<CurrentElement> elements;
  };

  /** @throw InputError  if a length is not positive; names the source. */
  template <int dim>
  SourceParts<dim>
  make_parts(const StraightWireParameters<dim> &parameters, const std::string &name);
} // namespace magmpm
