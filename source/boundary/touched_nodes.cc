#include <magmpm/boundary/touched_nodes.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** The radius of the ball around a block that holds its nodes, and its centre [m]. */
    template <int dim>
    double
    block_radius(const Lattice<dim> &lattice)
    {
      return 0.5 * (block_edge - 1) * lattice.spacing * std::sqrt(static_cast<double>(dim));
    }

    template <int dim>
    Vector<dim>
    block_centre(const Lattice<dim> &lattice, const Index<dim> &block)
    {
      Vector<dim> centre = lattice.node_position(node_of_block<dim>(block, 0));
      for (int d = 0; d < dim; ++d)
        centre[d] += 0.5 * (block_edge - 1) * lattice.spacing;
      return centre;
    }
  } // namespace

  template <int dim>
  TouchedNodes<dim>::TouchedNodes(const std::vector<RigidBody<dim>> &bodies,
                                  const SolidContact<dim> &contact,
                                  const BlockSet<dim> &blocks,
                                  const Lattice<dim> &lattice,
                                  const double negligible_mass,
                                  const NodeField<dim> &field)
  {
    std::vector<int> near;
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      {
        near.clear();
        for (std::size_t b = 0; b < bodies.size(); ++b)
          if (bodies[b].is_free() && bodies[b].contact().condition != ContactCondition::none &&
              bodies[b].is_near(block_centre<dim>(lattice, blocks.block(slot)),
                                block_radius(lattice)))
            near.push_back(static_cast<int>(b));
        for (int n = 0; n < nodes_per_block<dim> && !near.empty(); ++n)
          {
            const double mass = field.get(NodeMotion::mass, slot, n);
            if (mass > negligible_mass && !contact.acts_on(slot, n, mass))
              add_if_touched(
                bodies,
                near,
                lattice.node_position(node_of_block<dim>(blocks.block(slot), n)),
                {slot, n, 0, {}, {}, field.get(NodeMotion::velocity, slot, n), mass, {}});
          }
      }
    add_solids(bodies, contact, blocks, lattice, field);
  }

  template <int dim>
  void
  TouchedNodes<dim>::add_solids(const std::vector<RigidBody<dim>> &bodies,
                                const SolidContact<dim> &contact,
                                const BlockSet<dim> &blocks,
                                const Lattice<dim> &lattice,
                                const NodeField<dim> &field)
  {
    for (const auto &touched : contact.touched_nodes())
      {
        const Vector<dim> position =
          lattice.node_position(node_of_block<dim>(blocks.block(touched.slot), touched.number));
        nodes.push_back({touched.slot,
                         touched.number,
                         touched.body,
                         position - bodies[touched.body].pose().position,
                         touched.normal,
                         field.get(NodeMotion::velocity, touched.slot, touched.number),
                         field.get(NodeMotion::mass, touched.slot, touched.number),
                         {},
                         true,
                         touched.is_held,
                         touched.pressing});
      }
  }

  template <int dim>
  void
  TouchedNodes<dim>::add_if_touched(const std::vector<RigidBody<dim>> &bodies,
                                    const std::vector<int> &near,
                                    const Vector<dim> &position,
                                    Node node)
  {
    double deepest = 0.;
    for (const int b : near)
      {
        if (!bodies[b].is_near(position, 0.))
          continue;
        const SurfaceDistance<dim> nearest = bodies[b].surface_distance(position);
        if (nearest.distance >= deepest)
          continue;
        deepest          = nearest.distance;
        node.body        = b;
        node.from_centre = position - bodies[b].pose().position;
        node.normal      = nearest.normal;
      }
    if (deepest == 0.)
      return;
    nodes.push_back(node);
  }

  template <int dim>
  void
  TouchedNodes<dim>::update_shares(const std::vector<RigidBody<dim>> &bodies,
                                   const std::vector<RigidVector<dim>> &motions)
  {
    for (Node &node : nodes)
      {
        const SurfaceContact &contact = bodies[node.body].contact();
        const Vector<dim> relative =
          node.velocity - motion_of<dim>(motions[node.body]).velocity_at(node.from_centre);
        if (!node.is_solid ||
            (node.is_held && node.pressing == 0. && dot(relative, node.normal) > 0.))
          node.share = contact_share(contact, node.normal, relative);
        else
          node.share = friction_share(contact, node.mass, node.pressing, node.normal, relative);
      }
  }

  template <int dim>
  void
  TouchedNodes<dim>::add_to(std::vector<RigidEquation<dim>> &equations) const
  {
    const auto add = [](RigidEquation<dim> &equation,
                        const Node &node,
                        const double share,
                        const Vector<dim> &direction) {
      const RigidVector<dim> row = momentum_of(direction, node.from_centre);
      const double mass          = share * node.mass;
      equation.inertia += mass * outer(row, row);
      equation.momentum += (mass * dot(direction, node.velocity)) * row;
    };
    for (const Node &node : nodes)
      {
        if (node.share.normal == 0. && node.share.tangential == 0.)
          continue;
        RigidEquation<dim> &equation = equations[node.body];
        add(equation, node, node.share.normal - node.share.tangential, node.normal);
        for (int d = 0; d < dim && node.share.tangential > 0.; ++d)
          {
            Vector<dim> direction;
            direction[d] = 1.;
            add(equation, node, node.share.tangential, direction);
          }
      }
  }

  template <int dim>
  void
  TouchedNodes<dim>::apply(const std::vector<RigidVector<dim>> &motions,
                           const BlockSet<dim> &blocks,
                           const LatticeBoundary<dim> &boundary,
                           NodeField<dim> &field,
                           NodeField<dim> &unconstrained) const
  {
    for (const Node &node : nodes)
      {
        const Vector<dim> relative =
          node.velocity - motion_of<dim>(motions[node.body]).velocity_at(node.from_centre);
        const Vector<dim> velocity = node.velocity - taken_by(node.share, node.normal, relative);
        const Index<dim> index     = node_of_block<dim>(blocks.block(node.slot), node.number);
        if (unconstrained.n_blocks() > 0)
          unconstrained.set(NodeMotion::velocity, node.slot, node.number, velocity);
        field.set(NodeMotion::velocity,
                  node.slot,
                  node.number,
                  node.is_solid ? boundary.at_sticking_walls(index, velocity)
                                : boundary.constrained(index, velocity));
      }
  }

  template class TouchedNodes<2>;
  template class TouchedNodes<3>;
} // namespace magmpm
