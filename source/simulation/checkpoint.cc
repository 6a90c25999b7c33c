#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/gather.h>
#include <magmpm/parallel/together.h>
#include <magmpm/simulation/checkpoint.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace magmpm
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr std::size_t entry_size = 8; ///< bytes of one particle in a column

    std::string
    particle_file(const std::string &folder, const unsigned int rank)
    {
      char name[32];
      std::snprintf(name, sizeof(name), "/particles-%05u.bin", rank);
      return folder + name;
    }

    /** What comes before the columns of a body in a file of particles. */
    struct BodyHead
    {
      std::uint64_t n_columns;
      std::uint64_t n_particles;
    };

    void
    write_particles(const std::string &path, const std::vector<ColumnsToWrite> &bodies)
    {
      std::vector<BodyHead> heads;
      for (const ColumnsToWrite &columns : bodies)
        heads.push_back({columns.size(), columns.empty() ? 0 : columns.front().size / entry_size});
      std::vector<ConstBytes> pieces;
      for (std::size_t b = 0; b < bodies.size(); ++b)
        {
          pieces.push_back({&heads[b], sizeof(BodyHead)});
          pieces.insert(pieces.end(), bodies[b].begin(), bodies[b].end());
        }
      write_checkpoint_file(path, pieces);
    }

    void
    read_particle_file(const std::string &path, const MakeRoom &make_room)
    {
      CheckpointFileReader file(path);
      for (std::size_t body = 0; file.n_left() > 0; ++body)
        {
          BodyHead head = {};
          file.read({&head, sizeof(head)});
          // Before memory is taken for it: a damaged number could ask for all there is.
          const std::size_t n_entries = file.n_left() / entry_size;
          if (head.n_particles > 0 &&
              (head.n_columns == 0 || head.n_columns > n_entries / head.n_particles))
            throw RunError("'" + path + "' is damaged");
          const std::vector<Bytes> columns = make_room(body, head.n_particles);
          if (columns.size() != head.n_columns)
            throw RunError("'" + path + "' has " + std::to_string(head.n_columns) +
                           " columns of body " + std::to_string(body) + ", this magmpm has " +
                           std::to_string(columns.size()));
          for (const Bytes &column : columns)
            file.read(column);
        }
      file.finish();
    }
  } // namespace

  std::vector<SectionTitle>
  Checkpoint::titles() const
  {
    std::vector<SectionTitle> titles;
    for (const Section &section : sections)
      titles.push_back(section.title);
    return titles;
  }

  CheckpointFolder::CheckpointFolder(const MPI_Comm communicator,
                                     const std::string &output_directory,
                                     const int n_kept)
    : communicator(communicator)
    , folder(output_directory + "/" + checkpoint_output.name)
    , n_kept(n_kept)
  {
  }

  std::string
  CheckpointFolder::latest() const
  {
    std::string path;
    if (parallel::rank(communicator) == 0)
      {
        std::ifstream file(folder + "/latest");
        std::getline(file, path);
        if (!path.empty())
          path = folder + "/" + path;
      }
    return parallel::broadcast(path, communicator);
  }

  void
  CheckpointFolder::write(const std::string &name,
                          Checkpoint checkpoint,
                          const std::vector<ColumnsToWrite> &particles) const
  {
    const std::string path  = folder + "/" + name;
    const std::string what  = "the checkpoint '" + path + "' was not written";
    const unsigned int rank = parallel::rank(communicator);
    // What is resumed from is never written over.
    if (latest() == path)
      return;

    checkpoint.n_files = parallel::n_ranks(communicator);
    parallel::together(communicator, what, [&]() {
      if (rank > 0)
        return;
      fs::remove_all(path);
      fs::create_directories(path);
    });
    parallel::together(communicator, what, [&]() {
      write_particles(particle_file(path, rank), particles);
      if (rank > 0)
        return;
      const std::string bytes = pack(checkpoint);
      write_checkpoint_file(path + "/run.bin", {{bytes.data(), bytes.size()}});
      bring_to_disk(path);
    });
    parallel::together(communicator, what, [&]() {
      if (rank > 0)
        return;
      const std::string unfinished = folder + "/latest.unfinished";
      if (!(std::ofstream(unfinished) << name << '\n' << std::flush))
        throw RunError("'" + unfinished + "' cannot be written; is the disk full?");
      bring_to_disk(unfinished);
      fs::rename(unfinished, folder + "/latest");
      bring_to_disk(folder);
      remove_old_ones(path);
    });
  }

  void
  CheckpointFolder::remove_old_ones(const std::string &newest) const
  {
    std::vector<fs::path> checkpoints;
    for (const auto &entry : fs::directory_iterator(folder))
      if (entry.is_directory())
        checkpoints.push_back(entry.path());
    std::sort(checkpoints.begin(), checkpoints.end()); // by name: the oldest first
    for (std::size_t c = 0; c + n_kept < checkpoints.size(); ++c)
      if (checkpoints[c] != newest)
        fs::remove_all(checkpoints[c]);
  }

  namespace
  {
    std::string
    cannot_be_read(const std::string &path, const std::string &folder)
    {
      return "the checkpoint '" + path +
             "' cannot be read (the ones beside it may be good: write " +
             "the name of another one into '" + folder + "/latest')";
    }
  } // namespace

  Checkpoint
  CheckpointFolder::read() const
  {
    const std::string path = latest();
    if (path.empty())
      throw InputError("there is nothing to resume: '" + folder +
                       "/latest' does not exist or is empty. Start the run without --resume.");
    Checkpoint checkpoint;
    parallel::together(communicator, cannot_be_read(path, folder), [&]() {
      CheckpointFileReader file(path + "/run.bin");
      std::string bytes(file.n_left(), '\0');
      file.read({bytes.data(), bytes.size()});
      file.finish();
      unpack(bytes, checkpoint);
    });
    return checkpoint;
  }

  void
  CheckpointFolder::read_particles(const Checkpoint &checkpoint, const MakeRoom &make_room) const
  {
    const std::string path = latest();
    parallel::together(communicator, cannot_be_read(path, folder), [&]() {
      for (unsigned int file = parallel::rank(communicator); file < checkpoint.n_files;
           file += parallel::n_ranks(communicator))
        read_particle_file(particle_file(path, file), make_room);
    });
  }

  void
  CheckpointFolder::clear() const
  {
    parallel::together(communicator, "the checkpoints of an earlier run stay", [&]() {
      if (parallel::rank(communicator) == 0)
        fs::remove_all(folder);
    });
  }
} // namespace magmpm
