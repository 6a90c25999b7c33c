#pragma once

#include <magmpm/boundary/rigid_body_parameters.h>
#include <magmpm/magnets/source_parameters.h>
#include <magmpm/parameters/motion_input.h>
#include <magmpm/parameters/parameter_register.h>

#include <string>

namespace magmpm
{
  template <int dim>
  struct KindOfSource;

  /** A magnet as the user gives it, whatever its kind; what is empty is not given. */
  template <int dim>
  struct MagnetInput
  {
    const KindOfSource<dim> *kind = nullptr;

    /** Expressions. */
    std::string field, magnetization, remanence, moment, current, strength;

    Vector<dim> size;
    double radius = 0., length = 0., conductor_radius = 0.;
    Vector<dim> axis;
    std::string file;
    double scale = 1.;

    MotionInput motion;
    RigidBodyProperties<dim> body;
  };

  /** What is given of a magnet, and where, so that a message about an expression names its line. */
  template <int dim>
  struct GivenMagnet
  {
    const ParameterRegister &declarations;
    const std::string section; ///< "Magnets/ball"
    const MagnetInput<dim> &input;

    bool
    has(const std::string &name) const
    {
      return declarations.given(section + "/" + name);
    }

    TimeFunction<Vector<dim>>
    vector(const std::string &name, const std::string &text) const;

    TimeFunction<double>
    scalar(const std::string &name, const std::string &text) const;

    /** [m] */
    TimeFunction<Vector<dim>>
    position() const;

    /** Axis times angle [rad]. */
    TimeFunction<Vector<n_axial_components<dim>>>
    rotation() const;

    /** By Magnetization or Remanence [A/m]. */
    TimeFunction<Vector<dim>>
    magnetization() const;

    /**
     * Where the source is at the start and how it moves, into @p source, whose kind is known.
     *
     * @throw InputError  if that is not given, or in two ways.
     */
    void
    read_motion(SourceParameters<dim> &source) const;
  };
} // namespace magmpm
