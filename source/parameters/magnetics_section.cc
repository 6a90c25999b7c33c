#include <magmpm/mesh/potential_box.h>
#include <magmpm/parameters/face_names.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/input_file.h>
#include <magmpm/parameters/magnetics_section.h>
#include <magmpm/parameters/magnetization_curve_file.h>

#include <fstream>

namespace magmpm
{
  namespace
  {
    template <int dim>
    void
    declare_potential_mesh(ParameterRegister &declarations, MeshParameters<dim> &mesh)
    {
      declarations.add("Potential cell size",
                       mesh.cell_edge,
                       {{"2 dx", 2}, {"dx", 1}},
                       "Edge of the cells of the potential where material is. dx takes eight times "
                       "the unknowns there (four times in 2D) and is more accurate at "
                       "susceptibilities of 10 and more and in gaps under 6 dx.");
      declarations.add(
        "Potential box factor",
        mesh.potential_box_factor,
        "-",
        "Edge of the box of the potential over that of the mechanical box, at least, "
        "where its faces are open.",
        at_least_one);
      declarations.add(
        "Potential band width",
        mesh.band_width,
        "-",
        "Blocks (of 4 cells) around those next to particles, now or soon, where the "
        "mesh is fine too: a wider band costs unknowns and saves changes of the mesh.",
        {0., 1000.});
      const auto section = declarations.enter("Potential box");
      for (std::size_t face = 0; face < face_names.size(); ++face)
        if (face < mesh.shielded.size())
          declarations.add(face_names[face],
                           mesh.shielded[face],
                           {{"open", false}, {"shielded", true}},
                           "Free space beyond this face, or a shield (mirror) at the wall.");
        else
          declarations.refuse(face_names[face], "this face needs Dimension = 3.");
    }

    void
    declare_solve_trigger(ParameterRegister &declarations, SolveTriggerParameters &trigger)
    {
      const auto section = declarations.enter("Solve");
      declarations.add("When",
                       trigger.trigger,
                       {{"changed", SolveTriggerParameters::Trigger::when_changed},
                        {"every step", SolveTriggerParameters::Trigger::every_step},
                        {"every n steps", SolveTriggerParameters::Trigger::every_n_steps}},
                       "When the potential is solved again.");
      declarations.add("Moved fraction",
                       trigger.moved_fraction,
                       "-",
                       "With When = changed: after material moved by this fraction of dx.",
                       not_negative);
      declarations.add("Changed fraction",
                       trigger.changed_fraction,
                       "-",
                       "With When = changed: after the external field changed by this fraction.",
                       not_negative);
      declarations.add(
        "Force tolerance",
        trigger.force_tolerance,
        "-",
        "With When = changed: after less than these fractions where force, torque or "
        "virial carried since a solve differed by more than this part from the next one.",
        positive);
      declarations.add("Steps", trigger.n_steps, "-", "With When = every n steps: n.", {1., 1e9});
    }
  } // namespace

  template <int dim>
  void
  declare_magnetics(ParameterRegister &declarations,
                    double &temperature,
                    MagneticsParameters<dim> &magnetics,
                    MeshParameters<dim> &mesh,
                    SolveTriggerParameters &solve_trigger)
  {
    const auto section = declarations.enter("Magnetics");
    declarations.add("Magnetization law",
                     magnetics.law,
                     {{"Langevin", MagnetizationLaw::langevin},
                      {"linear", MagnetizationLaw::linear},
                      {"table", MagnetizationLaw::table}},
                     "How all magnetic materials of the scene answer to the field.");
    declarations.add_text(
      "Magnetization curve",
      "",
      "A/m",
      "With Magnetization law = table: a file of lines 'H, M' [A/m], in the folder "
      "of the parameter file, H rising, M not falling.");
    declarations.add("Temperature",
                     temperature,
                     "K",
                     "Of the grains; it relates their moment and number density to M_s and chi_0.",
                     {1., 1e4});
    declarations.add(
      "Material indicator",
      magnetics.indicator,
      {{"sharp", MaterialIndicator::sharp}, {"smeared", MaterialIndicator::smeared}},
      "Where material is: with a sharp surface that the particles tell, or as far as "
      "their B-splines reach, as in the paper (first order only, to compare).");
    declarations.add(
      "Preconditioner",
      magnetics.solver.preconditioner,
      {{"GMG", Preconditioner::gmg}, {"ML", Preconditioner::ml}, {"MueLu", Preconditioner::muelu}},
      "Of the linear solver: geometric multigrid without a matrix, or algebraic multigrid on the "
      "assembled matrix, by Trilinos ML or MueLu (on the GPU, where Trilinos was built for it).");
    declarations.add("Newton tolerance",
                     magnetics.solver.newton_tolerance,
                     "-",
                     "Residual at which Newton stops, relative to that of zero potential.",
                     {1e-15, 1., false, true});
    declarations.add("Maximum Newton steps",
                     magnetics.solver.max_newton_steps,
                     "-",
                     "More than these fail the run.",
                     {1., 1000.});
    declarations.add("Maximum CG iterations",
                     magnetics.solver.max_cg_iterations,
                     "-",
                     "In one Newton step; more than these fail the run.",
                     {1., 1e6});
    declare_potential_mesh(declarations, mesh);
    declare_solve_trigger(declarations, solve_trigger);
  }

  template <int dim>
  void
  convert_magnetization_curve(const ParameterRegister &declarations,
                              MagneticsParameters<dim> &magnetics)
  {
    const std::vector<std::string> curve = {"Magnetization curve"};
    if (magnetics.law != MagnetizationLaw::table)
      return check_given(
        declarations, "Magnetics", {}, curve, "this law (Magnetization law is not table)");
    check_given(declarations, "Magnetics", curve, {}, "Magnetization law = table");
    const std::string name = find_input_file(declarations,
                                             "Magnetics/Magnetization curve",
                                             declarations.value("Magnetics/Magnetization curve"));
    std::ifstream file(name);
    if (!file)
      throw declarations.error("Magnetics/Magnetization curve",
                               "this file cannot be opened; are you allowed to read it?");
    magnetics.curve =
      std::make_shared<const MagnetizationCurve>(read_magnetization_curve(file, name));
  }

  template <int dim>
  void
  check_potential_box(const ParameterRegister &declarations,
                      const Lattice<dim> &lattice,
                      const MeshParameters<dim> &mesh)
  {
    constexpr double max_blocks = (1 << 20) - 4096;
    const auto check            = [&](const int d, const double n_blocks) {
      if (n_blocks > max_blocks)
        throw declarations.error("Magnetics/Potential box factor",
                                 "that makes " + to_text(block_edge * n_blocks) + " cells along " +
                                   axis_names[d] + "; at most " + to_text(block_edge * max_blocks) +
                                   " are possible. Choose a smaller factor, or larger cells.");
    };
    if (!mesh.carries_potential)
      return;
    for (int d = 0; d < dim; ++d)
      check(d, mesh.potential_box_factor * lattice.n_cells[d] / block_edge);
    const PotentialBox<dim> box = potential_box(lattice, mesh);
    for (int d = 0; d < dim; ++d)
      check(d, box.n_blocks()[d]);
  }

#define INSTANTIATE(dim)                                                           \
  template void check_potential_box(                                               \
    const ParameterRegister &, const Lattice<dim> &, const MeshParameters<dim> &); \
  template void declare_magnetics(ParameterRegister &,                             \
                                  double &,                                        \
                                  MagneticsParameters<dim> &,                      \
                                  MeshParameters<dim> &,                           \
                                  SolveTriggerParameters &);                       \
  template void convert_magnetization_curve(const ParameterRegister &, MagneticsParameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
