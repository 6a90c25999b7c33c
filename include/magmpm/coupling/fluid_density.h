#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/coupling/clock.h>
#include <magmpm/coupling/coupling.h>
#include <magmpm/coupling/density_relaxation.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/box_faces.h>

#include <vector>

namespace magmpm
{
  /**
   * Mends the density of fluids and takes the noise out of J every few steps, see density_relaxation.h. A
   * scene without fluids pays nothing.
   */
  template <int dim>
  class FluidDensity : public Coupling
  {
  public:
    /** @param open  faces of the box that are no walls. */
    FluidDensity(const Lattice<dim> &lattice, const OpenFaces<dim> &open);

    /** @param rigid_bodies  where they are now. Collective. */
    void
    relax(const Clock &clock,
          const BlockPartition<dim> &partition,
          const std::vector<RigidBody<dim>> &rigid_bodies,
          std::vector<Body<dim>> &bodies);

    void
    reduce(parallel::Reduction &reduction) override;

    void
    take_reduced() override;

    void
    add_columns(ColumnTable &table) const override;

    SectionTitle
    title() const override;

    std::string
    save() const override;

    void
    load(const std::string &bytes) override;

  private:
    /** The claims on nodes, by bulk modulus, ghosts up to date. */
    std::vector<NodeField<dim, NodeClaims>>
    sum_claims(const std::vector<double> &moduli,
               const BlockPartition<dim> &partition,
               std::vector<Body<dim>> &bodies) const;

    /** psi on nodes, ghosts up to date. */
    NodeField<dim, SingleScalar>
    sum_fractions(const std::vector<NodeField<dim, NodeClaims>> &claims,
                  const BlockPartition<dim> &partition,
                  const std::vector<RigidBody<dim>> &rigid_bodies) const;

    /** Takes the noise out of J. */
    void
    smooth(const double bulk_modulus,
           const NodeField<dim, NodeClaims> &claims,
           const Residuals &residuals,
           const BlockPartition<dim> &partition,
           std::vector<Body<dim>> &bodies) const;

    const Lattice<dim> lattice;
    const MirrorWalls<dim> walls;
    bool relaxed_this_step = false;
    DensityError found; ///< by the last relaxation

    /** Mean of |psi - 1| before it, over particles that are not next to a free surface. */
    double mean_error = 0.;
  };
} // namespace magmpm
