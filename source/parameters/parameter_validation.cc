#include <magmpm/base/number_text.h>
#include <magmpm/mesh/potential_box.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/parameter_validation.h>
#include <magmpm/parameters/rigid_body_section.h>
#include <magmpm/parameters/section_validation.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /** Block coordinates are packed into 21 bits each. */
    constexpr double max_cells = 1e6;

    /** Cells along an edge of the box, or an error with good values near it. */
    template <int dim>
    int
    cells_along(const ParameterRegister &declarations,
                const ParameterInput<dim> &input,
                const int d)
    {
      const double edge = input.upper_corner[d] - input.lower_corner[d];
      const std::string axis(1, axis_names[d]);
      if (!(edge > 0.))
        throw declarations.error("Box/Upper corner",
                                 "along " + axis + " it must lie above Box/Lower corner (" +
                                   to_text(input.lower_corner[d]) + " m).");

      const double cells = edge / input.cell_size;
      if (cells > max_cells)
        throw declarations.error("Box/Cell size",
                                 "that makes " + to_text(cells) + " cells along " + axis +
                                   "; at most 1e6 are possible. Choose larger cells.");

      const double blocks = std::round(cells / block_edge);
      if (blocks >= 1. && std::abs(cells - block_edge * blocks) < 1e-6 * cells)
        return block_edge * static_cast<int>(blocks);

      const double above = std::ceil(cells / block_edge), below = above - 1.;
      const double nearest    = std::max(1., blocks);
      const double block_size = block_edge * input.cell_size;
      std::ostringstream advice;
      advice.precision(9);
      advice << "the edge along " << axis << " is " << to_text(cells)
             << " cells, but must be a multiple of 4 cells. Good values near: upper corner at "
             << axis << " = ";
      if (below >= 1.)
        advice << input.lower_corner[d] + below * block_size << " or ";
      advice << input.lower_corner[d] + above * block_size
             << " m, or Cell size = " << edge / (block_edge * nearest) << " m ("
             << block_edge * nearest << " cells).";
      throw declarations.error("Box/Upper corner", advice.str());
    }

    template <int dim>
    void
    check_box(const ParameterRegister &declarations,
              const ParameterInput<dim> &input,
              Lattice<dim> &lattice)
    {
      lattice.lower_corner = input.lower_corner;
      lattice.spacing      = input.cell_size;
      for (int d = 0; d < dim; ++d)
        lattice.n_cells[d] = cells_along(declarations, input, d);
    }

    /** Blocks have coordinates within +-2^20 (block_key()); some lie around the box. */
    template <int dim>
    void
    check_potential_box(const ParameterRegister &declarations, const Parameters<dim> &parameters)
    {
      constexpr double max_blocks = (1 << 20) - 4096;
      const auto check            = [&](const int d, const double n_blocks) {
        if (n_blocks > max_blocks)
          throw declarations.error("Magnetics/Potential box factor",
                                   "that makes " + to_text(block_edge * n_blocks) +
                                     " cells along " + axis_names[d] + "; at most " +
                                     to_text(block_edge * max_blocks) +
                                     " are possible. Choose a smaller factor, or larger cells.");
      };
      if (!parameters.mesh.carries_potential)
        return;
      for (int d = 0; d < dim; ++d)
        check(d, parameters.mesh.potential_box_factor * parameters.lattice.n_cells[d] / block_edge);
      const PotentialBox<dim> box = potential_box(parameters.lattice, parameters.mesh);
      for (int d = 0; d < dim; ++d)
        check(d, box.n_blocks()[d]);
    }

    template <int dim>
    void
    check_times(const ParameterRegister &declarations, const Parameters<dim> &parameters)
    {
      const TimeStepParameters &step = parameters.time_step;
      if (step.fixed_step > 0.)
        check_given(declarations, "Time step", {}, {"Maximum"}, "a given Time step/Time step");
      if (step.fixed_step > parameters.output.frame_interval)
        throw declarations.error("Time step/Time step",
                                 "it must not be longer than Output/Frame interval (" +
                                   to_text(parameters.output.frame_interval) + " s).");
    }

    template <int dim>
    void
    convert_checkpoint(const ParameterRegister &declarations,
                       const ParameterInput<dim> &input,
                       CheckpointParameters &checkpoint)
    {
      const std::regex frames("([1-9][0-9]{0,8}) frames?");
      std::smatch number;
      if (const auto seconds = seconds_from(input.checkpoint_every))
        checkpoint.wall_interval = *seconds;
      else if (std::regex_match(input.checkpoint_every, number, frames))
        checkpoint.every_n_frames = std::stoi(number[1]);
      else if (input.checkpoint_every != "never")
        throw declarations.error(
          "Checkpoint every",
          "must be a wall time (90 s, 10 min, 2 h), a number of frames (20 frames), "
          "or never.");

      if (const auto seconds = seconds_from(input.end_wall_time))
        checkpoint.end_wall_time = *seconds;
      else if (input.end_wall_time != "never")
        throw declarations.error("End wall time",
                                 "must be a wall time (90 s, 10 min, 11.5 h) or never.");
    }

    /** What is allowed but probably not meant. */
    template <int dim>
    void
    collect_warnings(const ParameterRegister &declarations, Parameters<dim> &parameters)
    {
      const bool magnetic                      = parameters.mesh.carries_potential;
      const std::vector<std::string> &left_out = declarations.warnings();
      parameters.warnings.insert(parameters.warnings.begin(), left_out.begin(), left_out.end());
      if (magnetic && parameters.sources.empty())
        parameters.warnings.push_back(
          declarations.where("Magnets/List of magnets") +
          " is empty: there are magnetic bodies, but nothing magnetizes "
          "them.");
      const bool any_is_free = std::any_of(parameters.magnet_bodies.begin(),
                                           parameters.magnet_bodies.end(),
                                           [](const auto &magnet) { return magnet.is_free; });
      if (!magnetic && !parameters.sources.empty() && !any_is_free)
        parameters.warnings.push_back(declarations.where("Magnets/List of magnets") +
                                      " is not empty, but no body is magnetic: no magnet pulls.");
      for (const MaterialParameters &material : parameters.materials)
        if (std::none_of(parameters.bodies.begin(),
                         parameters.bodies.end(),
                         [&](const BodyParameters<dim> &body) {
                           return body.material == material.name;
                         }))
          parameters.warnings.push_back(declarations.where("Materials/List of materials") +
                                        ": no body is made of '" + material.name + "'.");
    }
  } // namespace

  template <int dim>
  void
  validate(const ParameterRegister &declarations,
           const ParameterInput<dim> &input,
           Parameters<dim> &parameters)
  {
    check_box(declarations, input, parameters.lattice);
    convert_magnetization_curve(declarations, input, parameters.magnetics);
    convert_materials(declarations, input, parameters);
    const auto body_shapes = check_bodies(declarations, input, parameters);
    check_magnets(declarations, input.magnet_names, input.magnets, body_shapes, parameters);
    check_rigid_bodies(declarations, input.rigid_body_motions, body_shapes, parameters);
    check_times(declarations, parameters);
    convert_checkpoint(declarations, input, parameters.checkpoint);

    parameters.magnetics.shielded = parameters.mesh.shielded;
    parameters.mesh.carries_potential =
      std::any_of(parameters.bodies.begin(), parameters.bodies.end(), [&](const auto &body) {
        return parameters.material_of(body).magnetic.is_magnetic();
      });
    check_potential_box(declarations, parameters);
    convert_attraction(declarations, input, parameters);
    check_rest(declarations, parameters);
    collect_warnings(declarations, parameters);
  }

  template void
  validate(const ParameterRegister &, const ParameterInput<2> &, Parameters<2> &);
  template void
  validate(const ParameterRegister &, const ParameterInput<3> &, Parameters<3> &);
} // namespace magmpm
