#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /** Mass and inertia of a rigid body about its centre of mass; in 2D per metre of depth. */
  template <int dim>
  struct MassProperties
  {
    double mass = 0.; ///< [kg]

    /** Principal moments of inertia [kg m^2], all positive; in 2D the one across the plane. */
    Vector<n_axial_components<dim>> moments;

    /** Orthogonal, determinant 1: its columns are the principal axes, in the frame of the shape. */
    Matrix<dim> axes = identity<dim>();
  };

  /** Of a shape that @p mass [kg] fills evenly. @param volume  the moments of the shape. */
  template <int dim>
  MassProperties<dim>
  mass_properties(const VolumeMoments<dim> &volume, const double mass);
} // namespace magmpm
