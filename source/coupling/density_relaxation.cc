#include <magmpm/coupling/density_relaxation.h>
#include <magmpm/lattice/arena.h>
#include <magmpm/lattice/bspline.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** A node with less fluid around it than this is near a free surface. */
    constexpr double least_fraction = 0.9;

    /** The time in which J follows the lattice, in times of sound across a cell. */
    constexpr double relaxation_time = 3.;

    /** A particle with less fluid around it than this, itself included, is one of a spray. */
    constexpr double spray_fraction = 0.4;

    template <int dim>
    const ViscoelasticFluid<dim> *
    as_fluid(const Body<dim> &body)
    {
      return std::get_if<ViscoelasticFluid<dim>>(&body.material);
    }

    /** Calls f(place in the arena, weight) for the nodes around a particle. */
    template <int dim, typename Function>
    void
    for_each_node(const Lattice<dim> &lattice,
                  const Index<dim> &block,
                  const Vector<dim> &position,
                  const Function &f)
    {
      const Index<dim> first = Arena<dim>::first_node(block), base = lattice.base_node(position);
      const Vector<dim> x = lattice.reduced(position);
      double weights[dim][stencil_width];
      for (int d = 0; d < dim; ++d)
        quadratic_bspline(x[d] - base[d], weights[d]);
      for (int n = 0; n < power(stencil_width, dim); ++n)
        {
          int place     = 0;
          double weight = 1.;
          for (int d = 0, rest = n; d < dim; ++d, rest /= stencil_width)
            {
              const int i = rest % stencil_width;
              place += (base[d] - first[d] + i) * Arena<dim>::stride(d);
              weight *= weights[d][i];
            }
          f(place, weight);
        }
    }

    /** The share of a node's B-spline that lies inside of the walls; 0 for nodes beyond them. */
    template <int dim>
    double
    share_inside(const Lattice<dim> &lattice, const OpenFaces<dim> &open, const Index<dim> &node)
    {
      double share = 1.;
      for (int d = 0; d < dim; ++d)
        for (int side = 0; side < 2; ++side)
          if (!open[2 * d + side])
            {
              const int distance = (side == 0 ? node[d] : lattice.n_cells[d] - node[d]);
              share *= (distance < 0    ? 0.
                        : distance == 0 ? 1. / 2.
                        : distance == 1 ? 47. / 48.
                                        : 1.);
            }
      return share;
    }

    /** What a particle of @p block has around it. */
    struct Surroundings
    {
      double fraction;   ///< of fluid, in the part of its B-splines that is inside of the walls
      bool near_surface; ///< of which one is free
    };

    template <int dim>
    Surroundings
    surroundings(const Lattice<dim> &lattice,
                 const Index<dim> &block,
                 const Vector<dim> &position,
                 const double *arena)
    {
      double fraction = 0., inside = 0., surface = 0.;
      for_each_node<dim>(lattice, block, position, [&](const int place, const double weight) {
        fraction += weight * arena[place];
        inside += weight * arena[place + 1];
        surface += weight * arena[place + 2];
      });
      return {inside > 0. ? fraction / inside : 0., surface > 0. || inside == 0.};
    }
  } // namespace

  template <int dim>
  bool
  has_fluid(const std::vector<Body<dim>> &bodies)
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body<dim> &body) {
      return as_fluid(body) != nullptr;
    });
  }

  template <int dim>
  MaterialSelection
  undeformed_fluids(const std::vector<Body<dim>> &bodies)
  {
    return select_bodies(
      bodies,
      [](const Body<dim> &body) { return as_fluid(body) != nullptr; },
      ParticleVolume::undeformed);
  }

  template <int dim>
  void
  complete_fluid_fraction(const BlockSet<dim> &blocks,
                          const Lattice<dim> &lattice,
                          const OpenFaces<dim> &open,
                          NodeField<dim> &field)
  {
    for (int slot = 0; slot < field.n_blocks(); ++slot)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        {
          double *node = field.node(slot, n);
          const double share =
            share_inside<dim>(lattice, open, node_of_block<dim>(blocks.block(slot), n));
          node[0] = (share > 0. ? node[0] / share : 0.);
          node[1] = (share > 0.);
          node[2] = (share > 0. && node[0] < least_fraction);
        }
  }

  template <int dim>
  DensityError
  relax_volume_ratios(const NodeField<dim> &field,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      const double time,
                      std::vector<Body<dim>> &bodies)
  {
    DensityError error;
    Arena<dim> arena;
    for (Body<dim> &body : bodies)
      if (const ViscoelasticFluid<dim> *fluid = as_fluid(body))
        {
          const double tau = relaxation_time * lattice.spacing / fluid->wave_speed(1.);
          const double way = 1. - std::exp(-time / tau);
          double *ratio    = body.particles.component(ParticleProperty::deformation, 0);
          for (int slot = 0; slot < blocks.n_owned(); ++slot)
            {
              if (body.run_begin[slot] == body.run_begin[slot + 1])
                continue;
              arena.load(field, blocks, slot);
              for (std::size_t p = body.run_begin[slot]; p < body.run_begin[slot + 1]; ++p)
                {
                  const Surroundings around = surroundings<dim>(
                    lattice, blocks.block(slot), body.particles.position(p), arena.data());
                  if (around.near_surface && around.fraction >= spray_fraction)
                    continue;
                  const double target = (around.near_surface ? 1. : 1. / around.fraction);
                  if (!around.near_surface)
                    {
                      error.sum += std::abs(target - ratio[p]);
                      error.n_particles += 1.;
                    }
                  ratio[p] += way * (target - ratio[p]);
                }
            }
        }
    return error;
  }

#define INSTANTIATE(dim)                                                                    \
  template bool has_fluid(const std::vector<Body<dim>> &);                                  \
  template MaterialSelection undeformed_fluids(const std::vector<Body<dim>> &);             \
  template void complete_fluid_fraction(                                                    \
    const BlockSet<dim> &, const Lattice<dim> &, const OpenFaces<dim> &, NodeField<dim> &); \
  template DensityError relax_volume_ratios(const NodeField<dim> &,                         \
                                            const BlockSet<dim> &,                          \
                                            const Lattice<dim> &,                           \
                                            double,                                         \
                                            std::vector<Body<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
