#include <magmpm/coupling/density_relaxation.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/quantity_transfer.h>

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

    constexpr auto fluids = [](const auto &body) { return as_fluid(body) != nullptr; };

    /** What a particle has around it. */
    struct Surroundings
    {
      double fraction;   ///< of fluid, in the part of its B-splines that is inside of the walls
      bool near_surface; ///< of which one is free

      /** @param lanes  NodeFluid, interpolated to the particle. */
      explicit Surroundings(const NodeLanes &lanes)
      {
        const double inside = lanes[NodeFluid::inside.lane];
        fraction            = (inside > 0. ? lanes[NodeFluid::fraction.lane] / inside : 0.);
        near_surface        = lanes[NodeFluid::near_surface.lane] > 0. || inside == 0.;
      }
    };
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
  NodeField<dim, NodeFluid>
  fluid_on_nodes(const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 const OpenFaces<dim> &open,
                 const NodeField<dim, SingleScalar> &volume_fraction)
  {
    NodeField<dim, NodeFluid> field(blocks.size());
    for_nodes_and_ghosts(blocks, [&](const int slot, const int n) {
      const double share =
        share_inside<dim>(lattice, open, node_of_block<dim>(blocks.block(slot), n));
      const double volume   = volume_fraction.get(SingleScalar::value, slot, n);
      const double fraction = (share > 0. ? volume / share : 0.);
      field.set(NodeFluid::fraction, slot, n, fraction);
      field.set(NodeFluid::inside, slot, n, share > 0.);
      field.set(NodeFluid::near_surface, slot, n, share > 0. && fraction < least_fraction);
    });
    return field;
  }

  template <int dim>
  DensityError
  relax_volume_ratios(const NodeField<dim, NodeFluid> &field,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      const double time,
                      std::vector<Body<dim>> &bodies)
  {
    DensityError error;
    gather(
      field,
      blocks,
      lattice,
      fluids,
      [&](Body<dim> &body) {
        const double tau = relaxation_time * lattice.spacing / as_fluid(body)->wave_speed(1.);
        const double way = 1. - std::exp(-time / tau);
        double *ratio    = body.particles.component(ParticleProperty::deformation, 0);
        return [&error, way, ratio](const std::size_t p, const NodeLanes &lanes) {
          const Surroundings around(lanes);
          if (around.near_surface && around.fraction >= spray_fraction)
            return;
          const double target = (around.near_surface ? 1. : 1. / around.fraction);
          if (!around.near_surface)
            {
              error.sum += std::abs(target - ratio[p]);
              error.n_particles += 1.;
            }
          ratio[p] += way * (target - ratio[p]);
        };
      },
      bodies);
    return error;
  }

#define INSTANTIATE(dim)                                                                   \
  template bool has_fluid(const std::vector<Body<dim>> &);                                 \
  template MaterialSelection undeformed_fluids(const std::vector<Body<dim>> &);            \
  template NodeField<dim, NodeFluid> fluid_on_nodes(const BlockSet<dim> &,                 \
                                                    const Lattice<dim> &,                  \
                                                    const OpenFaces<dim> &,                \
                                                    const NodeField<dim, SingleScalar> &); \
  template DensityError relax_volume_ratios(const NodeField<dim, NodeFluid> &,             \
                                            const BlockSet<dim> &,                         \
                                            const Lattice<dim> &,                          \
                                            double,                                        \
                                            std::vector<Body<dim>> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
