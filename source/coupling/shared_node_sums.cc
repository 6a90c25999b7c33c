#include <magmpm/coupling/shared_node_sums.h>
#include <magmpm/lattice/arena.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/lattice_node.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/deformed_extent.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace magmpm
{
  namespace
  {
    /**
     * How sharp the mean of the ways is, in dx. Of solids, whose particles lie still beside one another: blunter makes
     * blocks at rest creep, sharper makes balls gain energy. Those of fluids are noise, and the deepest no surface:
     * with 0.2 a block is thrown out of the pool that it floats in.
     */
    constexpr double sharpness_in_solids = 0.1;
    constexpr double sharpness_in_fluids = 0.7;

    /** How far beside a node particles count, so that it has the gap where it is, not the least in its reach. */
    constexpr double width_of_mean = 0.35; // dx

    /** The nodes that particles of a block reach, and which of them are shared. */
    template <int dim>
    class SharedStencils
    {
    public:
      using Window = NodeWindow<dim, 1, block_edge - 1>;

      SharedStencils(const Lattice<dim> &lattice,
                     const BlockSet<dim> &blocks,
                     const int slot,
                     const NodeField<dim, SingleScalar> &shared)
        : blocks(blocks)
        , slot(slot)
        , first_node(Arena<dim>::first_node(blocks.block(slot)))
        , origin(lattice.node_position(first_node))
        , spacing(lattice.spacing)
      {
        for (int i = 0; i < Window::n_nodes; ++i)
          {
            const LatticeNode at = node(i);
            is_shared[i]         = shared.get(SingleScalar::value, at.slot, at.number) != 0.;
            any_is_shared        = any_is_shared || is_shared[i];
          }
      }

      bool
      any() const
      {
        return any_is_shared;
      }

      LatticeNode
      node(const int i) const
      {
        const NodePlace &place = Window::place(i);
        return {blocks.neighbours(slot)[place.neighbour], place.node};
      }

      Vector<dim>
      position(int i) const
      {
        Vector<dim> result = origin;
        for (int d = 0; d < dim; ++d, i /= Window::edge)
          result[d] += spacing * (i % Window::edge);
        return result;
      }

      /** Calls f(number in the window, N_i, grad N_i) for the shared nodes around a position. */
      template <typename Function>
      void
      for_shared(const Vector<dim> &at, const Function &f) const
      {
        int first = 0;
        double weights[dim][stencil_width], slopes[dim][stencil_width];
        for (int d = 0; d < dim; ++d)
          {
            const double x = (at[d] - origin[d]) / spacing;
            const int base = static_cast<int>(x - 0.5);
            first += base * Window::stride(d);
            quadratic_bspline(x - base, weights[d]);
            quadratic_bspline_derivative(x - base, slopes[d]);
          }
        constexpr auto offsets = Window::template box_offsets<stencil_width>();
        for (int i = 0; i < static_cast<int>(offsets.size()); ++i)
          {
            if (!is_shared[first + offsets[i]])
              continue;
            double weight = 1.;
            Vector<dim> gradient;
            for (int d = 0; d < dim; ++d)
              gradient[d] = 1. / spacing;
            for (int d = 0, rest = i; d < dim; ++d, rest /= stencil_width)
              {
                weight *= weights[d][rest % stencil_width];
                for (int e = 0; e < dim; ++e)
                  gradient[e] *= (d == e ? slopes : weights)[d][rest % stencil_width];
              }
            f(first + offsets[i], weight, gradient);
          }
      }

    private:
      const BlockSet<dim> &blocks;
      const int slot;
      const Index<dim> first_node;
      const Vector<dim> origin;
      const double spacing;
      std::array<bool, Window::n_nodes> is_shared;
      bool any_is_shared = false;
    };

    /** Calls f(body, first and last particle, stencils) for the runs of a group's bodies near shared nodes. */
    template <int dim, typename Function>
    void
    for_runs_near(const std::vector<Body<dim>> &bodies,
                  const int group,
                  const BlockSet<dim> &blocks,
                  const Lattice<dim> &lattice,
                  const NodeField<dim, SingleScalar> &shared,
                  const Function &f)
    {
      for (int slot = 0; slot < blocks.n_owned(); ++slot)
        {
          const auto counts = [&](const Body<dim> &body) {
            return is_in_group(body, group) && body.run_begin[slot] < body.run_begin[slot + 1];
          };
          if (std::none_of(bodies.begin(), bodies.end(), counts))
            continue;
          const SharedStencils<dim> stencils(lattice, blocks, slot, shared);
          if (!stencils.any())
            continue;
          for (const Body<dim> &body : bodies)
            if (counts(body))
              f(body, body.run_begin[slot], body.run_begin[slot + 1], stencils);
        }
    }

    /** What a particle of a fluid fills: a cube along the axes, all of whose faces may touch. */
    template <int dim>
    class FluidExtent
    {
    public:
      explicit FluidExtent(const double volume)
        : edge(std::pow(volume, 1. / dim))
      {
      }

      double
      reach(const Vector<dim> &normal) const
      {
        double sum = 0.;
        for (int d = 0; d < dim; ++d)
          sum += std::abs(normal[d]);
        return 0.5 * edge * sum;
      }

      double
      facing(const Vector<dim> & /*normal*/) const
      {
        return std::pow(edge, dim - 1);
      }

    private:
      const double edge; ///< [m]
    };

    /** J of a particle. */
    template <int dim>
    double
    volume_ratio(const Body<dim> &body,
                 const ParticleArrays<dim, const double> &particles,
                 const std::size_t p)
    {
      if (is_fluid(body))
        return particles.deformation[0][p];
      return determinant(load_matrix<dim>(particles.deformation, p));
    }

    /** Where the directions of contact of the shared nodes of a window are kept for its particles. */
    template <int dim>
    using WindowNormals =
      std::array<std::array<Vector<dim>, n_contact_normals>, SharedStencils<dim>::Window::n_nodes>;

    template <int dim>
    void
    find_normals(const SharedStencils<dim> &stencils,
                 const NodeField<dim, SharedNodeMaterial> &material,
                 WindowNormals<dim> &normals)
    {
      for (int i = 0; i < SharedStencils<dim>::Window::n_nodes; ++i)
        {
          const LatticeNode at = stencils.node(i);
          normals[i]           = contact_normals(material_at(material, 0, at.slot, at.number),
                                       material_at(material, 1, at.slot, at.number));
        }
    }

    /** Adds the ways of one particle to the shared nodes around it. @param outward  1 for side 0, -1 for side 1. */
    template <int dim, typename Extent>
    void
    add_ways(const Vector<dim> &position,
             const Extent &extent,
             const int side,
             const double sharpness,
             const double spacing,
             const SharedStencils<dim> &stencils,
             const WindowNormals<dim> &normals,
             NodeField<dim, SharedNodeGaps> &gaps)
    {
      const double outward = (side == 0 ? 1. : -1.);
      stencils.for_shared(position, [&](const int i, const double weight, const Vector<dim> &) {
        const LatticeNode at      = stencils.node(i);
        const Vector<dim> to_node = stencils.position(i) - position;
        for (int k = 0; k < n_contact_normals; ++k)
          {
            const Vector<dim> normal     = outward * normals[i][k];
            const double along           = dot(to_node, normal);
            const double square_of_aside = dot(to_node, to_node) - along * along;
            const double way             = along - extent.reach(normal);
            const double share =
              weight * extent.facing(-1. * normal) *
              std::exp(-way / (sharpness * spacing) -
                       0.5 * square_of_aside / std::pow(width_of_mean * spacing, 2));
            gaps.add(SharedNodeGaps::weight(side, k), at.slot, at.number, share);
            gaps.add(SharedNodeGaps::weighted_way(side, k), at.slot, at.number, share * way);
          }
      });
    }
  } // namespace

  template <int dim>
  void
  add_shared_material(const std::vector<Body<dim>> &bodies,
                      const int group,
                      const int side,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      const NodeField<dim, SingleScalar> &shared,
                      NodeField<dim, SharedNodeMaterial> &material)
  {
    using Sums     = SharedNodeMaterial;
    const auto add = [&](const Body<dim> &body,
                         const std::size_t begin,
                         const std::size_t end,
                         const SharedStencils<dim> &stencils) {
      const ParticleArrays<dim, const double> particles = body.particles.arrays();
      const double square_of_speed =
        std::visit([](const auto &law) { return std::pow(law.wave_speed(law.undeformed()), 2); },
                   body.material);
      for (std::size_t p = begin; p < end; ++p)
        {
          const double mass = particles.mass[p], undeformed = particles.volume[p];
          const double volume    = undeformed * volume_ratio(body, particles, p);
          const double stiffness = square_of_speed * mass / undeformed * volume;
          stencils.for_shared(
            body.particles.position(p),
            [&](const int i, const double weight, const Vector<dim> &gradient) {
              const LatticeNode at = stencils.node(i);
              material.add(Sums::volume_gradient(side),
                           at.slot,
                           at.number,
                           is_fluid(body) ? (4. * volume * weight / std::pow(lattice.spacing, 2)) *
                                              (stencils.position(i) - body.particles.position(p))
                                          : volume * gradient);
              material.add(Sums::mass(side), at.slot, at.number, weight * mass);
              material.add(Sums::volume(side), at.slot, at.number, weight * volume);
              material.add(Sums::stiffness(side), at.slot, at.number, weight * stiffness);
            });
        }
    };
    for_runs_near(bodies, group, blocks, lattice, shared, add);
  }

  template <int dim>
  void
  add_shared_gaps(const std::vector<Body<dim>> &bodies,
                  const int group,
                  const int side,
                  const BlockSet<dim> &blocks,
                  const Lattice<dim> &lattice,
                  const NodeField<dim, SingleScalar> &shared,
                  const NodeField<dim, SharedNodeMaterial> &material,
                  NodeField<dim, SharedNodeGaps> &gaps)
  {
    WindowNormals<dim> normals;
    const auto add = [&](const Body<dim> &body,
                         const std::size_t begin,
                         const std::size_t end,
                         const SharedStencils<dim> &stencils) {
      const ParticleArrays<dim, const double> particles = body.particles.arrays();
      find_normals(stencils, material, normals);
      const auto add_ways_of =
        [&](const std::size_t p, const auto &extent, const double sharpness) {
          add_ways(body.particles.position(p),
                   extent,
                   side,
                   sharpness,
                   lattice.spacing,
                   stencils,
                   normals,
                   gaps);
        };
      for (std::size_t p = begin; p < end; ++p)
        if (is_fluid(body))
          add_ways_of(p,
                      FluidExtent<dim>(particles.volume[p] * volume_ratio(body, particles, p)),
                      sharpness_in_fluids);
        else
          add_ways_of(p,
                      DeformedExtent<dim>(particles, load_matrix<dim>(particles.deformation, p), p),
                      sharpness_in_solids);
    };
    for_runs_near(bodies, group, blocks, lattice, shared, add);
  }

#define INSTANTIATE(dim)                                                    \
  template void add_shared_material(const std::vector<Body<dim>> &,         \
                                    int,                                    \
                                    int,                                    \
                                    const BlockSet<dim> &,                  \
                                    const Lattice<dim> &,                   \
                                    const NodeField<dim, SingleScalar> &,   \
                                    NodeField<dim, SharedNodeMaterial> &);  \
  template void add_shared_gaps(const std::vector<Body<dim>> &,             \
                                int,                                        \
                                int,                                        \
                                const BlockSet<dim> &,                      \
                                const Lattice<dim> &,                       \
                                const NodeField<dim, SingleScalar> &,       \
                                const NodeField<dim, SharedNodeMaterial> &, \
                                NodeField<dim, SharedNodeGaps> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
