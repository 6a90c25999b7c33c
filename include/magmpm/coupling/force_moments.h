#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /** Sums over magnetic particles of the force that they carry: what of it must be right at all times. */
  template <int dim>
  struct ForceMoments
  {
    double mass = 0.;                ///< [kg]
    Vector<dim> mass_times_position; ///< [kg m]
    Vector<dim> force;               ///< [N]
    double size = 0.;                ///< sum of |f| [N]
    Matrix<dim> moment;              ///< sum of f x^T about the origin [J]

    /** About the centre of mass [J]; its skew part is half the torque. */
    Matrix<dim>
    virial() const;

    template <typename F>
    void
    for_each_number(F &&f)
    {
      f(mass);
      f(mass_times_position);
      f(force);
      f(size);
      f(moment);
    }
  };

  /** Of all bodies together, on all ranks. Collective. */
  template <int dim>
  ForceMoments<dim>
  force_moments(const std::vector<Body<dim>> &bodies,
                const Lattice<dim> &lattice,
                const MPI_Comm communicator);

  /**
   * How far @p carried is from @p exact: the larger one of the difference of the force over its size, or over a tenth of
   * the sum of the sizes where forces cancel, and of that of the virial, with the torque, over its norm.
   */
  template <int dim>
  double
  relative_difference(const ForceMoments<dim> &carried, const ForceMoments<dim> &exact);
} // namespace magmpm
