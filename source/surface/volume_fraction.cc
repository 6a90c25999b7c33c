#include <magmpm/parallel/reduce.h>

#include <magmpm/lattice/arena.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/particles/particle_quantities.h>
#include <magmpm/surface/volume_fraction.h>

#include <algorithm>
#include <limits>

namespace magmpm
{
  namespace
  {
    /** Sets first and count so that the nodes of all particles, and one more, lie in the box. */
    template <int dim>
    void
    set_box(const Body<dim> &body,
            const Lattice<dim> &lattice,
            const MPI_Comm communicator,
            VolumeFraction<dim> &fraction)
    {
      // Lower corners, and upper ones with the sign changed, so that one minimum does for both.
      std::vector<int> corners(2 * dim, std::numeric_limits<int>::max());
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        {
          const Index<dim> base = lattice.base_node(body.particles.position(p));
          for (int d = 0; d < dim; ++d)
            {
              corners[d]       = std::min(corners[d], base[d] - 1);
              corners[dim + d] = std::min(corners[dim + d], -(base[d] + stencil_width));
            }
        }
      corners = parallel::min(corners, communicator);
      if (corners[0] == std::numeric_limits<int>::max())
        return;
      for (int d = 0; d < dim; ++d)
        {
          fraction.first[d] = corners[d];
          fraction.count[d] = -corners[dim + d] - corners[d] + 1;
        }
    }

    /** The place in VolumeFraction::values of a node. */
    template <int dim>
    std::size_t
    place_of(const VolumeFraction<dim> &fraction, const Index<dim> &node)
    {
      std::size_t place = 0;
      for (int d = dim - 1; d >= 0; --d)
        place = place * fraction.count[d] + (node[d] - fraction.first[d]);
      return place;
    }
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
    const bool deforms    = selection.volume == ParticleVolume::deformed;
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
                            per_cell * volume[p] * (deforms ? particle_volume_ratio(body, p) : 1.),
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

  template <int dim>
  VolumeFraction<dim>
  volume_fraction(const Body<dim> &body, const Lattice<dim> &lattice, const MPI_Comm communicator)
  {
    VolumeFraction<dim> fraction;
    set_box(body, lattice, communicator, fraction);
    std::size_t n_nodes = 1;
    for (int d = 0; d < dim; ++d)
      n_nodes *= fraction.count[d];
    fraction.values.assign(n_nodes, 0.);

    const double cell_volume = std::pow(lattice.spacing, dim);
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      {
        const double part = particle_volume_ratio(body, p) *
                            body.particles.component(ParticleProperty::volume, 0)[p] / cell_volume;
        for_stencil(
          lattice, body.particles.position(p), [&](const Index<dim> &node, const double weight) {
            fraction.values[place_of<dim>(fraction, node)] += part * weight;
          });
      }

    const bool is_first = parallel::rank(communicator) == 0;
    MPI_Reduce(is_first ? MPI_IN_PLACE : fraction.values.data(),
               fraction.values.data(),
               static_cast<int>(n_nodes),
               MPI_DOUBLE,
               MPI_SUM,
               0,
               communicator);
    return fraction;
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
                                                        const Lattice<dim> &);          \
  template VolumeFraction<dim> volume_fraction(const Body<dim> &, const Lattice<dim> &, MPI_Comm);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
