#include "catch.h"
#include "mesh/scattered_blocks.h"

#include <magmpm/lattice/node_window.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/particle_quantities.h>
#include <magmpm/surface/material_fields.h>

#include <verification/particles/random_bodies.h>

using namespace magmpm;
using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  constexpr int n_blocks = 6; ///< of the box, along each axis

  /** A solid and a fluid that share blocks, on any number of ranks. */
  template <int dim>
  struct Particles
  {
    Particles()
      : lattice(lattice_of_blocks<dim>(uniform_index<dim>(n_blocks)))
      , mesh(MPI_COMM_WORLD, lattice, MeshParameters<dim>())
      , partition(mesh)
    {
      Random random(dim);
      bodies.push_back(empty_body<dim>(MechanicalLaw::neo_hookean, true, "solid"));
      bodies.push_back(empty_body<dim>(MechanicalLaw::viscoelastic_fluid, false, "fluid"));
      add_random_particles(lattice, 5., 14., 300, random, bodies[0]);
      add_random_particles(lattice, 9., 18., 300, random, bodies[1]);

      const auto blocks = box_of_blocks<dim>(uniform_index<dim>(1),
                                             uniform_index<dim>(n_blocks - 1));
      const auto share  = dealt_out<dim>(blocks);
      mesh.adapt(share, std::vector<unsigned int>(share.size(), 1));
      partition.rebuild(owned_of<dim>(blocks, mesh));
      keep_own_particles();
      sort_all(partition.blocks(), lattice, bodies);
    }

    /** Of all ranks. */
    double
    volume_on_nodes(const NodeField<dim, SingleScalar> &fraction) const
    {
      double volume = 0.;
      for_nodes(partition.blocks(), [&](const int slot, const int node) {
        volume += fraction.get(SingleScalar::value, slot, node) * std::pow(lattice.spacing, dim);
      });
      return parallel::sum(volume, MPI_COMM_WORLD);
    }

    const Lattice<dim> lattice;
    BackgroundMesh<dim> mesh;
    BlockPartition<dim> partition;
    std::vector<Body<dim>> bodies;

  private:
    /** All ranks made the same ones. */
    void
    keep_own_particles()
    {
      for (Body<dim> &body : bodies)
        {
          std::vector<std::uint32_t> mine, others;
          for (std::uint32_t p = 0; p < body.particles.size(); ++p)
            {
              const int slot = partition.blocks().slot(
                block_of<dim>(lattice.base_node(body.particles.position(p))));
              const bool is_mine = slot != invalid_slot && slot < partition.blocks().n_owned();
              (is_mine ? mine : others).push_back(p);
            }
          const std::size_t n_mine = mine.size();
          mine.insert(mine.end(), others.begin(), others.end());
          body.particles.reorder(mine);
          body.particles.resize(n_mine);
        }
    }
  };
} // namespace

// The B-splines of a particle sum to one, so the nodes hold the volume of the particles: of the selected
// bodies, as deformed, each counted once whatever the number of ranks. A node has its value on
// every rank that sees it, so that another exchange of ghosts changes nothing.
TEMPLATE_TEST_CASE_SIG("The lattice is as full as the selected particles are large",
                       "[surface][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const Particles<dim> particles;
  for (const int selected : {0, 1, 2})
    {
      const auto selection = select_bodies(particles.bodies, [selected](const Body<dim> &body) {
        return selected == 2 || (body.name == "fluid") == (selected == 1);
      });
      double volume        = 0.;
      for (std::size_t b = 0; b < 2; ++b)
        for (std::size_t p = 0; p < particles.bodies[b].particles.size(); ++p)
          if (selection.bodies[b])
            {
              const Body<dim> &body = particles.bodies[b];
              volume += body.particles.component(ParticleProperty::volume, 0)[p] *
                        particle_volume_ratio(body, p);
            }
      const NodeField<dim, SingleScalar> fraction =
        volume_fraction(particles.bodies, selection, particles.partition, particles.lattice);
      CHECK(particles.volume_on_nodes(fraction) ==
            Approx(parallel::sum(volume, MPI_COMM_WORLD)).epsilon(1e-12));

      NodeField<dim, SingleScalar> again(fraction);
      particles.partition.update_ghosts(again);
      double change = 0.;
      for_nodes_and_ghosts(particles.partition.blocks(), [&](const int slot, const int node) {
        change = std::max(change,
                          std::abs(again.get(SingleScalar::value, slot, node) -
                                   fraction.get(SingleScalar::value, slot, node)));
      });
      CHECK(parallel::max(change, MPI_COMM_WORLD) == 0.);
    }
}

// Who asks for a field that somebody asked for before gets the same one, without another P2G: a change of
// the particles does not show until the fields are forgotten.
TEST_CASE("A field of material is found once and kept until particles move", "[surface]")
{
  Particles<2> particles;
  MaterialFields<2> fields(particles.partition, particles.lattice, particles.bodies);
  const auto solid = select_body(particles.bodies, 0), fluid = select_body(particles.bodies, 1);
  const NodeField<2, SingleScalar> &first = fields.volume_fraction(solid);
  const double volume                     = particles.volume_on_nodes(first);
  const double of_fluid = particles.volume_on_nodes(fields.volume_fraction(fluid));

  ParticleSet<2> &changed = particles.bodies[0].particles;
  for (std::size_t p = 0; p < changed.size(); ++p)
    changed.component(ParticleProperty::volume, 0)[p] *= 3.;
  CHECK(&fields.volume_fraction(solid) == &first);
  CHECK(particles.volume_on_nodes(fields.volume_fraction(solid)) == volume);

  fields.forget();
  CHECK(particles.volume_on_nodes(fields.volume_fraction(solid)) == Approx(3. * volume));
  CHECK(particles.volume_on_nodes(fields.volume_fraction(fluid)) == of_fluid);
}
