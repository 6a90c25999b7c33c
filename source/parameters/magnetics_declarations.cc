#include <magmpm/parameters/parameter_sections.h>

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
      declarations.add("Steps", trigger.n_steps, "-", "With When = every n steps: n.", {1., 1e9});
    }
  } // namespace

  template <int dim>
  void
  declare_magnetics(ParameterRegister &declarations,
                    ParameterInput<dim> &input,
                    Parameters<dim> &parameters)
  {
    MagneticsParameters<dim> &magnetics = parameters.magnetics;
    const auto section                  = declarations.enter("Magnetics");
    declarations.add("Magnetization law",
                     magnetics.law,
                     {{"Langevin", MagnetizationLaw::langevin},
                      {"linear", MagnetizationLaw::linear},
                      {"table", MagnetizationLaw::table}},
                     "How all magnetic materials of the scene answer to the field.");
    declarations.add("Magnetization curve",
                     input.magnetization_curve,
                     "A/m",
                     "With Magnetization law = table: a file of lines 'H, M' [A/m], in the folder "
                     "of the parameter file, H rising, M not falling.",
                     Presence::optional);
    declarations.add("Temperature",
                     input.temperature,
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
    declare_potential_mesh(declarations, parameters.mesh);
    declare_solve_trigger(declarations, parameters.solve_trigger);
  }

  template void
  declare_magnetics(ParameterRegister &, ParameterInput<2> &, Parameters<2> &);
  template void
  declare_magnetics(ParameterRegister &, ParameterInput<3> &, Parameters<3> &);
} // namespace magmpm
