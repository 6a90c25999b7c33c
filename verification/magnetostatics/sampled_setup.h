#pragma once

#include <magmpm/lattice/node_window.h>
#include <magmpm/parallel/reduce.h>

#include <verification/magnetostatics/magnetic_setup.h>

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace magmpm::verification
{
  /** A body of one material, given by its points. */
  template <int dim>
  struct SampledBody
  {
    std::function<bool(const Vector<dim> &)> contains;
    Vector<dim> lower, upper; ///< of a box around it [m]
    MagneticContent material;
  };

  template <int dim>
  SampledBody<dim>
  sphere(const Vector<dim> &centre, const double radius, const MagneticContent &material);

  template <int dim>
  SampledBody<dim>
  box(const Vector<dim> &lower, const Vector<dim> &upper, const MagneticContent &material);

  /** A particle: its volume counts, whatever its distance to others. */
  template <int dim>
  struct Sample
  {
    Vector<dim> position; ///< [m]
    double volume;        ///< over that of a lattice cell [-]
    MagneticContent material;
  };

  /**
   * Bodies on a mesh without particles: node fields as P2G would make them of very many particles,
   * by sampling the bodies on a regular grid of points.
   */
  template <int dim>
  class SampledSetup : public MagneticSetup<dim>
  {
  public:
    using MagneticSetup<dim>::lattice;
    using MagneticSetup<dim>::mesh;
    using MagneticSetup<dim>::partition;
    using MagneticSetup<dim>::problem;

    /**
     * @param n_cells    lattice cells along an edge of the mechanical box; its corner is the origin.
     * @param factor     of the potential box.
     * @param cell_edge  of the potential's cells, in dx.
     */
    SampledSetup(const int n_cells,
                 const double spacing,
                 const double factor,
                 const MagneticsParameters<dim> &magnetics,
                 const std::array<bool, 2 *dim> &shielded = {},
                 const int cell_edge                      = 2);

    /** Puts bodies in place of those before; mesh, partition and node fields follow. Collective. */
    void
    set_bodies(const std::vector<SampledBody<dim>> &bodies, const int samples_per_cell_edge = 5);

    /** The same with single particles. Collective; all ranks give the same. */
    void
    set_particles(const std::vector<Sample<dim>> &particles);

    NodeField<dim, NodeContent> content; ///< grains are 1 in the material
    NodeField<dim, SingleScalar> mass;   ///< v dx^dim, as of density 1

    /** Sum over the nodes of all ranks of weight(position) times the scalar or vector of @p field. */
    template <typename Single>
    auto
    sum(
      const NodeField<dim, Single> &field,
      const std::function<double(const Vector<dim> &)> &weight = [](const auto &) {
        return 1.;
      }) const
    {
      decltype(field.get(Single::value, 0, 0)) result = {};
      for_owned_nodes([&](const int slot, const int node, const Vector<dim> &position) {
        result += weight(position) * field.get(Single::value, slot, node);
      });
      return parallel::sum(result, MPI_COMM_WORLD);
    }

    /** action(slot, node, position) of the nodes of this rank. */
    template <typename Action>
    void
    for_owned_nodes(const Action &action) const
    {
      const BlockSet<dim> &blocks = partition.blocks();
      for_nodes(blocks, [&](const int slot, const int node) {
        action(slot, node, lattice.node_position(node_of_block<dim>(blocks.block(slot), node)));
      });
    }

  private:
    /** Blocks with samples and the samples in each. */
    struct SortedSamples
    {
      std::vector<Index<dim>> blocks;
      std::unordered_map<std::uint64_t, std::vector<Sample<dim>>> of_block;

      void
      add(const Lattice<dim> &lattice, const Sample<dim> &sample);
    };

    SortedSamples
    sample(const std::vector<SampledBody<dim>> &bodies, const int per_edge) const;

    void
    set_samples(const SortedSamples &samples);

    void
    scatter(const Sample<dim> &sample);
  };

  /** What the magnetic force does to the nodes of all ranks. */
  template <int dim>
  struct Force
  {
    Vector<dim> total, dropped;
    double absolute = 0.; ///< sum over the nodes of |f_i|

    Vector<n_axial_components<dim>> torque; ///< about a centre
  };

  template <int dim>
  Force<dim>
  force_on_nodes(const SampledSetup<dim> &setup, const Vector<dim> &centre);
} // namespace magmpm::verification
