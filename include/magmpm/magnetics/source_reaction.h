#pragma once

#include <magmpm/magnetics/material_sample.h>
#include <magmpm/magnets/external_field.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /**
   * What the material does to the sources of the external field, by Newton's third law, the couple of
   * M with their fields included:
   *   F_k = - int mu_0 (M.grad)H_k,   T_k = - int mu_0 [(x - x_k) x (M.grad)H_k + M x H_k],
   * x_k the position of source k, about which the torque is. The integrals are sums over the quadrature
   * points at which compute_split_force() has the opposite force on the material, so the forces on
   * material and sources add up to zero but for what the material does to itself. Collective.
   *
   * @param samples  of this rank.
   * @return in the order of the sources; zero for those without a place.
   */
  template <int dim>
  std::vector<ForceAndTorque<dim>>
  reactions_on_sources(const std::vector<MaterialSample<dim>> &samples,
                       const ExternalField<dim> &sources,
                       const MPI_Comm communicator);
} // namespace magmpm
