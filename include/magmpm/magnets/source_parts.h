#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/magnets/source_field.h>
#include <magmpm/motion/time_function.h>

#include <memory>
#include <string>

namespace magmpm
{
  /** What the space that a kind of source fills means for material. */
  enum class Interior
  {
    open,         ///< nothing
    may_be_solid, ///< nothing, or no material can be there: as the user says
    refuses       ///< material that comes there ends the run
  };

  /** What a source that has a place is made of: each kind's make_parts(). */
  template <int dim>
  struct SourceParts
  {
    std::unique_ptr<SourceField<dim>> field;

    /** Magnetization [A/m], moment [A m^2] or, in the first component, current [A]; in its frame. */
    TimeFunction<Vector<dim>> amplitude;

    std::unique_ptr<Shape<dim>> shape; ///< the space that it fills, in its frame; null: none
    Vector<dim> axis;                  ///< direction of the field's axis, of any length; zero: z
    bool is_current = false; ///< whether the amplitude is a current, which has no direction
  };

  /** The amplitude of what has a current [A]. */
  template <int dim>
  TimeFunction<Vector<dim>>
  current_amplitude(const TimeFunction<double> &current);

  /**
   * @param what        "radius of the current loop".
   * @throw InputError  if @p length [m] is not finite and greater than 0; names the source.
   */
  void
  check_positive(const double length, const std::string &what, const std::string &source);
} // namespace magmpm
