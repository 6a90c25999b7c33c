
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

    /** The blocks around @p blocks and around them, by owner. */
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

    /** Those numbers of a block that hold a quantity. */
    template <int dim>
    std::vector<int>
    used_numbers(const NodeLayout &layout)
    {
      std::vector<int> numbers;
      for (int node = 0; node < nodes_per_block<dim>; ++node)
        for (int lane = 0; lane < layout.n_lanes; ++lane)
          if (layout.components[lane] != NodeLayout::unused)
            numbers.push_back(node * layout.n_lanes + lane);
      return numbers;
    }

    template <int dim>
    MirrorWalls<dim>
    shielded_walls(const BackgroundMesh<dim> &mesh)
    {
      MirrorWalls<dim> walls;
      walls.n_cells = mesh.lattice().n_cells;
      if (mesh.parameters().carries_potential)
        walls.is_mirror = mesh.parameters().shielded;
      return walls;
    }

    /** Of messages between ranks; those of others have other tags. */
    constexpr int message_tag = 4205;
  } // namespace

  template <int dim>
  BlockPartition<dim>::BlockPartition(const BackgroundMesh<dim> &mesh)
    : mesh(mesh)
    , mirrors(shielded_walls(mesh))
  {
  }

  template <int dim>
  void
  BlockPartition<dim>::rebuild(const std::vector<Index<dim>> &occupied)
  {
    const MPI_Comm communicator = mesh.communicator();
    const unsigned int rank     = parallel::rank(communicator);

    // Occupied blocks activate the ones around them, also those of other ranks.
    BlocksByRank<dim> activated = blocks_around<dim>(mesh, occupied);
    for (const auto &request : parallel::exchange(activated, communicator))
      if (request.first != rank)
        activated[rank].insert(activated[rank].end(), request.second.begin(), request.second.end());
    std::vector<Index<dim>> all = activated[rank];
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());

    const int n_owned                          = static_cast<int>(all.size());
    const std::vector<Index<dim>> ghost_blocks = find_ghosts(all);
    all.insert(all.end(), ghost_blocks.begin(), ghost_blocks.end());
    block_set = BlockSet<dim>(std::move(all), n_owned);
  }

  template <int dim>
  std::vector<Index<dim>>
  BlockPartition<dim>::find_ghosts(const std::vector<Index<dim>> &owned)
  {
    const MPI_Comm communicator = mesh.communicator();
    const BlockSet<dim> owned_set(owned, static_cast<int>(owned.size()));
    ghosts.clear();
    ghosts_there.clear();

    // Ask the owners of the blocks around ours which of them are active; they answer with slots.
    BlocksByRank<dim> asked = blocks_around<dim>(mesh, owned);
    asked.erase(parallel::rank(communicator));
    std::map<unsigned int, std::vector<int>> answers;
    for (const auto &request : parallel::exchange(asked, communicator))
      {
        std::vector<int> &slots = answers[request.first];
        for (const Index<dim> &block : request.second)
          slots.push_back(owned_set.slot(block));
        Message message = {static_cast<int>(request.first), slots};
        std::sort(message.slots.begin(), message.slots.end());
        message.slots.erase(
          message.slots.begin(),
          std::upper_bound(message.slots.begin(), message.slots.end(), invalid_slot));
        if (!message.slots.empty())
          ghosts_there.push_back(message);
      }

    // Ghosts come by owner, and in the order that they have there: that of messages.
    std::vector<Index<dim>> ghost_blocks;
    for (const auto &answer : parallel::exchange(answers, communicator))
      {
        std::map<int, Index<dim>> active;
        for (std::size_t b = 0; b < answer.second.size(); ++b)
          if (answer.second[b] != invalid_slot)
            active[answer.second[b]] = asked[answer.first][b];
        Message message = {static_cast<int>(answer.first), {}};
        for (const auto &ghost : active)
          {
            message.slots.push_back(static_cast<int>(owned.size() + ghost_blocks.size()));
            ghost_blocks.push_back(ghost.second);
          }
        if (!message.slots.empty())
          ghosts.push_back(message);
      }
    return ghost_blocks;
  }

  template <int dim>
  template <typename Take>
  void
  BlockPartition<dim>::exchange(const std::vector<Message> &outgoing,
                                const std::vector<Message> &incoming,
                                NodeNumbers<dim> &field,
                                const Take &take) const
  {
    ++count.n_exchanges;
    count.n_lanes += field.layout().n_used;

    const std::vector<int> used = used_numbers<dim>(field.layout());
    std::size_t n_blocks        = 0;
    for (const auto *messages : {&outgoing, &incoming})
      for (const Message &message : *messages)
        n_blocks += message.slots.size();
    buffer.resize(n_blocks * used.size());

    // Counted in blocks: in numbers, a large message would overflow MPI's int.
    MPI_Datatype block;
    MPI_Type_contiguous(static_cast<int>(used.size()), MPI_DOUBLE, &block);
    MPI_Type_commit(&block);
    std::vector<MPI_Request> requests(outgoing.size() + incoming.size());
    auto request = requests.begin();
    double *next = buffer.data();
    for (const Message &message : incoming)
      {
        const int n = static_cast<int>(message.slots.size());
        MPI_Irecv(next, n, block, message.rank, message_tag, mesh.communicator(), &*request++);
        next += n * used.size();
      }
    for (const Message &message : outgoing)
      {
        const double *first = next;
        for (const int slot : message.slots)
          for (const int i : used)
            *next++ = field.block(slot)[i];
        const int n = static_cast<int>(message.slots.size());
        MPI_Isend(first, n, block, message.rank, message_tag, mesh.communicator(), &*request++);
      }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    MPI_Type_free(&block);

    const double *arrived = buffer.data();
    for (const Message &message : incoming)
      for (const int slot : message.slots)
        for (const int i : used)
          take(field.block(slot)[i], *arrived++);
  }

  template <int dim>
  void
  BlockPartition<dim>::add_ghosts_to_owners(NodeNumbers<dim> &field) const
  {
    exchange(ghosts, ghosts_there, field, [](double &sum, const double part) { sum += part; });
    for (int slot = block_set.n_owned(); slot < block_set.size(); ++slot)
      std::fill_n(field.block(slot), field.numbers_per_block(), 0.);
  }

  template <int dim>
  void
  BlockPartition<dim>::add_ghosts_to_owners(NodeNumbers<dim> &field, const Parity &parity) const
  {
    add_ghosts_to_owners(field);
    add_images(block_set, block_set.n_owned(), mirrors, parity, field);
  }

  template <int dim>
  void
  BlockPartition<dim>::update_ghosts(NodeNumbers<dim> &field) const
  {
    exchange(ghosts_there, ghosts, field, [](double &value, const double owners) {
      value = owners;
    });
  }

  template <int dim>
  void
  BlockPartition<dim>::update_ghosts(NodeNumbers<dim> &field, const Parity &parity) const
  {
    copy_images(block_set, block_set.n_owned(), mirrors, parity, field);
    update_ghosts(field);
  }

  template class BlockPartition<2>;
  template class BlockPartition<3>;
} // namespace magmpm
