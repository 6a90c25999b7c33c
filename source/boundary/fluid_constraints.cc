#include <magmpm/boundary/fluid_constraints.h>
#include <magmpm/lattice/lattice_node.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/parallel/gather.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Nodes that are deeper have no image: no particle outside reaches them [dx]. */
    constexpr double largest_depth = 1.5;

    /** Nodes with a smaller weight do not count. */
    constexpr double least_weight = 1e-9;

    constexpr int none = -1;

    /** The nearest of the bodies that @p position is in, or none. */
    template <int dim>
    int
    find_body(const std::vector<RigidBody<dim>> &bodies,
              const Vector<dim> &position,
              SurfaceDistance<dim> &surface)
    {
      int result       = none;
      surface.distance = 0.;
      for (std::size_t b = 0; b < bodies.size(); ++b)
        {
          if (bodies[b].contact().condition == ContactCondition::none ||
              !bodies[b].is_near(position, 0.))
            continue;
          const SurfaceDistance<dim> found = bodies[b].surface_distance(position);
          if (found.distance >= surface.distance)
            continue;
          surface = found;
          result  = static_cast<int>(b);
        }
      return result;
    }

    /** Makes @p index that of the node in front if it is behind a wall. @return FluidTerm::mirror. */
    template <int dim>
    Vector<dim>
    go_in_front(const WallParameters<dim> &walls, const Lattice<dim> &lattice, Index<dim> &index)
    {
      Vector<dim> mirror;
      for (int d = 0; d < dim; ++d)
        mirror[d] = 1.;
      for (int d = 0; d < dim; ++d)
        {
          const bool is_below = index[d] < 0;
          if (!is_below && index[d] <= lattice.n_cells[d])
            continue;
          const WallCondition wall = walls.condition[2 * d + (is_below ? 0 : 1)];
          if (wall == WallCondition::open)
            continue;
          index[d] = (is_below ? 0 : 2 * lattice.n_cells[d]) - index[d];
          for (int c = 0; c < dim; ++c)
            if (c == d || wall == WallCondition::stick)
              mirror[c] = -mirror[c];
        }
      return mirror;
    }

    /** Makes the constraint of one node inside a body. */
    template <int dim>
    class ConstraintMaker
    {
    public:
      ConstraintMaker(const WallParameters<dim> &walls,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      const double negligible_mass,
                      const NodeField<dim> &field)
        : walls(walls)
        , blocks(blocks)
        , lattice(lattice)
        , negligible_mass(negligible_mass)
        , field(field)
      {
      }

      FluidConstraint<dim>
      make(const Index<dim> &node,
           const int body,
           const Vector<dim> &centre,
           const SurfaceDistance<dim> &surface) const
      {
        FluidConstraint<dim> constraint;
        constraint.body   = body;
        constraint.normal = surface.normal;
        add(node, 1., centre, constraint);
        if (surface.distance > -largest_depth * lattice.spacing)
          add_image(lattice.node_position(node) - 2. * surface.distance * surface.normal,
                    centre,
                    constraint);
        constraint.from_centre = (1. / constraint.weight) * constraint.from_centre;
        return constraint;
      }

    private:
      void
      add_image(const Vector<dim> &image,
                const Vector<dim> &centre,
                FluidConstraint<dim> &constraint) const
      {
        Index<dim> base;
        Vector<dim> part;
        for (int d = 0; d < dim; ++d)
          {
            const double x = (image[d] - lattice.lower_corner[d]) / lattice.spacing;
            base[d]        = static_cast<int>(std::floor(x));
            part[d]        = x - base[d];
          }
        for (int k = 0; k < power(2, dim); ++k)
          {
            Index<dim> corner = base;
            double weight     = 1.;
            for (int d = 0; d < dim; ++d)
              {
                const bool is_upper = ((k >> d) & 1) == 1;
                corner[d] += is_upper;
                weight *= is_upper ? part[d] : 1. - part[d];
              }
            add(corner, weight, centre, constraint);
          }
      }

      void
      add(const Index<dim> &index,
          const double weight,
          const Vector<dim> &centre,
          FluidConstraint<dim> &constraint) const
      {
        Index<dim> node           = index;
        const Vector<dim> mirror  = go_in_front<dim>(walls, lattice, node);
        const auto [slot, number] = lattice_node<dim>(blocks, node);
        if (slot == invalid_slot || !(weight > least_weight))
          return;
        const double mass = field.get(NodeMotion::mass, slot, number);
        if (!(mass > negligible_mass))
          return;
        constraint.weight += weight;
        constraint.from_centre += weight * (lattice.node_position(index) - centre);
        // A node near the surface is one of those around its own image.
        for (int t = 0; t < constraint.n_terms; ++t)
          if (constraint.terms[t].node == node && norm(constraint.terms[t].mirror - mirror) == 0.)
            {
              constraint.terms[t].weight += weight;
              return;
            }
        constraint.terms[constraint.n_terms++] = {
          node, weight, mirror, mass, field.get(NodeMotion::velocity, slot, number)};
      }

      const WallParameters<dim> &walls;
      const BlockSet<dim> &blocks;
      const Lattice<dim> &lattice;
      const double negligible_mass;
      const NodeField<dim> &field;
    };
  } // namespace

  template <int dim>
  std::vector<FluidConstraint<dim>>
  find_fluid_constraints(const std::vector<RigidBody<dim>> &bodies,
                         const SolidContact<dim> &solids,
                         const WallParameters<dim> &walls,
                         const BlockSet<dim> &blocks,
                         const Lattice<dim> &lattice,
                         const double negligible_mass,
                         const NodeField<dim> &field,
                         const MPI_Comm communicator)
  {
    const ConstraintMaker<dim> maker(walls, blocks, lattice, negligible_mass, field);
    std::vector<FluidConstraint<dim>> own, all;
    for_nodes(blocks, [&](const int slot, const int n) {
      const double mass = field.get(NodeMotion::mass, slot, n);
      if (!(mass > negligible_mass) || solids.acts_on(slot, n, mass))
        return;
      const Index<dim> node = node_of_block<dim>(blocks.block(slot), n);
      SurfaceDistance<dim> surface;
      const int body = find_body(bodies, lattice.node_position(node), surface);
      if (body != none)
        own.push_back(maker.make(node, body, bodies[body].pose().position, surface));
    });
    for (const auto &of_rank : parallel::all_gather(own, communicator))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
      return a.terms[0].node < b.terms[0].node;
    });
    return all;
  }

#define INSTANTIATE(dim)                                             \
  template std::vector<FluidConstraint<dim>> find_fluid_constraints( \
    const std::vector<RigidBody<dim>> &,                             \
    const SolidContact<dim> &,                                       \
    const WallParameters<dim> &,                                     \
    const BlockSet<dim> &,                                           \
    const Lattice<dim> &,                                            \
    double,                                                          \
    const NodeField<dim> &,                                          \
    const MPI_Comm);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
