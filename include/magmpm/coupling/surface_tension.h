#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/coupling/clock.h>
#include <magmpm/coupling/coupling.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/surface_content.h>
#include <magmpm/surface/surface_force.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * Surface tension of fluids: the force of SurfaceForce goes straight to the momentum of the lattice in every
   * step. (Particles that carried it would lay it half a dx too deep, and one that is n steps old feeds the
   * waves.) What falls on nodes that hold next to nothing goes to the next ones inward. A scene without it
   * pays nothing.
   *
   * Where a solid touches such a fluid material goes on, and only what is free has tension: the surface meets
   * it at 90 degrees. Walls and rigid bodies are mirrors, with a contact angle of their own.
   */
  template <int dim>
  class SurfaceTension : public Coupling
  {
  public:
    SurfaceTension(const Lattice<dim> &lattice, const WallParameters<dim> &walls);

    /**
     * Adds the impulse of a step. Collective.
     *
     * @param momentum  {momentum [kg m/s], mass [kg]} on owned nodes, after P2G.
     */
    void
    act(const Clock &clock,
        const BlockPartition<dim> &partition,
        const std::vector<RigidBody<dim>> &rigid_bodies,
        std::vector<Body<dim>> &bodies,
        NodeField<dim> &momentum);

    void
    limit_step(StepConditions &conditions) const override;

    void
    reduce(parallel::Reduction &reduction) override;

    /** @throw RunError  if fluids of different tension touch. */
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
    /** What a row of the statistics tells. */
    struct Record
    {
      double energy = 0.;            ///< of all surfaces [J]; in 2D per metre of depth
      Vector<dim> dropped;           ///< force that reached no material [N]
      double capillary_rate = 0.;    ///< sqrt(gamma/(rho dx^3)), the largest [1/s]
      bool touches          = false; ///< fluids of different tension do

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &energy;
        archive &dropped;
        archive &capillary_rate;
        archive &touches;
      }
    };

    /** What bodies have in common. */
    void
    look_at(const std::vector<Body<dim>> &bodies);

    /** Volumes on nodes where all is one fluid: what P2G has just summed up tells them. Ghosts up to date. */
    NodeField<dim, SurfaceContent>
    content_of_mass(const BlockPartition<dim> &partition, const NodeField<dim> &momentum) const;

    /** The same of several bodies. */
    NodeField<dim, SurfaceContent>
    content_of_bodies(const BlockPartition<dim> &partition, std::vector<Body<dim>> &bodies) const;

    /** Gives nodes in rigid bodies the images of what is in front of them. */
    void
    mirror_at_bodies(const BlockPartition<dim> &partition,
                     const std::vector<RigidBody<dim>> &rigid_bodies,
                     SurfaceFields<dim> &fields) const;

    /** Masses of nodes that can take a force, with those behind walls in front, ghosts up to date. */
    NodeField<dim, SingleScalar>
    taking_masses(const BlockPartition<dim> &partition, const NodeField<dim> &momentum) const;

    /** Whether fluids of different tension share a node. */
    bool
    fluids_touch(const BlockSet<dim> &blocks, const NodeField<dim, SurfaceContent> &content) const;

    const Lattice<dim> lattice;
    const WettedWalls<dim> walls;
    SurfaceForce<dim> surface;

    std::vector<double> tensions;   ///< of fluids, each once [N/m]
    std::string fluids;             ///< their bodies with their tensions, for a message
    double largest_tension = 0.;    ///< [N/m]
    double largest_density = 0.;    ///< of fluids with tension [kg/m^3]
    bool is_one_fluid      = false; ///< all bodies: one density, one tension
    Record record;
  };
} // namespace magmpm
