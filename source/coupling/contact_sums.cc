#include <magmpm/coupling/block_ball.h>
#include <magmpm/coupling/contact_sums.h>
#include <magmpm/lattice/arena.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/deformed_extent.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** How sharp the mean of the gaps is. */
    constexpr double sharpness = 0.2; // dx

    /** The surfaces that particles of a block may be within a distance of. */
    template <int dim>
    struct NearSurfaces
    {
      std::vector<int> walls; ///< faces
      std::vector<const RigidBody<dim> *> bodies;

      bool
      empty() const
      {
        return walls.empty() && bodies.empty();
      }
    };

    template <int dim>
    double
    distance_to_wall(const Lattice<dim> &lattice, const int face, const Vector<dim> &position)
    {
      const int d = face / 2;
      return face % 2 == 0 ? position[d] - lattice.lower_corner[d]
                           : lattice.upper_corner()[d] - position[d];
    }

    template <int dim>
    void
    find_near(const Lattice<dim> &lattice,
              const SolidContact<dim> &contact,
              const Index<dim> &block,
              const double distance,
              NearSurfaces<dim> &near)
    {
      near.walls.clear();
      near.bodies.clear();
      const Ball<dim> ball       = reach_of_block<dim>(lattice, block);
      const double along_an_axis = (0.5 * block_edge + 1.) * lattice.spacing;
      for (int face = 0; face < 2 * dim; ++face)
        if (contact.has_wall(face) &&
            distance_to_wall(lattice, face, ball.centre) < along_an_axis + distance)
          near.walls.push_back(face);
      for (const RigidBody<dim> &body : contact.all_bodies())
        if (body.contact().condition != ContactCondition::none &&
            body.is_near(ball.centre, ball.radius + distance) &&
            body.surface_distance(ball.centre).distance < ball.radius + distance)
          near.bodies.push_back(&body);
    }

    template <int dim>
    bool
    is_solid(const Body<dim> &body)
    {
      return body.particles.n_components(ParticleProperty::half_extent) > 0;
    }

    template <int dim>
    bool
    has_solids(const std::vector<Body<dim>> &bodies, const int group, const int slot)
    {
      return std::any_of(bodies.begin(), bodies.end(), [&](const Body<dim> &body) {
        return is_solid(body) && is_in_group(body, group) &&
               body.run_begin[slot] < body.run_begin[slot + 1];
      });
    }

    /** What a particle adds, times its weight at a node. */
    template <int dim>
    struct Contribution
    {
      static constexpr int width = NodeField<dim, ContactSums>::width;

      alignas(64) double numbers[width] = {};
      double volume                     = 0.; ///< J V_0 [m^dim]

      void
      set_gap(const int surface, const double facing, const double gap, const double spacing)
      {
        const double weight = facing * std::exp(-gap / (sharpness * spacing));
        numbers[ContactSums::weight(surface).lane]       = weight;
        numbers[ContactSums::weighted_gap(surface).lane] = weight * gap;
      }
    };

    /** @return whether the particle is near to any of the surfaces. */
    template <int dim>
    bool
    set_gaps(const Lattice<dim> &lattice,
             const NearSurfaces<dim> &near,
             const Vector<dim> &position,
             const DeformedExtent<dim> &extent,
             Contribution<dim> &contribution)
    {
      const double reach = reach_of_contact(lattice);
      bool is_near       = false;
      for (const int face : near.walls)
        {
          const double distance = distance_to_wall(lattice, face, position);
          if (distance >= 3. * lattice.spacing)
            continue;
          is_near = true;
          Vector<dim> normal;
          normal[face / 2] = (face % 2 == 0 ? 1. : -1.);
          contribution.set_gap(
            face / 2, extent.facing(normal), distance - extent.reach(normal), lattice.spacing);
        }
      SurfaceDistance<dim> nearest = {reach, {}};
      for (const RigidBody<dim> *body : near.bodies)
        {
          const SurfaceDistance<dim> found = body->surface_distance(position);
          if (found.distance < nearest.distance)
            nearest = found;
        }
      if (nearest.distance < reach)
        {
          is_near = true;
          contribution.set_gap(ContactSums::nearest_body,
                               extent.facing(nearest.normal),
                               nearest.distance - extent.reach(nearest.normal),
                               lattice.spacing);
          const double weight =
            contribution.numbers[ContactSums::weight(ContactSums::nearest_body).lane];
          for (int d = 0; d < dim; ++d)
            contribution.numbers[ContactSums::normal.lane + d] = weight * nearest.normal[d];
          contribution.numbers[ContactSums::plane.lane] =
            weight * (nearest.distance - dot(nearest.normal, position - lattice.lower_corner));
        }
      return is_near;
    }

    /** The nodes that particles of a block reach: where their sums are. */
    template <int dim>
    class NodesOfBlock
    {
    public:
      NodesOfBlock(const Lattice<dim> &lattice,
                   const BlockSet<dim> &blocks,
                   const int slot,
                   NodeField<dim, ContactSums> &sums)
        : origin(lattice.node_position(Arena<dim>::first_node(blocks.block(slot))))
        , inverse_spacing(1. / lattice.spacing)
      {
        for (int i = 0; i < Window::n_nodes; ++i)
          nodes[i] = sums.node(blocks.neighbours(slot)[Window::place(i).neighbour],
                               Window::place(i).node);
      }

      void
      add(const Vector<dim> &position, const Contribution<dim> &contribution) const
      {
        int first = 0;
        double weights[dim][stencil_width], slopes[dim][stencil_width];
        for (int d = 0; d < dim; ++d)
          {
            const double x = (position[d] - origin[d]) * inverse_spacing;
            const int node = static_cast<int>(x - 0.5);
            first += node * Window::stride(d);
            quadratic_bspline(x - node, weights[d]);
            quadratic_bspline_derivative(x - node, slopes[d]);
          }
        constexpr auto offsets = Window::template box_offsets<stencil_width>();
        for (int i = 0; i < static_cast<int>(offsets.size()); ++i)
          {
            double weight = 1., gradient[dim];
            std::fill(gradient, gradient + dim, contribution.volume * inverse_spacing);
            for (int d = 0, rest = i; d < dim; ++d, rest /= stencil_width)
              {
                weight *= weights[d][rest % stencil_width];
                for (int e = 0; e < dim; ++e)
                  gradient[e] *= (d == e ? slopes : weights)[d][rest % stencil_width];
              }
            double *const node = nodes[first + offsets[i]];
            for (int lane = 0; lane < Contribution<dim>::width; ++lane)
              node[lane] += weight * contribution.numbers[lane];
            for (int d = 0; d < dim; ++d)
              node[ContactSums::volume_gradient.lane + d] += gradient[d];
          }
      }

    private:
      using Window = NodeWindow<dim, 1, block_edge - 1>;

      const Vector<dim> origin;
      const double inverse_spacing;
      std::array<double *, Window::n_nodes> nodes;
    };

    template <int dim>
    void
    add_particles(const Body<dim> &body,
                  const std::size_t begin,
                  const std::size_t end,
                  const Lattice<dim> &lattice,
                  const NearSurfaces<dim> &near,
                  const NodesOfBlock<dim> &nodes)
    {
      const ParticleArrays<dim, const double> particles = body.particles.arrays();
      const double square_of_speed =
        std::visit([](const auto &law) { return std::pow(law.wave_speed(law.undeformed()), 2); },
                   body.material);
      for (std::size_t p = begin; p < end; ++p)
        {
          const Vector<dim> position    = body.particles.position(p);
          const Matrix<dim> deformation = load_matrix<dim>(particles.deformation, p);
          Contribution<dim> contribution;
          if (!set_gaps(lattice,
                        near,
                        position,
                        DeformedExtent<dim>(particles, deformation, p),
                        contribution))
            continue;
          contribution.volume = particles.volume[p] * determinant(deformation);
          contribution.numbers[ContactSums::mass.lane]   = particles.mass[p];
          contribution.numbers[ContactSums::volume.lane] = contribution.volume;
          contribution.numbers[ContactSums::stiffness.lane] =
            square_of_speed * particles.mass[p] / particles.volume[p] * contribution.volume;
          nodes.add(position, contribution);
        }
    }
  } // namespace

  template <int dim>
  bool
  is_contact_near(const std::vector<Body<dim>> &bodies,
                  const BlockSet<dim> &blocks,
                  const Lattice<dim> &lattice,
                  const SolidContact<dim> &contact)
  {
    // In a step both move by less than a cell.
    const double distance = reach_of_contact(lattice) + 2. * lattice.spacing;
    NearSurfaces<dim> near;
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      if (has_solids(bodies, every_group, slot))
        {
          find_near<dim>(lattice, contact, blocks.block(slot), distance, near);
          if (!near.empty())
            return true;
        }
    return false;
  }

  template <int dim>
  void
  sum_contact(const std::vector<Body<dim>> &bodies,
              const int group,
              const BlockSet<dim> &blocks,
              const Lattice<dim> &lattice,
              const SolidContact<dim> &contact,
              NodeField<dim, ContactSums> &sums)
  {
    sums.set_zero();
    NearSurfaces<dim> near;
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      {
        if (!has_solids(bodies, group, slot))
          continue;
        find_near<dim>(lattice, contact, blocks.block(slot), reach_of_contact(lattice), near);
        if (near.empty())
          continue;
        const NodesOfBlock<dim> nodes(lattice, blocks, slot, sums);
        for (const Body<dim> &body : bodies)
          if (is_solid(body) && is_in_group(body, group))
            add_particles(
              body, body.run_begin[slot], body.run_begin[slot + 1], lattice, near, nodes);
      }
  }

#define INSTANTIATE(dim)                                        \
  template bool is_contact_near(const std::vector<Body<dim>> &, \
                                const BlockSet<dim> &,          \
                                const Lattice<dim> &,           \
                                const SolidContact<dim> &);     \
  template void sum_contact(const std::vector<Body<dim>> &,     \
                            int,                                \
                            const BlockSet<dim> &,              \
                            const Lattice<dim> &,               \
                            const SolidContact<dim> &,          \
                            NodeField<dim, ContactSums> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
