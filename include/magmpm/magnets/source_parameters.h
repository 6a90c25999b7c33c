#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/motion/key_frames.h>

#include <string>

namespace magmpm
{
  enum class SourceType
  {
    uniform_field,
    point_dipole,      ///< in 2D: a line dipole
    magnetized_sphere, ///< in 2D: a cylinder magnetized across its axis
    cuboid,            ///< in 2D: a rectangle, infinite along z
    cylinder,          ///< 3D only
    current_loop,      ///< 3D only
    straight_wire,     ///< in 2D: along z
    magnetized_mesh    ///< 3D only
  };

  /** What a solid magnet does to material at its surface. */
  enum class ContactCondition
  {
    none, ///< the source has no surface
    stick,
    slip,
    separate
  };

  /**
   * One named source of the external field. What changes in time is given as expressions of t [s] (one
   * per component, constants included), read by read_expression(), or, but for the field and what
   * magnetizes, as key frames. What is empty is not given.
   *
   * Magnetization, remanence and moment are those in the source's own frame, of which exactly one is
   * given; so is its axis.
   */
  template <int dim>
  struct SourceParameters
  {
    std::string name;
    SourceType type = SourceType::uniform_field;

    std::string field;         ///< uniform field H(t) [A/m], "0; 0; 1e5*t"
    std::string magnetization; ///< M(t) [A/m]
    std::string remanence;     ///< B_r(t) = mu_0 M [T]
    std::string moment;        ///< of a point dipole m(t) [A m^2], in 2D per metre [A m]
    std::string current;       ///< of a loop or wire I(t) [A]

    std::string position;   ///< x(t) [m], "0.5; 0.5; 0.2"
    std::string rotation;   ///< axis times angle (t) [rad]; in 2D the angle; not given: none
    std::string strength;   ///< factor (t) of magnetization, moment or current; not given: 1
    std::string key_frames; ///< a CSV file, or the table itself (KeyFrames), instead of these three
    KeyFrameInterpolation interpolation = KeyFrameInterpolation::linear;

    Vector<dim> size;             ///< edges of a cuboid [m]
    double radius           = 0.; ///< of a sphere, cylinder, loop; of a dipole's core [m]
    double length           = 0.; ///< of a cylinder; of a wire, 0: infinite [m]
    double conductor_radius = 0.; ///< of a loop or wire [m]
    Vector<dim> axis;             ///< of a cylinder, loop, wire (3D): any length; zero: along z
    std::string file;             ///< of a mesh: STL, OBJ or PLY
    double scale = 1.;            ///< of the lengths in the file

    ContactCondition contact = ContactCondition::none;
    double friction          = 0.; ///< Coulomb's coefficient, with contact slip or separate

    bool is_free = false; ///< whether forces move it: from where and how it is turned at time zero
    double density = 0.;  ///< of a free one [kg/m^3]; 0: its mass is given
    double mass    = 0.;  ///< of a free one [kg], in 2D [kg/m]
    Vector<dim> velocity; ///< of a free one at the start [m/s]
    Vector<n_axial_components<dim>> angular_velocity; ///< of a free one at the start [rad/s]
  };
} // namespace magmpm
