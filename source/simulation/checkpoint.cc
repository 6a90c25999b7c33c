#include <deal.II/base/utilities.h>

#include <magmpm/base/exceptions.h>
#include <magmpm/simulation/checkpoint.h>

#include <boost/crc.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace magmpm
{
  namespace
  {
    namespace fs = std::filesystem;

    /** What every file of a checkpoint begins with; another layout gets another number. */
    constexpr char signature[] = "magmpm checkpoint 1\n";

    struct FileHead
    {
      char signature[sizeof(magmpm::signature)];
      std::uint32_t checksum;
      std::uint64_t size; ///< of what follows [bytes]
    };

    std::uint32_t
    checksum_of(const std::vector<char> &bytes)
    {
      boost::crc_32_type crc;
      crc.process_bytes(bytes.data(), bytes.size());
      return crc.checksum();
    }

    /** Waits until a file, or the list of files of a folder, is on the disk. */
    void
    bring_to_disk(const std::string &path)
    {
      const int descriptor = ::open(path.c_str(), O_RDONLY);
      const bool is_synced = descriptor >= 0 && ::fsync(descriptor) == 0;
      if (descriptor >= 0)
        ::close(descriptor);
      if (!is_synced)
        throw RunError("'" + path + "' cannot be brought to the disk");
    }

    /** Writes a file, piece after piece, and waits until it is on the disk. */
    void
    write_pieces(const std::string &path, const std::vector<std::string_view> &pieces)
    {
      std::ofstream file(path, std::ios::binary);
      for (const std::string_view piece : pieces)
        file.write(piece.data(), piece.size());
      file.close();
      if (!file)
        throw RunError("'" + path + "' cannot be written; is the disk full?");
      bring_to_disk(path);
    }

    void
    write_file(const std::string &path, const std::vector<char> &bytes)
    {
      FileHead head = {};
      std::copy(std::begin(signature), std::end(signature), head.signature);
      head.checksum = checksum_of(bytes);
      head.size     = bytes.size();

      write_pieces(path,
                   {{reinterpret_cast<const char *>(&head), sizeof(head)},
                    {bytes.data(), bytes.size()}});
    }

    std::vector<char>
    read_file(const std::string &path)
    {
      std::ifstream file(path, std::ios::binary);
      if (!file)
        throw RunError("'" + path + "' is missing");
      FileHead head = {};
      file.read(reinterpret_cast<char *>(&head), sizeof(head));
      if (!file || !std::equal(std::begin(signature), std::end(signature), head.signature))
        throw RunError("'" + path + "' is not a file of a checkpoint, or of another version");
      std::error_code error;
      if (fs::file_size(path, error) != sizeof(head) + head.size)
        throw RunError("'" + path + "' is cut off");
      std::vector<char> bytes(head.size);
      file.read(bytes.data(), bytes.size());
      if (!file || checksum_of(bytes) != head.checksum)
        throw RunError("'" + path + "' is damaged");
      return bytes;
    }

    std::string
    particle_file(const std::string &folder, const unsigned int rank)
    {
      return folder + "/particles-" + with_digits(rank, 5) + ".bin";
    }

    /** The part of a checkpoint that is the same on all ranks, and the number of files beside it. */
    struct CommonPart
    {
      Checkpoint checkpoint;
      unsigned int n_ranks = 0;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &n_ranks;
        archive &checkpoint.version;
        archive &checkpoint.parameters;
        archive &checkpoint.run;
      }
    };
  } // namespace

  CheckpointFolder::CheckpointFolder(const MPI_Comm communicator,
                                     const std::string &output_directory,
                                     const int n_kept)
    : communicator(communicator)
    , folder(output_directory + "/checkpoint")
    , n_kept(n_kept)
  {
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &n_ranks);
  }

  std::string
  CheckpointFolder::latest() const
  {
    std::ifstream file(folder + "/latest");
    std::string name;
    std::getline(file, name);
    return name.empty() ? name : folder + "/" + name;
  }

  void
  CheckpointFolder::write(const std::string &name, const Checkpoint &checkpoint) const
  {
    const std::string path = folder + "/" + name;
    const std::string what = "the checkpoint '" + path + "' was not written";
    // What is resumed from is never written over.
    if (parallel::broadcast(latest(), communicator) == path)
      return;

    parallel::together(communicator, what, [&]() {
      if (rank > 0)
        return;
      fs::remove_all(path);
      fs::create_directories(path);
    });
    parallel::together(communicator, what, [&]() {
      write_file(particle_file(path, rank), dealii::Utilities::pack(checkpoint.particles, false));
      if (rank > 0)
        return;
      CommonPart common;
      common.checkpoint.version    = checkpoint.version;
      common.checkpoint.parameters = checkpoint.parameters;
      common.checkpoint.run        = checkpoint.run;
      common.n_ranks               = n_ranks;
      write_file(path + "/run.bin", dealii::Utilities::pack(common, false));
      bring_to_disk(path);
    });
    parallel::together(communicator, what, [&]() {
      if (rank > 0)
        return;
      const std::string unfinished = folder + "/latest.unfinished";
      write_pieces(unfinished, {name, "\n"});
      fs::rename(unfinished, folder + "/latest");
      bring_to_disk(folder);
      remove_old_ones();
    });
  }

  void
  CheckpointFolder::remove_old_ones() const
  {
    std::vector<fs::path> checkpoints;
    for (const auto &entry : fs::directory_iterator(folder))
      if (entry.is_directory())
        checkpoints.push_back(entry.path());
    std::sort(checkpoints.begin(), checkpoints.end()); // by name: the oldest first
    const std::string newest = latest();
    for (std::size_t c = 0; c + n_kept < checkpoints.size(); ++c)
      if (checkpoints[c] != newest)
        fs::remove_all(checkpoints[c]);
  }

  Checkpoint
  CheckpointFolder::read() const
  {
    const std::string path = parallel::broadcast(latest(), communicator);
    if (path.empty())
      throw InputError("there is nothing to resume: '" + folder +
                       "/latest' does not exist or is empty. Start the run without --resume.");
    CommonPart common;
    parallel::together(
      communicator,
      "the checkpoint '" + path + "' cannot be read (the ones beside it may be good: write the " +
        "name of another one into '" + folder + "/latest')",
      [&]() {
        common = dealii::Utilities::unpack<CommonPart>(read_file(path + "/run.bin"), false);
        for (unsigned int file = rank; file < common.n_ranks; file += n_ranks)
          {
            const auto particles = dealii::Utilities::unpack<std::vector<std::vector<double>>>(
              read_file(particle_file(path, file)), false);
            auto &all = common.checkpoint.particles;
            all.resize(particles.size());
            for (std::size_t b = 0; b < particles.size(); ++b)
              all[b].insert(all[b].end(), particles[b].begin(), particles[b].end());
          }
      });
    return common.checkpoint;
  }

  void
  CheckpointFolder::clear() const
  {
    together(communicator, "the checkpoints of an earlier run stay", [&]() {
      if (rank == 0)
        fs::remove_all(folder);
    });
  }
} // namespace magmpm
