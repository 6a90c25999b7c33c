#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

/** A file of a checkpoint: a head with the version of the format, length and CRC, then bytes. */
namespace magmpm
{
  /** What the layout of all files of a checkpoint is called by; another layout gets another number. */
  inline constexpr int checkpoint_format = 2;

  /** Bytes somewhere in memory that go into a file. */
  struct ConstBytes
  {
    const void *begin;
    std::size_t size;
  };

  /** Bytes somewhere in memory that come from a file. */
  struct Bytes
  {
    void *begin;
    std::size_t size;
  };

  /**
   * Writes pieces of memory one after the other, and waits until they are on the disk.
   *
   * @throw RunError  if the disk does not take them.
   */
  void
  write_checkpoint_file(const std::string &path, const std::vector<ConstBytes> &pieces);

  /** Reads a file piece by piece into memory that is made for it, and checks it at the end. */
  class CheckpointFileReader
  {
  public:
    /** @throw RunError  if there is no such file, or it is cut off or of another version. */
    explicit CheckpointFileReader(const std::string &path);
    ~CheckpointFileReader();

    /** Bytes not read yet. */
    std::size_t
    n_left() const;

    /** @throw RunError  if the file has no more so many bytes. */
    void
    read(const Bytes &target);

    /** @throw RunError  if there is more in the file than was read, or something else than was written. */
    void
    finish();

  private:
    struct State;
    std::unique_ptr<State> state;
  };

  /** Waits until a file, or the list of files of a folder, is on the disk. */
  void
  bring_to_disk(const std::string &path);
} // namespace magmpm
