#include <magmpm/magnetics/field_quantities.h>
#include <magmpm/parameters/output_section.h>
#include <magmpm/particles/particle_quantities.h>

namespace magmpm
{
  void
  declare_output(ParameterRegister &declarations, OutputParameters &output)
  {
    const auto section         = declarations.enter("Output");
    output.frame_interval      = 2e-3;
    output.particle_quantities = names_of(particle_quantities<3>());
    output.field_quantities    = names_of(field_quantities<3>());
    declarations.add(
      "Frame interval", output.frame_interval, "s", "Simulated time between two frames.", positive);
    declarations.add("Particles", output.write_particles, "Whether particles are written.");
    declarations.add("Fields", output.write_fields, "Whether magnetic fields are written.");
    declarations.add("Rigid bodies",
                     output.write_rigid_bodies,
                     "Whether the surfaces of magnets and rigid bodies are written.");
    declarations.add("Surface",
                     output.write_surface,
                     "Whether a surface around the particles of each body is written.");
    declarations.add("Particle quantities",
                     output.particle_quantities,
                     std::vector<std::string>(output.particle_quantities),
                     "What is written of the particles.");
    declarations.add("Field quantities",
                     output.field_quantities,
                     std::vector<std::string>(output.field_quantities),
                     "What is written of the fields.");
    declarations.add("Statistics every",
                     output.statistics_every,
                     "steps",
                     "Steps from one row of statistics.csv to the next.",
                     {1., 1e9});
  }
} // namespace magmpm
