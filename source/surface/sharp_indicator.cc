#include <magmpm/mesh/mirror_images.h>
#include <magmpm/mesh/node_filters.h>
#include <magmpm/surface/sharp_indicator.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr double smallest_full      = 1e-3;
    constexpr double transition         = 0.8; ///< in v/w
    constexpr double lowest_correction  = 0.5;
    constexpr double highest_correction = 5.;
    constexpr int n_smoothing_passes    = 3;

    /** Nodes that hold less than this of their cell get no correction: f falls off faster than v. */
    constexpr double negligible_volume = 1e-9;

    /** A clipped correction counts where a node holds more than this of its cell. */
    constexpr double counted_volume = 1e-3;

    template <int dim, typename Action>
    void
    for_nodes(NodeField<dim> &field, const int n_blocks, const Action &action)
    {
      for (int slot = 0; slot < n_blocks; ++slot)
        for (int node = 0; node < nodes_per_block<dim>; ++node)
          action(field.node(slot, node), slot, node);
    }
  } // namespace

  template <int dim>
  void
  SharpIndicator<dim>::reinit(const BlockPartition<dim> &partition,
                              const Lattice<dim> &lattice,
                              const std::array<bool, 2 * dim> &shielded,
                              const NodeField<dim> &content)
  {
    const int n_blocks = partition.blocks().size();
    nodes.reinit(n_blocks);
    for_nodes(nodes, n_blocks, [&](double *lanes, const int slot, const int node) {
      lanes[volume] = content.node(slot, node)[0];
    });
    remove_smear(partition, nodes);
    copy_mirror_images(partition, lattice, shielded, nodes);

    // Twice over 3^dim nodes is once over 5^dim.
    NodeField<dim> largest(nodes);
    for (int pass = 0; pass < 2; ++pass)
      {
        maximize(partition, largest);
        copy_mirror_images(partition, lattice, shielded, largest);
      }

    clipped_fractions = 0;
    for_nodes(nodes, n_blocks, [&](double *lanes, const int slot, const int node) {
      const double around = largest.node(slot, node)[volume];
      lanes[full]         = std::clamp(around, smallest_full, 1.);
      lanes[correction]   = 1.;
      clipped_fractions += slot < partition.blocks().n_owned() && around < smallest_full &&
                           content.node(slot, node)[0] > 0.;
    });
  }

  template <int dim>
  void
  SharpIndicator<dim>::set_correction(const BlockPartition<dim> &partition,
                                      const Lattice<dim> &lattice,
                                      const std::array<bool, 2 * dim> &shielded,
                                      const NodeField<dim> &content,
                                      NodeField<dim> &tested_fraction)
  {
    const int n_blocks = partition.blocks().size();
    partition.add_ghosts_to_owners(tested_fraction);
    partition.update_ghosts(tested_fraction);
    add_mirror_images(partition, lattice, shielded, tested_fraction);

    // Smoothed together: lane 0 is W, lane 1 is A; then lane 0 is their ratio less 1.
    const auto smooth_passes = [&](NodeField<dim> &field) {
      for (int pass = 0; pass < n_smoothing_passes; ++pass)
        {
          smooth(partition, field);
          copy_mirror_images(partition, lattice, shielded, field);
        }
    };
    for_nodes(tested_fraction, n_blocks, [&](double *lanes, const int slot, const int node) {
      lanes[1] = content.node(slot, node)[0];
    });
    smooth_passes(tested_fraction);

    clipped_corrections = 0;
    for_nodes(tested_fraction, n_blocks, [&](double *lanes, const int slot, const int) {
      const bool has_volume = lanes[0] > negligible_volume;
      const double ratio    = has_volume ? lanes[1] / lanes[0] : 1.;
      lanes[0]              = std::clamp(ratio, lowest_correction, highest_correction);
      clipped_corrections += slot < partition.blocks().n_owned() && lanes[1] > counted_volume &&
                             ratio != lanes[0];
      lanes[1] = 0.;
    });
    smooth_passes(tested_fraction);
    for_nodes(nodes, n_blocks, [&](double *lanes, const int slot, const int node) {
      lanes[correction] = tested_fraction.node(slot, node)[0];
    });
  }

  template <int dim>
  double
  SharpIndicator<dim>::fraction(const double volume, const double full)
  {
    if (!(volume > 0.))
      return 0.;
    const double w = std::max(full, smallest_full); // nodes that are not active count as zero
    const double t = std::clamp(0.5 + (volume / w - 0.5) / transition, 0., 1.);
    return w * t * t * (3. - 2. * t);
  }

  template class SharpIndicator<2>;
  template class SharpIndicator<3>;
} // namespace magmpm
