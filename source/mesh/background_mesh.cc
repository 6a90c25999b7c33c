#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <magmpm/lattice/block_set.h>
#include <magmpm/mesh/background_mesh.h>
#include <magmpm/mesh/potential_box.h>
#include <magmpm/parallel/gather.h>
#include <magmpm/parallel/reduce.h>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

namespace magmpm
{
  namespace
  {
    using BlockKeys = std::unordered_set<std::uint64_t>;

    /** Those of the cells that lie in a box of @p n_cells. */
    template <int dim>
    std::vector<Index<dim>>
    within(const std::vector<Index<dim>> &cells, const Index<dim> &n_cells)
    {
      std::vector<Index<dim>> inside;
      for (const Index<dim> &cell : cells)
        {
          bool is_inside = true;
          for (int d = 0; d < dim; ++d)
            is_inside = is_inside && cell[d] >= 0 && cell[d] < n_cells[d];
          if (is_inside)
            inside.push_back(cell);
        }
      return inside;
    }

    /** The cells of the next coarser level that hold these. */
    template <int dim>
    std::vector<Index<dim>>
    parents(const std::vector<Index<dim>> &cells)
    {
      BlockKeys seen;
      std::vector<Index<dim>> coarser;
      for (Index<dim> cell : cells)
        {
          for (int &coordinate : cell)
            coordinate >>= 1;
          if (seen.insert(block_key<dim>(cell)).second)
            coarser.push_back(cell);
        }
      return coarser;
    }

    /** What the ranks hold, one after the other. */
    template <typename T>
    std::vector<T>
    of_all_ranks(const MPI_Comm communicator, const std::vector<T> &values)
    {
      std::vector<T> all;
      for (const auto &of_rank : parallel::all_gather(values, communicator))
        all.insert(all.end(), of_rank.begin(), of_rank.end());
      return all;
    }

    /** All blocks at most @p distance blocks (in the maximum norm) from @p blocks. */
    template <int dim>
    std::vector<Index<dim>>
    dilated(std::vector<Index<dim>> blocks, const int distance)
    {
      for (int d = 0; d < dim; ++d)
        {
          BlockKeys seen;
          std::vector<Index<dim>> wider;
          for (const Index<dim> &block : blocks)
            for (int shift = -distance; shift <= distance; ++shift)
              {
                Index<dim> moved = block;
                moved[d] += shift;
                if (seen.insert(block_key<dim>(moved)).second)
                  wider.push_back(moved);
              }
          blocks = std::move(wider);
        }
      return blocks;
    }
  } // namespace

  template <int dim>
  struct BackgroundMesh<dim>::Implementation
  {
    using Tria         = dealii::parallel::distributed::Triangulation<dim>;
    using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

    Implementation(const MPI_Comm communicator,
                   const Lattice<dim> &lattice,
                   const MeshParameters<dim> &parameters);

    /** The place of a cell of any level, in cells of its level from the corner of the box. */
    Index<dim>
    place(const CellIterator &cell) const;

    /** The block that holds a cell of the level of blocks or finer. */
    Index<dim>
    block_of_cell(const CellIterator &cell) const;

    /**
     * Keys, by level, of the cells that have children in the mesh whose finest cells cover the blocks, and
     * that is coarse elsewhere but for 2:1 balance across faces, edges and corners. All ranks know them, so the
     * mesh depends neither on the ranks nor on the meshes before it. Finer than blocks the key is the block's.
     */
    std::vector<BlockKeys>
    refined_cells(std::vector<Index<dim>> blocks) const;

    /** Whether all of these blocks (the same on all ranks) have cells of the finest level. */
    bool
    is_fine(const std::vector<Index<dim>> &blocks) const;

    /** Whether the ancestor of a cell on @p level (or its block, if that is coarser) has a key. */
    bool
    is_among(const std::vector<BlockKeys> &keys, const CellIterator &cell, const int level) const;

    /** Refines cells with these keys that have no children, coarsens those whose parent has no such key. */
    bool
    refine_and_coarsen(const std::vector<BlockKeys> &refined);

    /** The weight of a cell for the partition: its share of the time of a step. */
    unsigned int
    weight(const CellIterator &cell) const;

    /** Weight of the cells of the most loaded rank over the mean. */
    double
    imbalance() const;

    const Lattice<dim> lattice;
    const PotentialBox<dim> box;
    const int finest_level;
    const double cell_weight; ///< of a cell without particles
    mutable Tria triangulation;

    /** Particles by block of all ranks, for the weights of cells. */
    std::unordered_map<std::uint64_t, unsigned int> particles_in_block;
    double imbalance_after_partition = 0.;
  };

  template <int dim>
  BackgroundMesh<dim>::Implementation::Implementation(const MPI_Comm communicator,
                                                      const Lattice<dim> &lattice,
                                                      const MeshParameters<dim> &parameters)
    : lattice(lattice)
    , box(potential_box(lattice, parameters))
    , finest_level(box.root_level +
                   (parameters.carries_potential ? (parameters.cell_edge == 1 ? 2 : 1) : 0))
    , cell_weight(parameters.carries_potential ? 3000. : 1.)
    , triangulation(communicator,
                    dealii::Triangulation<dim>::limit_level_difference_at_vertices,
                    typename Tria::Settings(Tria::construct_multigrid_hierarchy |
                                            Tria::no_automatic_repartitioning |
                                            Tria::communicate_vertices_to_p4est))
  {
    std::vector<unsigned int> repetitions(box.n_roots.begin(), box.n_roots.end());
    dealii::Point<dim> lower, upper;
    Index<dim> lower_node;
    for (int d = 0; d < dim; ++d)
      lower_node[d] = block_edge * box.lower[d];
    const Vector<dim> corner = lattice.node_position(lower_node);
    for (int d = 0; d < dim; ++d)
      {
        lower[d] = corner[d];
        upper[d] = corner[d] + lattice.spacing * block_edge * box.n_blocks()[d];
      }
    // Colorized: boundary ids 2 d and 2 d + 1 on the lower and upper face of direction d.
    dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation, repetitions, lower, upper, true);

    triangulation.signals.weight.connect(
      [this](const CellIterator &cell, const auto) { return weight(cell); });
  }

  // Costs of a step relative to each other: a cell of the potential takes as long as some 30 particles
  // if there is a solve every five steps, and less the rarer solves are.
  //
  // p4est keeps the children of a cell together, which are a block as long as cells have an edge of
  // 2 dx. Of finer ones the first of a block, in the order of p4est, carries the weight of all: cuts
  // between the ranks lie where the sum of weights grows, so never within a block.
  template <int dim>
  unsigned int
  BackgroundMesh<dim>::Implementation::weight(const CellIterator &cell) const
  {
    const double particle_weight = 100.;
    const int level              = cell->level();
    if (level < box.root_level)
      return static_cast<unsigned int>(cell_weight);

    double particles = 0.;
    const auto found = particles_in_block.find(block_key<dim>(block_of_cell(cell)));
    if (found != particles_in_block.end())
      particles = found->second;
    const int depth       = level - box.root_level;
    const double of_block = std::pow(2., dim * depth) * cell_weight + particle_weight * particles;
    if (depth < 2)
      return static_cast<unsigned int>(of_block / std::pow(2., dim * depth));
    for (const int coordinate : place(cell))
      if (coordinate % (1 << depth) != 0)
        return 0;
    return static_cast<unsigned int>(of_block);
  }

  template <int dim>
  Index<dim>
  BackgroundMesh<dim>::Implementation::place(const CellIterator &cell) const
  {
    Vector<dim> corner;
    for (int d = 0; d < dim; ++d)
      corner[d] = cell->vertex(0)[d];
    Index<dim> node = lattice.nearest_node(corner);
    const int edge  = (block_edge << box.root_level) >> cell->level(); // in dx
    for (int d = 0; d < dim; ++d)
      node[d] = (node[d] - block_edge * box.lower[d]) / edge;
    return node;
  }

  template <int dim>
  Index<dim>
  BackgroundMesh<dim>::Implementation::block_of_cell(const CellIterator &cell) const
  {
    Index<dim> block = place(cell);
    for (int d = 0; d < dim; ++d)
      block[d] = (block[d] >> (cell->level() - box.root_level)) + box.lower[d];
    return block;
  }

  template <int dim>
  std::vector<BlockKeys>
  BackgroundMesh<dim>::Implementation::refined_cells(std::vector<Index<dim>> blocks) const
  {
    // Cells of a level, counted from the corner of the box; first those of the finest cells' parents.
    std::vector<Index<dim>> cells;
    for (Index<dim> block : blocks)
      if (box.holds(block))
        {
          for (int d = 0; d < dim; ++d)
            block[d] -= box.lower[d];
          cells.push_back(block);
        }
    if (finest_level == box.root_level)
      cells = parents<dim>(cells);

    std::vector<BlockKeys> keys(finest_level);
    for (int level = finest_level - 1; level >= 0; --level)
      {
        for (const Index<dim> &cell : cells)
          keys[level].insert(block_key<dim>(cell));
        // A cell with children has neighbours of its own size, so their parents have children.
        Index<dim> n_cells;
        for (int d = 0; d < dim; ++d)
          n_cells[d] = box.n_roots[d] << std::min(level, box.root_level);
        cells = within<dim>(dilated<dim>(std::move(cells), 1), n_cells);
        if (level <= box.root_level)
          cells = parents<dim>(cells);
      }
    return keys;
  }

  template <int dim>
  bool
  BackgroundMesh<dim>::Implementation::is_fine(const std::vector<Index<dim>> &blocks) const
  {
    BlockKeys needed;
    for (const Index<dim> &block : blocks)
      if (box.holds(block))
        needed.insert(block_key<dim>(block));

    BlockKeys owned;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->level() == finest_level)
        {
          const Index<dim> block = block_of_cell(cell);
          if (needed.count(block_key<dim>(block)) > 0)
            owned.insert(block_key<dim>(block));
        }
    const std::size_t found = parallel::sum(owned.size(), triangulation.get_communicator());
    return found == needed.size();
  }

  template <int dim>
  bool
  BackgroundMesh<dim>::Implementation::is_among(const std::vector<BlockKeys> &keys,
                                                const CellIterator &cell,
                                                const int level) const
  {
    const int key_level = std::min(level, box.root_level);
    Index<dim> ancestor = place(cell);
    for (int d = 0; d < dim; ++d)
      ancestor[d] >>= cell->level() - key_level;
    return keys[level].count(block_key<dim>(ancestor)) > 0;
  }

  template <int dim>
  bool
  BackgroundMesh<dim>::Implementation::refine_and_coarsen(const std::vector<BlockKeys> &refined)
  {
    bool any = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const int level = cell->level();
          if (level < finest_level && is_among(refined, cell, level))
            {
              cell->set_refine_flag();
              any = true;
            }
          else if (level > 0 && !is_among(refined, cell, level - 1))
            {
              cell->set_coarsen_flag();
              any = true;
            }
        }
    any = parallel::any(any, triangulation.get_communicator());
    if (any)
      triangulation.execute_coarsening_and_refinement();
    return any;
  }

  template <int dim>
  double
  BackgroundMesh<dim>::Implementation::imbalance() const
  {
    double load = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        load += weight(cell);
    const MPI_Comm communicator = triangulation.get_communicator();
    double largest = load, sum = load;
    parallel::Reduction reduction;
    reduction.max(largest);
    reduction.sum(sum);
    reduction.carry_out(communicator);
    return sum > 0. ? largest / (sum / parallel::n_ranks(communicator)) : 1.;
  }

  template <int dim>
  BackgroundMesh<dim>::BackgroundMesh(const MPI_Comm communicator,
                                      const Lattice<dim> &lattice,
                                      const MeshParameters<dim> &parameters)
    : the_communicator(communicator)
    , the_lattice(lattice)
    , the_parameters(parameters)
    , implementation(std::make_unique<Implementation>(communicator, lattice, parameters))
  {
  }

  template <int dim>
  BackgroundMesh<dim>::~BackgroundMesh() = default;

  template <int dim>
  MeshAdaptation
  BackgroundMesh<dim>::adapt(const std::vector<Index<dim>> &local_blocks,
                             const std::vector<unsigned int> &local_weights,
                             const std::vector<Index<dim>> &local_approached)
  {
    Implementation &mesh = *implementation;

    // Every rank flags its own cells, so each has to know all blocks: 12 bytes per 512 particles.
    std::vector<Index<dim>> blocks = of_all_ranks(the_communicator, local_blocks);
    const auto weights             = of_all_ranks(the_communicator, local_weights);
    mesh.particles_in_block.clear();
    for (std::size_t b = 0; b < blocks.size(); ++b)
      mesh.particles_in_block[block_key<dim>(blocks[b])] += weights[b];

    const std::vector<Index<dim>> needed = dilated<dim>(blocks, 1);
    // The first mesh counts as one that does not serve: no cell of it was dealt out by weight.
    const bool is_fine = mesh.is_fine(needed) && the_revision > 0;
    MeshAdaptation result;
    result.imbalance_before = mesh.imbalance();
    result.imbalance        = result.imbalance_before;
    // What the last partition could not balance, the next one will not either.
    const double tolerated = std::max(the_parameters.imbalance_threshold,
                                      1.1 * mesh.imbalance_after_partition);
    result.is_rebalanced   = is_fine && result.imbalance_before > tolerated;
    if (is_fine && !result.is_rebalanced)
      return result;

    if (!is_fine)
      {
        const auto approached = of_all_ranks(the_communicator, local_approached);
        blocks.insert(blocks.end(), approached.begin(), approached.end());
        const auto refined =
          mesh.refined_cells(dilated<dim>(blocks, 1 + the_parameters.band_width));
        // A level a time; only families on one rank are coarsened. Where a family stays apart nothing
        // changes any more: such cells are left, they are finer than they need be.
        unsigned long long n_cells = 0;
        while (mesh.refine_and_coarsen(refined) &&
               (n_cells != mesh.triangulation.n_global_active_cells() || !mesh.is_fine(needed)))
          {
            n_cells = mesh.triangulation.n_global_active_cells();
            mesh.triangulation.repartition();
          }
      }
    mesh.triangulation.repartition();
    mesh.imbalance_after_partition = mesh.imbalance();
    result.imbalance               = mesh.imbalance_after_partition;
    result.is_refined              = !is_fine;
    ++the_revision;
    return result;
  }

  template <int dim>
  std::vector<unsigned int>
  BackgroundMesh<dim>::owners(const std::vector<Index<dim>> &blocks) const
  {
    // The first cell of a block in Morton order is the one at its lower corner; a point a quarter
    // of the smallest cell inside belongs to it however the block is refined.
    std::vector<dealii::Point<dim>> points(blocks.size());
    for (std::size_t b = 0; b < blocks.size(); ++b)
      {
        Index<dim> node = implementation->box.nearest(blocks[b]);
        for (int &coordinate : node)
          coordinate *= block_edge;
        const Vector<dim> corner = the_lattice.node_position(node);
        for (int d = 0; d < dim; ++d)
          points[b][d] = corner[d] + 0.25 * the_lattice.spacing;
      }
    return implementation->triangulation.find_point_owner_rank(points);
  }

  template <int dim>
  const typename BackgroundMesh<dim>::Triangulation &
  BackgroundMesh<dim>::triangulation() const
  {
    return implementation->triangulation;
  }

  template class BackgroundMesh<2>;
  template class BackgroundMesh<3>;
} // namespace magmpm
