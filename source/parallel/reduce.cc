#include <magmpm/parallel/reduce.h>

#include <algorithm>
#include <cmath>

namespace magmpm::parallel
{
  namespace
  {
    using Operation = Reduction::Operation;
    using Parcel    = Reduction::Parcel;
    static_assert(sizeof(Parcel) == 16 && std::is_trivially_copyable_v<Parcel>);

    /** Parcels in one message: 1 GB, since MPI counts in int. */
    constexpr std::size_t max_parcels = std::size_t(1) << 26;

    template <typename Number>
    Number
    combined(const Operation operation, const Number a, const Number b)
    {
      if (operation == Operation::sum)
        return a + b;
      if (std::isnan(static_cast<double>(a)))
        return a;
      if (std::isnan(static_cast<double>(b)))
        return b;
      return operation == Operation::max ? std::max(a, b) : std::min(a, b);
    }

    /** What MPI calls (MPI_User_function) to combine the parcels of two ranks, or groups of them. */
    void
    combine(void *some, void *others, int *n_parcels, MPI_Datatype *)
    {
      const auto *from = static_cast<const Parcel *>(some);
      auto *to         = static_cast<Parcel *>(others);
      for (int i = 0; i < *n_parcels; ++i)
        if (from[i].is_integer)
          to[i].integer = combined(from[i].operation, from[i].integer, to[i].integer);
        else
          to[i].real = combined(from[i].operation, from[i].real, to[i].real);
    }

    /** The type of a parcel and what is done with it, known to MPI while this lives. */
    struct Exchange
    {
      MPI_Datatype type;
      MPI_Op operation;

      Exchange()
      {
        MPI_Type_contiguous(sizeof(Parcel), MPI_BYTE, &type);
        MPI_Type_commit(&type);
        MPI_Op_create(&combine, true, &operation);
      }

      ~Exchange()
      {
        MPI_Op_free(&operation);
        MPI_Type_free(&type);
      }
    };
  } // namespace

  void
  Reduction::carry_out(const MPI_Comm communicator)
  {
    if (entries.empty())
      return;
    std::vector<Parcel> parcels(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
      {
        parcels[i].operation = entries[i].operation;
        entries[i].send(entries[i].number, parcels[i]);
      }

    Exchange exchange;
    for (std::size_t begin = 0; begin < parcels.size(); begin += max_parcels)
      MPI_Allreduce(MPI_IN_PLACE,
                    &parcels[begin],
                    static_cast<int>(std::min(max_parcels, parcels.size() - begin)),
                    exchange.type,
                    exchange.operation,
                    communicator);

    for (std::size_t i = 0; i < entries.size(); ++i)
      entries[i].receive(parcels[i], entries[i].number);
    entries.clear();
  }
} // namespace magmpm::parallel
