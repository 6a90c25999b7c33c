#pragma once

#include <magmpm/magnets/magnetic_source.h>
#include <magmpm/magnets/source_parts.h>
#include <magmpm/motion/time_function.h>

namespace magmpm
{
  /** Of a uniform field. */
  template <int dim>
  struct UniformFieldParameters
  {
    static constexpr Interior interior = Interior::open;

    TimeFunction<Vector<dim>> field; ///< H [A/m]
  };

  /** A field H(t) that is the same everywhere, as between large pole pieces. */
  template <int dim>
  class UniformField : public MagneticSource<dim>
  {
  public:
    UniformField(const std::string &name, const UniformFieldParameters<dim> &parameters);

    void
    set_time(const double time) override;

    Vector<dim>
    field(const Vector<dim> &point) const override;

    Matrix<dim>
    field_gradient(const Vector<dim> &point) const override;

    bool
    is_constant() const override;

    /** H [A/m]. */
    Vector<dim>
    strength() const override;

    bool
    has_place() const override
    {
      return false;
    }

    /** The origin: a uniform field has no place. */
    const Pose<dim> &
    pose() const override;

    /** @throw RunError  always. */
    void
    set_pose(const Pose<dim> &pose) override;

  private:
    TimeFunction<Vector<dim>> field_in_time;
    Vector<dim> current_field; ///< H [A/m]
    const Pose<dim> origin;
  };
} // namespace magmpm
