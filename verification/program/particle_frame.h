#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace magmpm::verification
{
  /** The particles of a frame as a run wrote them for ParaView. */
  struct ParticleFrame
  {
    double time = 0.;                             ///< [s]
    std::vector<std::array<double, 3>> positions; ///< [m]

    /** Scalars and vectors by name, "J [-]", of three components the latter. */
    std::map<std::string, std::vector<std::vector<double>>> quantities;

    std::size_t
    size() const
    {
      return positions.size();
    }
  };

  /**
   * The frames of an output folder in their order, read with VTK.
   *
   * @throw std::runtime_error if the folder has no particles.pvd.
   */
  std::vector<ParticleFrame>
  particle_frames(const std::string &folder);

  /** The positions alone. */
  std::vector<std::vector<std::array<double, 3>>>
  particle_positions(const std::string &folder);
} // namespace magmpm::verification
