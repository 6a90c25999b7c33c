#pragma once

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
   * Draws the J of fluids towards that of the lattice every few steps, see density_relaxation.h. A scene
   * without fluids pays nothing.
   */
  template <int dim>
  class FluidDensity : public Coupling
  {
  public:
    /** @param open  faces of the box that are no walls. */
    FluidDensity(const Lattice<dim> &lattice, const OpenFaces<dim> &open);

    /** Collective. */
    void
    relax(const Clock &clock, const BlockPartition<dim> &partition, std::vector<Body<dim>> &bodies);

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
    const Lattice<dim> lattice;
    const OpenFaces<dim> open;
    bool relaxed_this_step = false;
    DensityError found; ///< by the last relaxation

    /** |J - J of the lattice| before it, of particles that are not next to a free surface. */
    double mean_error = 0.;
  };
} // namespace magmpm
