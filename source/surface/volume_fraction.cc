#include <magmpm/lattice/arena.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/particles/particle_quantities.h>
#include <magmpm/surface/volume_fraction.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Adds a volume, over that of a cell, to the nodes around a particle of a block. */
    template <int dim>
    void
    add_volume(const Lattice<dim> &lattice,
               const Index<dim> &block,
               const Vector<dim> &position,
               const double volume,
               Arena<dim> &arena)
    {
      const Index<dim> first = Arena<dim>::first_node(block);
      for_stencil(lattice, position, [&](const Index<dim> &node, const double weight) {
        int place = 0;
        for (int d = 0; d < dim; ++d)
          place += (node[d] - first[d]) * Arena<dim>::stride(d);
        arena.data()[place] += weight * volume;
      });
    }
  } // namespace

  template <int dim>
  void
  scatter_volume(const std::vector<Body<dim>> &bodies,
                 const MaterialSelection &selection,
                 const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 NodeField<dim, SingleScalar> &field)
  {
    const double per_cell = 1. / std::pow(lattice.spacing, dim);
    Arena<dim> arena;
    field.set_zero();
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (int slot = 0; slot < blocks.n_owned() && selection.bodies[b]; ++slot)
        {
          const Body<dim> &body = bodies[b];
          if (body.run_begin[slot] == body.run_begin[slot + 1])
            continue;
          arena.set_zero();
          const double *volume = body.particles.component(ParticleProperty::volume, 0);
          for (std::size_t p = body.run_begin[slot]; p < body.run_begin[slot + 1]; ++p)
            add_volume<dim>(lattice,
                            blocks.block(slot),
                            body.particles.position(p),
                            per_cell * volume[p] * particle_volume_ratio(body, p),
                            arena);
          arena.add_to(field, blocks, slot);
        }
  }

  template <int dim>
  NodeField<dim, SingleScalar>
  volume_fraction(const std::vector<Body<dim>> &bodies,
                  const MaterialSelection &selection,
                  const BlockPartition<dim> &partition,
                  const Lattice<dim> &lattice)
  {
    NodeField<dim, SingleScalar> field(partition.blocks().size());
    scatter_volume(bodies, selection, partition.blocks(), lattice, field);
    partition.add_ghosts_to_owners(field);
    partition.update_ghosts(field);
    return field;
  }

#define MAGMPM_INSTANTIATE(dim)                                                         \
  template void scatter_volume(const std::vector<Body<dim>> &,                          \
                               const MaterialSelection &,                               \
                               const BlockSet<dim> &,                                   \
                               const Lattice<dim> &,                                    \
                               NodeField<dim, SingleScalar> &);                         \
  template NodeField<dim, SingleScalar> volume_fraction(const std::vector<Body<dim>> &, \
                                                        const MaterialSelection &,      \
                                                        const BlockPartition<dim> &,    \
                                                        const Lattice<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
