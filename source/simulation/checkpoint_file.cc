#include <magmpm/base/exceptions.h>
#include <magmpm/simulation/checkpoint_file.h>

#include <boost/crc.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace magmpm
{
  namespace
  {
    /** What every file begins with. */
    struct FileHead
    {
      char signature[32]; ///< "magmpm checkpoint 2\n", filled up with zeros
      std::uint64_t size; ///< of what follows [bytes]
      std::uint32_t checksum;
      std::uint32_t unused;
    };

    constexpr char signature[] = "magmpm checkpoint ";

    std::string
    signature_of(const int format)
    {
      return signature + std::to_string(format) + '\n';
    }

    /** The number of the format in the first bytes of a file; 0: it is no file of a checkpoint. */
    int
    format_of(const char *head)
    {
      const std::size_t length = sizeof(signature) - 1;
      if (std::strncmp(head, signature, length) != 0)
        return 0;
      const int format = std::atoi(head + length);
      return head == signature_of(format) ? format : 0;
    }
  } // namespace

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

  void
  write_checkpoint_file(const std::string &path, const std::vector<ConstBytes> &pieces)
  {
    FileHead head = {};
    signature_of(checkpoint_format).copy(head.signature, sizeof(head.signature) - 1);
    boost::crc_32_type crc;
    for (const ConstBytes &piece : pieces)
      {
        crc.process_bytes(piece.begin, piece.size);
        head.size += piece.size;
      }
    head.checksum = crc.checksum();

    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char *>(&head), sizeof(head));
    for (const ConstBytes &piece : pieces)
      file.write(static_cast<const char *>(piece.begin), piece.size);
    file.close();
    if (!file)
      throw RunError("'" + path + "' cannot be written; is the disk full?");
    bring_to_disk(path);
  }

  struct CheckpointFileReader::State
  {
    std::string path;
    std::ifstream file;
    FileHead head      = {};
    std::size_t n_left = 0; ///< bytes
    boost::crc_32_type crc;
  };

  CheckpointFileReader::CheckpointFileReader(const std::string &path)
    : state(std::make_unique<State>())
  {
    state->path = path;
    state->file.open(path, std::ios::binary);
    if (!state->file)
      throw RunError("'" + path + "' is missing");
    FileHead &head = state->head;
    state->file.read(reinterpret_cast<char *>(&head), sizeof(head));
    head.signature[sizeof(head.signature) - 1] = '\0';

    const int format = format_of(head.signature);
    if (format == 0)
      throw RunError("'" + path + "' is not a file of a checkpoint");
    if (format != checkpoint_format)
      throw RunError("'" + path + "' has version " + std::to_string(format) +
                     " of the format of checkpoints, this magmpm reads version " +
                     std::to_string(checkpoint_format) +
                     ": resume it with the version of magmpm that wrote it, or start anew");
    std::error_code error;
    if (!state->file || std::filesystem::file_size(path, error) != sizeof(head) + head.size)
      throw RunError("'" + path + "' is cut off");
    state->n_left = head.size;
  }

  CheckpointFileReader::~CheckpointFileReader() = default;

  std::size_t
  CheckpointFileReader::n_left() const
  {
    return state->n_left;
  }

  void
  CheckpointFileReader::read(const Bytes &target)
  {
    if (target.size > state->n_left ||
        !state->file.read(static_cast<char *>(target.begin), target.size))
      throw RunError("'" + state->path + "' is damaged");
    state->crc.process_bytes(target.begin, target.size);
    state->n_left -= target.size;
  }

  void
  CheckpointFileReader::finish()
  {
    if (state->n_left > 0 || state->crc.checksum() != state->head.checksum)
      throw RunError("'" + state->path + "' is damaged");
  }
} // namespace magmpm
