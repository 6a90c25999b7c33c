#pragma once

#include <magmpm/magnets/external_field.h>

namespace magmpm
{
  /**
   * The field of sources as material feels it. Outside of solid sources it is H, and G with G_ij =
   * dH_i/dx_j. Material that is pressed into the surface of one feels what goes on there from outside,
   *   H~(x) = sum_k w_k H(s_k(x)),  G~_ij = dH~_j/dx_i,
   * with the ways out s_k of the shape (Shape::ways_out()), and the force on it is mu_0 G~ M, which has the
   * energy psi(H~): a field that ended at the surface would work on what passes it, and one of which H~
   * jumped inside would give energy to what goes to and fro.
   *
   * G~ jumps at the surface. A point stands for a cube around it; where the surface cuts that, G~ is the
   * mean of its values in the centroids of what is outside and of what is inside, as 4^dim points tell
   * them, so that no point makes the force jump alone.
   */
  template <int dim>
  class ContinuedField
  {
  public:
    /** @param sources  must outlive this object. */
    explicit ContinuedField(const ExternalField<dim> &sources);

    /** Of all sources. @param edge  of the cube that the point stands for [m]. */
    LocalField<dim>
    at(const Vector<dim> &point, const double edge) const;

    /** Of one of them alone. */
    LocalField<dim>
    of(const MagneticSource<dim> &source, const Vector<dim> &point, const double edge) const;

  private:
    /** What solid source a point is in; null: none. */
    const MagneticSource<dim> *
    solid_around(const Vector<dim> &point) const;

    /** The places of which a point in a solid source has the mean; outside, the point itself. */
    std::vector<WayOut<dim>>
    places(const Vector<dim> &point) const;

    /** @param field  MagneticSource or ExternalField: what has field() and field_gradient(). */
    template <typename Field>
    LocalField<dim>
    local_field(const Field &field, const Vector<dim> &point, const double edge) const;

    template <typename Field>
    Vector<dim>
    mean_field(const Field &field, const Vector<dim> &point) const;

    /** G~, at the point alone. @param solid  the source around it, or null. */
    template <typename Field>
    Matrix<dim>
    gradient(const Field &field, const MagneticSource<dim> *solid, const Vector<dim> &point) const;

    const ExternalField<dim> &sources;
  };
} // namespace magmpm
