#pragma once

#include <magmpm/base/tensor.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <sstream>
#include <string>
#include <vector>

/** State of the parts of a run as named, versioned sections of a checkpoint. */
namespace magmpm
{
  /** What a section of a checkpoint is called, and the version of what is in it. */
  struct SectionTitle
  {
    std::string name;
    unsigned int version = 1; ///< another one whenever the members of the state change

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &name;
      archive &version;
    }
  };

  /** A section: the state of one part of the run, the same on all ranks. */
  struct Section
  {
    SectionTitle title;
    std::string bytes;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &title;
      archive &bytes;
    }
  };

  template <typename Archive, int n>
  void
  serialize(Archive &archive, Vector<n> &vector, const unsigned int /*version*/)
  {
    for (int i = 0; i < n; ++i)
      archive &vector[i];
  }

  template <typename Archive, int n>
  void
  serialize(Archive &archive, Matrix<n> &matrix, const unsigned int /*version*/)
  {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        archive &matrix(i, j);
  }

  /** Any type with serialize() as bytes. */
  template <typename State>
  std::string
  pack(const State &state)
  {
    std::ostringstream bytes;
    {
      boost::archive::binary_oarchive archive(bytes, boost::archive::no_header);
      archive << state;
    }
    return bytes.str();
  }

  /** What pack() made bytes of. @throw boost::archive::archive_exception  if they end too soon. */
  template <typename State>
  void
  unpack(const std::string &bytes, State &state)
  {
    std::istringstream stream(bytes);
    boost::archive::binary_iarchive archive(stream, boost::archive::no_header);
    archive >> state;
  }

  /**
   * The sections of a checkpoint against those that this program and scene have.
   *
   * @throw RunError  naming the section that is missing, unknown or of another version.
   */
  void
  check_titles(const std::vector<SectionTitle> &found, const std::vector<SectionTitle> &expected);

  /** The bytes of the section called @p name. @throw RunError  if there is none. */
  const std::string &
  section_named(const std::string &name, const std::vector<Section> &sections);
} // namespace magmpm
