#pragma once

#include <magmpm/magnets/source_parts.h>

namespace magmpm
{
  /** Of a cuboid; in 2D a rectangle, infinite along z. */
  template <int dim>
  struct CuboidParameters
  {
    static constexpr Interior interior = Interior::may_be_solid;

    TimeFunction<Vector<dim>> magnetization; ///< in its own frame [A/m]
    Vector<dim> size;                        ///< edges [m]
  };

  /**
   * A cuboid with edges along the axes and uniform magnetization M of any direction; in 2D a rectangle,
   * infinite along z. Its faces carry the charge M.n. With u = (x + a, x - a) and so on for v and w,
   * the products of signs s of the eight corners and R their distances (Joseph and Schlömann, J. Appl.
   * Phys. 36, 1579 (1965)),
   *   H = -N M,  N_xx = 1/(4 pi) sum s atan(v w/(u R)),  N_xy = -1/(4 pi) sum s ln(w + R),
   * summed such that nothing cancels near the edges and their extensions; the gradient is their
   * derivative. The error is some 1e-15 of M from rounding, which far away is (r/a)^3 of H.
   *
   * The surface belongs to the outside: within 1e-9 of the longest edge from a face the field is that
   * just outside of it; H.n jumps there by M.n. At an edge H grows like the logarithm of the distance
   * and its gradient like the inverse; the distance is never taken as less than 1e-4 of the shortest
   * edge, so both are finite everywhere.
   */
  template <int dim>
  class Cuboid : public SourceField<dim>
  {
  public:
    /** @param size  edges, all greater than 0 [m]. */
    explicit Cuboid(const Vector<dim> &size);

    Vector<dim>
    field(const Vector<dim> &magnetization, const Vector<dim> &point) const override;

    Matrix<dim>
    field_gradient(const Vector<dim> &magnetization, const Vector<dim> &point) const override;

    bool
    is_inside(const Vector<dim> &point) const override;

    /** M, which the field comes near to at a face [A/m]. */
    Vector<dim>
    strength(const Vector<dim> &magnetization) const override;

    bool
    is_axisymmetric(const Vector<dim> &magnetization) const override;

    double
    reach() const override;

    /** By 5 Gauss points along each edge. */
    std::optional<ForceAndTorque<dim>>
    force_and_torque(const Vector<dim> &magnetization,
                     const ActingField<dim> &acting) const override;

  private:
    const Vector<dim> half_size;
    const double surface_tolerance;    ///< [m]
    const double least_edge_distance2; ///< square of the least distance from an edge [m^2]
    std::vector<VolumeElement<dim>> elements;
  };

  /** @throw InputError  if a length is not positive; names the source. */
  template <int dim>
  SourceParts<dim>
  make_parts(const CuboidParameters<dim> &parameters, const std::string &name);
} // namespace magmpm
