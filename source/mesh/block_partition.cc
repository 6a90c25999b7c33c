#include <deal.II/base/partitioner.h>

#include <magmpm/mesh/block_partition.h>
#include <magmpm/parallel/exchange.h>

#include <algorithm>
#include <map>
#include <unordered_set>

namespace magmpm
{
  namespace
  {
    template <int dim>
    using BlocksByRank = std::map<unsigned int, std::vector<Index<dim>>>;

    /** The blocks around @p blocks that are not among @p known, by owner. */
    template <int dim>
    BlocksByRank<dim>
    blocks_around(const BackgroundMesh<dim> &mesh, const std::vector<Index<dim>> &blocks)
    {
      std::unordered_set<std::uint64_t> seen;
      std::vector<Index<dim>> around;
      for (const Index<dim> &block : blocks)
        for (int n = 0; n < n_neighbours<dim>; ++n)
          {
            const Index<dim> other = neighbour_block<dim>(block, n);
            if (seen.insert(block_key<dim>(other)).second)
              around.push_back(other);
          }
      const std::vector<unsigned int> owners = mesh.owners(around);
      BlocksByRank<dim> by_rank;
      for (std::size_t b = 0; b < around.size(); ++b)
        by_rank[owners[b]].push_back(around[b]);
      return by_rank;
    }
  } // namespace

  template <int dim>
  BlockPartition<dim>::BlockPartition(const BackgroundMesh<dim> &mesh)
    : mesh(mesh)
    , partitioner(std::make_unique<dealii::Utilities::MPI::Partitioner>())
  {
  }

  template <int dim>
  BlockPartition<dim>::~BlockPartition() = default;

  template <int dim>
  void
  BlockPartition<dim>::rebuild(const std::vector<Index<dim>> &occupied)
  {
    using dealii::types::global_dof_index;
    const MPI_Comm communicator = mesh.communicator();
    const unsigned int rank     = parallel::rank(communicator);

    // Occupied blocks activate the ones around them, also those of other ranks.
    BlocksByRank<dim> activated = blocks_around<dim>(mesh, occupied);
    for (const auto &request : parallel::exchange(activated, communicator))
      if (request.first != rank)
        activated[rank].insert(activated[rank].end(), request.second.begin(), request.second.end());
    std::vector<Index<dim>> owned = activated[rank];
    std::sort(owned.begin(), owned.end());
    owned.erase(std::unique(owned.begin(), owned.end()), owned.end());

    // Slots of all ranks in a row: a value has a global number, as an entry of a vector has.
    const std::vector<dealii::IndexSet> slots_of_ranks =
      dealii::Utilities::MPI::create_ascending_partitioning(communicator, owned.size());
    const global_dof_index first = owned.empty() ? 0 : slots_of_ranks[rank].nth_index_in_set(0);
    const global_dof_index total = slots_of_ranks[rank].size();
    const BlockSet<dim> owned_set(owned, static_cast<int>(owned.size()));

    // Ask the owners of the blocks around ours which of them are active.
    BlocksByRank<dim> asked = blocks_around<dim>(mesh, owned);
    asked.erase(rank);
    std::map<unsigned int, std::vector<long long>> answers;
    for (const auto &request : parallel::exchange(asked, communicator))
      for (const Index<dim> &block : request.second)
        {
          const int slot = owned_set.slot(block);
          answers[request.first].push_back(
            slot == invalid_slot ? -1 : static_cast<long long>(first + slot));
        }
    std::map<global_dof_index, Index<dim>> ghosts;
    for (const auto &answer : parallel::exchange(answers, communicator))
      for (std::size_t b = 0; b < answer.second.size(); ++b)
        if (answer.second[b] >= 0)
          ghosts[answer.second[b]] = asked[answer.first][b];

    // Ghosts come in the order of their global numbers: the order of the partitioner's ghosts.
    constexpr global_dof_index size = NodeField<dim>::block_size;
    dealii::IndexSet owned_values(size * total), ghost_values(size * total);
    owned_values.add_range(size * first, size * (first + owned.size()));
    std::vector<Index<dim>> all = owned;
    for (const auto &ghost : ghosts)
      {
        ghost_values.add_range(size * ghost.first, size * (ghost.first + 1));
        all.push_back(ghost.second);
      }
    // A fresh one: reinit() of deal.II 9.4 keeps parts of the old exchange pattern. Without an active
    // block anywhere, deal.II would divide by the number of values.
    using Partitioner = dealii::Utilities::MPI::Partitioner;
    partitioner       = (total == 0
                           ? std::make_unique<Partitioner>()
                           : std::make_unique<Partitioner>(owned_values, ghost_values, communicator));
    block_set         = BlockSet<dim>(std::move(all), static_cast<int>(owned.size()));
  }

  template <int dim>
  void
  BlockPartition<dim>::add_ghosts_to_owners(NodeField<dim> &field) const
  {
    const std::size_t n_owned  = partitioner->locally_owned_size();
    const std::size_t n_ghosts = partitioner->n_ghost_indices();
    std::vector<MPI_Request> requests;
    buffer.resize(partitioner->n_import_indices());
    const dealii::ArrayView<double> owned(field.block(0), n_owned);
    const dealii::ArrayView<double> ghosts(field.block(0) + n_owned, n_ghosts);
    partitioner->import_from_ghosted_array_start(
      dealii::VectorOperation::add, 0, ghosts, dealii::make_array_view(buffer), requests);
    partitioner->import_from_ghosted_array_finish(dealii::VectorOperation::add,
                                                  dealii::ArrayView<const double>(buffer.data(),
                                                                                  buffer.size()),
                                                  owned,
                                                  ghosts,
                                                  requests);
  }

  template <int dim>
  void
  BlockPartition<dim>::update_ghosts(NodeField<dim> &field) const
  {
    const std::size_t n_owned  = partitioner->locally_owned_size();
    const std::size_t n_ghosts = partitioner->n_ghost_indices();
    std::vector<MPI_Request> requests;
    buffer.resize(partitioner->n_import_indices());
    const dealii::ArrayView<double> ghosts(field.block(0) + n_owned, n_ghosts);
    partitioner->export_to_ghosted_array_start(0,
                                               dealii::ArrayView<const double>(field.block(0),
                                                                               n_owned),
                                               dealii::make_array_view(buffer),
                                               ghosts,
                                               requests);
    partitioner->export_to_ghosted_array_finish(ghosts, requests);
  }

  template class BlockPartition<2>;
  template class BlockPartition<3>;
} // namespace magmpm
