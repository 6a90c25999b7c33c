#include <magmpm/parallel/exchange.h>

#include <algorithm>
#include <cstring>

namespace magmpm::parallel::internal
{
  namespace
  {
    /** Of the messages of exchange(), which come from any rank. */
    constexpr int tag = 20517;

    /** A vector without entries is a message, too. */
    std::size_t
    n_pieces_of(const Outgoing &message, const std::size_t n_bytes_of_piece)
    {
      return std::max<std::size_t>((message.n_bytes + n_bytes_of_piece - 1) / n_bytes_of_piece, 1);
    }

    /** How many pieces come to this rank, from all of them. Collective. */
    int
    n_incoming_pieces(const std::vector<Outgoing> &outgoing,
                      const std::size_t n_bytes_of_piece,
                      const MPI_Comm communicator)
    {
      std::vector<int> n_pieces(n_ranks(communicator), 0);
      for (const Outgoing &message : outgoing)
        if (message.rank != rank(communicator))
          n_pieces[message.rank] += static_cast<int>(n_pieces_of(message, n_bytes_of_piece));
      int n_incoming = 0;
      MPI_Reduce_scatter_block(n_pieces.data(), &n_incoming, 1, MPI_INT, MPI_SUM, communicator);
      return n_incoming;
    }

    /** Begins to send all pieces of a message. */
    void
    send(const Outgoing &message,
         const std::size_t n_bytes_of_piece,
         const MPI_Comm communicator,
         std::vector<MPI_Request> &requests)
    {
      const std::size_t n_pieces = n_pieces_of(message, n_bytes_of_piece);
      for (std::size_t piece = 0; piece < n_pieces; ++piece)
        {
          const std::size_t begin = piece * n_bytes_of_piece;
          MPI_Isend(static_cast<const char *>(message.data) + begin,
                    static_cast<int>(std::min(n_bytes_of_piece, message.n_bytes - begin)),
                    MPI_BYTE,
                    static_cast<int>(message.rank),
                    tag,
                    communicator,
                    &requests.emplace_back());
        }
    }

    /** Receives the next piece of any rank. */
    void
    receive(const std::function<void *(unsigned int, std::size_t)> &make_room,
            const MPI_Comm communicator)
    {
      MPI_Status status;
      MPI_Probe(MPI_ANY_SOURCE, tag, communicator, &status);
      int n_bytes;
      MPI_Get_count(&status, MPI_BYTE, &n_bytes);
      void *memory = make_room(static_cast<unsigned int>(status.MPI_SOURCE),
                               static_cast<std::size_t>(n_bytes));
      MPI_Recv(memory, n_bytes, MPI_BYTE, status.MPI_SOURCE, tag, communicator, MPI_STATUS_IGNORE);
    }
  } // namespace

  void
  exchange(const std::vector<Outgoing> &outgoing,
           const std::function<void *(unsigned int, std::size_t)> &make_room,
           const std::size_t n_bytes_of_piece,
           const MPI_Comm communicator)
  {
    // Nobody sends before all know what comes: then no rank can still be in the exchange before this
    // one, and take a piece of this one for its own.
    const int n_incoming = n_incoming_pieces(outgoing, n_bytes_of_piece, communicator);
    std::vector<MPI_Request> requests;
    for (const Outgoing &message : outgoing)
      if (message.rank != rank(communicator))
        send(message, n_bytes_of_piece, communicator, requests);
      else if (void *memory = make_room(message.rank, message.n_bytes); message.n_bytes > 0)
        std::memcpy(memory, message.data, message.n_bytes);

    // The pieces of a rank come in order.
    for (int piece = 0; piece < n_incoming; ++piece)
      receive(make_room, communicator);
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  }
} // namespace magmpm::parallel::internal
