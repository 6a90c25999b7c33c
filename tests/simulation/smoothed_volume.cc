// Nearly incompressible solids in a scene, on any number of ranks.

#include <magmpm/simulation/scene.h>

#include <magmpm/parameters/parameter_file.h>

#include <verification/particles/random_bodies.h>

#include "../catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  /** Two blocks of one material side by side, and a third of another on them, thrown into a corner. */
  template <int dim>
  Parameters<dim>
  three_blocks()
  {
    const bool is_3d = (dim == 3);
    const auto box   = [is_3d](const std::string &lower, const std::string &upper) {
      return "    set Lower corner = " + lower + (is_3d ? ", 0.1" : "") +
             "\n    set Upper corner = " + upper + (is_3d ? ", 0.4" : "") + "\n";
    };
    const std::string rest = std::string("    set Density = 1000\n    set Velocity = -0.5, -0.3") +
                             (is_3d ? ", 0.2" : "") + "\n  end\n";
    return read_parameters<dim>(parse_parameter_text(
      "set Dimension = " + std::to_string(dim) + "\nset End time = 1\nset Gravity = 0, -1" +
        (is_3d ? ", 0.5" : "") + "\nsubsection Box\n  set Upper corner = 1, 0.75" +
        (is_3d ? ", 0.5" : "") +
        "\n  set Cell size = 0.0625\nend\nsubsection Bodies\n"
        "  set List of bodies = left, right, top\n"
        "  subsection left\n    set Material = rubber\n" +
        box("0, 0.03", "0.34, 0.3") + rest + "  subsection right\n    set Material = rubber\n" +
        box("0.34, 0.03", "0.8, 0.3") + rest + "  subsection top\n    set Material = gel\n" +
        box("0.1, 0.3", "0.6, 0.56") + rest +
        "end\nsubsection Materials\n  set List of materials = rubber, gel\n"
        "  subsection rubber\n    set Young's modulus = 1e5\n    set Poisson ratio = 0.49\n  end\n"
        "  subsection gel\n    set Young's modulus = 2e4\n    set Poisson ratio = 0.495\n  end\n"
        "end\n",
      "blocks.prm"));
  }

  template <int dim>
  ParticleSums<dim>
  after_steps(const int n_steps, const MPI_Comm communicator)
  {
    Scene<dim> scene(three_blocks<dim>(), communicator);
    scene.begin();
    for (int n = 0; n < n_steps; ++n)
      scene.step({1., true, {}});
    return scene.total();
  }
} // namespace

// Each rank alone and all together do the same steps; only the order of sums differs. Particles of one material
// on both sides of a border between ranks share hats, of which the sums and the means travel.
TEMPLATE_TEST_CASE_SIG("Smoothed volumes are the same on any number of ranks",
                       "[simulation][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const ParticleSums<dim> alone    = after_steps<dim>(60, MPI_COMM_SELF);
  const ParticleSums<dim> together = after_steps<dim>(60, MPI_COMM_WORLD);
  CHECK(alone.elastic_energy > 1e-2);
  CHECK(together.elastic_energy == Approx(alone.elastic_energy).epsilon(1e-9));
  CHECK(together.kinetic_energy == Approx(alone.kinetic_energy).epsilon(1e-9));
  CHECK(norm(together.momentum - alone.momentum) < 1e-9 * norm(alone.momentum));
}

// What is smoothed is found anew in every step: a scene that goes on from what another one saved equals it to
// the last bit, in its elastic energy too.
TEMPLATE_TEST_CASE_SIG("Smoothed volumes go on from what was saved",
                       "[simulation][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  Scene<dim> scene(three_blocks<dim>(), MPI_COMM_WORLD), other(three_blocks<dim>(), MPI_COMM_WORLD);
  scene.begin();
  for (int i = 0; i < 20; ++i)
    scene.step();
  const std::vector<Section> sections = scene.save();
  other.load(sections, [&](std::vector<Body<dim>> &bodies) { bodies = scene.bodies(); });
  for (int i = 0; i < 20; ++i)
    for (Scene<dim> *one : {&scene, &other})
      one->step({1., true, {}});
  CHECK(scene.total().elastic_energy > 1e-2);
  CHECK(scene.total().elastic_energy == other.total().elastic_energy);
  CHECK(scene.total().kinetic_energy == other.total().kinetic_energy);
}

// The elastic energy of a row is that of the places and the F of the end of the step, not of what P2G smoothed
// at its start: the same as that of the particles smoothed anew, to the order of sums.
TEMPLATE_TEST_CASE_SIG("Smoothed volumes of a row are those of its particles",
                       "[simulation]",
                       ((int dim), dim),
                       2,
                       3)
{
  Scene<dim> scene(three_blocks<dim>(), MPI_COMM_SELF);
  scene.begin();
  for (int i = 0; i < 30; ++i)
    scene.step({1., true, {}});
  const Lattice<dim> lattice    = three_blocks<dim>().lattice;
  std::vector<Body<dim>> bodies = scene.bodies();
  const BlockSet<dim> blocks    = verification::active_blocks(bodies, lattice);
  verification::sort_all(blocks, lattice, bodies);
  NodeField<dim, NodeStrain> strain(blocks.size());
  for (const SmoothedMaterial &material : smoothed_materials(bodies))
    {
      sum_strain(bodies, material, blocks, lattice, strain);
      divide_by_weight(blocks, strain);
      find_volumetric_stress(strain, material, blocks, lattice, bodies);
    }
  double energy = 0.;
  for (const Body<dim> &body : bodies)
    energy += particle_sums(body, lattice, {}, MagnetizationLaw::linear).elastic_energy;
  CHECK(scene.total().elastic_energy == Approx(energy).epsilon(1e-11));
}
