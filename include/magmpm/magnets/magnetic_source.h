#pragma once

#include <magmpm/base/tensor.h>

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

    /** Whether the field never changes in time. */
    virtual bool
    is_constant() const = 0;

    /**
     * The amplitude of the source as a vector, whose length is the largest field that it makes
     * outside of itself [A/m]. Field and gradient are proportional to it.
     */
    virtual Vector<dim>
    strength() const = 0;

    /** The point that moves with the source [m]; any fixed point if it has no place. */
    virtual Vector<dim>
    centre() const = 0;

    const std::string &
    name() const
    {
      return source_name;
    }

  private:
    std::string source_name;
  };
} // namespace magmpm
