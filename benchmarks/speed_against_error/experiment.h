#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/materials/magnetization.h>

#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  enum class ExperimentKind
  {
    sphere_in_uniform_field, ///< Langevin law
    sphere_near_dipole,      ///< linear law, 3 R from the centre: the exact force is a series
    cube_near_magnet         ///< Langevin law, a magnet half as wide as the cube
  };

  inline constexpr ExperimentKind all_experiments[] = {ExperimentKind::sphere_in_uniform_field,
                                                       ExperimentKind::sphere_near_dipole,
                                                       ExperimentKind::cube_near_magnet};

  const char *
  to_string(const ExperimentKind kind);

  /** The medium of all experiments. */
  struct Medium
  {
    double susceptibility = 0.91; ///< chi_0
    double argument       = 1.;   ///< a inside the sphere in the uniform field
  };

  /** What a scheme finds, or what is exact. */
  struct MagneticState
  {
    Vector<3> moment;      ///< [A m^2]
    Vector<3> force;       ///< [N]
    Matrix<3> virial;      ///< sum f_i (x_i - c)^T [J]
    double field_rms = 0.; ///< of H - H_exact within 0.7 R [A/m]
  };

  /** Relative errors; not a number where the experiment has none to compare with. */
  struct StateErrors
  {
    double moment;
    double force;
    double field;  ///< rms of H within 0.7 R
    double virial; ///< of the deviator, Frobenius norm
  };

  /** Names of the four, in their order. */
  inline constexpr const char *error_names[] = {"moment", "force", "rms H", "virial deviator"};

  inline constexpr double StateErrors::*error_members[] = {&StateErrors::moment,
                                                           &StateErrors::force,
                                                           &StateErrors::field,
                                                           &StateErrors::virial};

  /**
   * A body, its particles and sources, at R/dx = resolution (a cube has the edge 2 R), at one place
   * in the cells of the lattice: both schemes get the same particles, as far from a node.
   */
  class Experiment
  {
  public:
    /**
     * @param resolution  R/dx.
     * @param offset      number of the random place within a cell, and of the jitter.
     */
    Experiment(const ExperimentKind kind,
               const int resolution,
               const unsigned int offset,
               const Medium &medium);

    /** @param middle  a node in the middle of the box [m]. */
    Vector<3>
    centre(const Vector<3> &middle, const bool is_moved) const
    {
      return middle + shift + (is_moved ? 0.1 * spacing : 0.) * travel_direction();
    }

    /** Positions of the particles [m]; moved: by 0.1 dx, as for a solve of a later frame. */
    std::vector<Vector<3>>
    points(const Vector<3> &middle, const bool is_moved) const;

    /** They stay where they are when the body moves. */
    ExternalField<3>
    sources(const Vector<3> &middle) const;

    bool
    is_exact() const
    {
      return kind != ExperimentKind::cube_near_magnet;
    }

    /** Of a state found at the place that was not moved. */
    StateErrors
    errors(const MagneticState &state) const;

    /** The same against a finer run of a cube: moments go by volume, forces by area. */
    StateErrors
    errors(const MagneticState &state,
           const Experiment &finer,
           const MagneticState &reference) const;

    const ExperimentKind kind;
    const int resolution;
    const double spacing; ///< dx [m]
    const double radius;  ///< R, or half the edge [m]
    const MagnetizationLaw law;
    const MagneticContent content;
    double volume;         ///< of the body [m^3]
    Vector<3> exact_field; ///< H in the sphere in the uniform field, else zero [A/m]

  private:
    const Medium medium;
    Vector<3> shift;                     ///< of the centre from a node [m]
    std::vector<Vector<3>> local_points; ///< from the centre

    static Vector<3>
    travel_direction();
  };
} // namespace magmpm::benchmarks
