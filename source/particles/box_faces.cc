#include <magmpm/particles/box_faces.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr int nowhere = -1;

    /** Where particles of a body may be. */
    template <int dim>
    struct Confines
    {
      Vector<dim> lower, upper; ///< [m]

      Confines(const Lattice<dim> &lattice, const OpenFaces<dim> &open, const Body<dim> &body)
        : lower(lattice.lower_corner)
        , upper(lattice.upper_corner())
      {
        if (body.particles.n_components(ParticleProperty::half_extent) == 0)
          return;
        const double depth = tolerated_depth_of_solids * lattice.spacing;
        for (int d = 0; d < dim; ++d)
          {
            lower[d] -= open[2 * d] ? 0. : depth;
            upper[d] += open[2 * d + 1] ? 0. : depth;
          }
      }

      /** The face that a point lies beyond, or nowhere. */
      int
      face_before(const Vector<dim> &position) const
      {
        for (int d = 0; d < dim; ++d)
          {
            if (position[d] < lower[d])
              return 2 * d;
            if (!(position[d] <= upper[d]))
              return 2 * d + 1;
          }
        return nowhere;
      }
    };

    /** Whether particles of a block can reach a face before they are sorted again. */
    template <int dim>
    bool
    is_next_to_face(const Lattice<dim> &lattice, const Index<dim> &block)
    {
      for (int d = 0; d < dim; ++d)
        if (block[d] <= 0 || block[d] >= lattice.n_cells[d] / block_edge - 1)
          return true;
      return false;
    }
  } // namespace

  template <int dim>
  std::size_t
  hold_at_walls(const BlockSet<dim> &blocks,
                const Lattice<dim> &lattice,
                const OpenFaces<dim> &open,
                Body<dim> &body)
  {
    const ParticleArrays<dim> particles = body.particles.arrays();
    const Confines<dim> confines(lattice, open, body);
    std::size_t n_held = 0;
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      if (is_next_to_face<dim>(lattice, blocks.block(slot)))
        for (std::size_t p = body.run_begin[slot]; p < body.run_begin[slot + 1]; ++p)
          {
            bool held = false;
            for (int d = 0; d < dim; ++d)
              {
                double &x = particles.position[d][p], &v = particles.velocity[d][p];
                if (x < confines.lower[d] && !open[2 * d])
                  {
                    x    = confines.lower[d];
                    v    = std::max(v, 0.);
                    held = true;
                  }
                else if (x > confines.upper[d] && !open[2 * d + 1])
                  {
                    x    = confines.upper[d];
                    v    = std::min(v, 0.);
                    held = true;
                  }
              }
            n_held += held;
          }
    return n_held;
  }

  template <int dim>
  std::vector<Departure<dim>>
  remove_departed(const Lattice<dim> &lattice, const OpenFaces<dim> &open, Body<dim> &body)
  {
    const Confines<dim> confines(lattice, open, body);
    const std::size_t n_particles = body.particles.size();
    std::vector<Departure<dim>> departed;
    std::vector<std::uint32_t> kept;
    kept.reserve(n_particles);
    for (std::size_t p = 0; p < n_particles; ++p)
      {
        const Vector<dim> position = body.particles.position(p);
        const int face             = confines.face_before(position);
        if (face == nowhere)
          kept.push_back(static_cast<std::uint32_t>(p));
        else
          departed.push_back({body.particles.ids()[p],
                              face,
                              position,
                              body.particles.vector(ParticleProperty::velocity, p)});
      }
    if (!departed.empty())
      body.particles.reorder(kept);
    return departed;
  }

#define INSTANTIATE(dim)                                                               \
  template std::size_t hold_at_walls(                                                  \
    const BlockSet<dim> &, const Lattice<dim> &, const OpenFaces<dim> &, Body<dim> &); \
  template std::vector<Departure<dim>> remove_departed(                                \
    const Lattice<dim> &, const OpenFaces<dim> &, Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
