#pragma once

#include <magmpm/boundary/group_contact_parameters.h>
#include <magmpm/boundary/rigid_body_parameters.h>
#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/coupling/body_forces.h>
#include <magmpm/coupling/solve_trigger_parameters.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/magnetics/magnetics_parameters.h>
#include <magmpm/magnets/source_parameters.h>
#include <magmpm/materials/material_parameters.h>
#include <magmpm/mesh/mesh_parameters.h>
#include <magmpm/motion/time_function.h>
#include <magmpm/parameters/parameter_file.h>
#include <magmpm/parameters/run_parameters.h>
#include <magmpm/particles/body_parameters.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * All that a parameter file says of a scene, in SI units, checked and converted: whoever holds this
   * object may rely on every relation that validate() checks. Every room takes its own
   * part of it.
   */
  template <int dim>
  struct Parameters
  {
    Lattice<dim> lattice;              ///< of the mechanical box
    double end_time = 0.;              ///< [s]
    TimeFunction<Vector<dim>> gravity; ///< [m/s^2]

    std::vector<BodyParameters<dim>> bodies;
    std::vector<MaterialParameters> materials;
    std::vector<SourceParameters<dim>> sources;
    std::vector<RigidBodyProperties<dim>> magnet_bodies; ///< of each source, if it is a rigid body
    std::vector<RigidBodyParameters<dim>> rigid_bodies;
    std::vector<GroupContactParameters> contacts;

    BodyForceParameters<dim> forces;
    WallParameters<dim> walls;
    MeshParameters<dim> mesh;
    MagneticsParameters<dim> magnetics;
    TimeStepParameters time_step;
    RestParameters rest;
    SolveTriggerParameters solve_trigger;
    RunawayLimits runaway_limits;
    OutputParameters output;
    CheckpointParameters checkpoint;

    /** What is allowed but probably not meant, to be told to the user. */
    std::vector<std::string> warnings;

    std::string original_text; ///< the file as given, then what --set changed: original.prm
    std::string complete_text; ///< all values, defaults included: parameters.prm

    /** The material of a body. */
    const MaterialParameters &
    material_of(const BodyParameters<dim> &body) const;

    /** The contact groups of the bodies, each once, from the lowest on. */
    std::vector<int>
    contact_groups() const;
  };

  /** Dimension of the scene in @p file: 2 or 3. @throw InputError if it is none of these. */
  int
  read_dimension(const ParameterFile &file);

  /**
   * Reads and checks a scene.
   *
   * @throw InputError  says where and what is wrong, what is allowed, and what to do.
   */
  template <int dim>
  Parameters<dim>
  read_parameters(const ParameterFile &file);

  /**
   * The manual of all parameters in Markdown, with `<body>`, `<material>`, `<magnet>` and so on in place of the
   * names that a scene gives.
   */
  std::string
  parameter_manual();
} // namespace magmpm
