#pragma once

#include <magmpm/magnets/cuboid.h>
#include <magmpm/magnets/current_loop.h>
#include <magmpm/magnets/cylinder.h>
#include <magmpm/magnets/magnetized_mesh.h>
#include <magmpm/magnets/magnetized_sphere.h>
#include <magmpm/magnets/point_dipole.h>
#include <magmpm/magnets/straight_wire.h>
#include <magmpm/magnets/uniform_field.h>
#include <magmpm/motion/pose.h>
#include <magmpm/motion/time_function.h>

#include <string>
#include <type_traits>
#include <variant>

namespace magmpm
{
  namespace internal
  {
    template <int dim, typename... OnlyIn3D>
    using KindsOfSource = std::variant<UniformFieldParameters<dim>,
                                       PointDipoleParameters<dim>,
                                       MagnetizedSphereParameters<dim>,
                                       CuboidParameters<dim>,
                                       StraightWireParameters<dim>,
                                       OnlyIn3D...>;
  }

  /**
   * The parameters of one kind of source. A new kind is a pair of files with its parameters, its field
   * and make_parts(), a line here, and one in the table of parameters/source_kinds.cc.
   */
  template <int dim>
  using SourceKind = std::conditional_t<
    dim == 3,
    internal::
      KindsOfSource<dim, CylinderParameters, CurrentLoopParameters, MagnetizedMeshParameters>,
    internal::KindsOfSource<dim>>;

  template <int dim>
  inline Interior
  interior_of(const SourceKind<dim> &kind)
  {
    return std::visit([](const auto &parameters) { return parameters.interior; }, kind);
  }

  /** One named source of the external field. */
  template <int dim>
  struct SourceParameters
  {
    std::string name;
    SourceKind<dim> kind;

    TimeFunction<Pose<dim>> pose;          ///< of its frame; a uniform field has none
    TimeFunction<double> strength = 1.;    ///< factor of magnetization, moment or current
    bool is_solid                 = false; ///< whether no material can be inside of it

    /** Whether it is somewhere. */
    bool
    has_place() const
    {
      return !std::holds_alternative<UniformFieldParameters<dim>>(kind);
    }
  };
} // namespace magmpm
