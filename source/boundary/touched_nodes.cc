#include <magmpm/boundary/touched_nodes.h>

namespace magmpm
{
  template <int dim>
  TouchedNodes<dim>::TouchedNodes(const std::vector<RigidBody<dim>> &bodies,
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
                         touched.is_held,
                         touched.pressing});
      }
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
        if (node.is_held && node.pressing == 0. && dot(relative, node.normal) > 0.)
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
                  boundary.at_sticking_walls(index, velocity));
      }
  }

  template class TouchedNodes<2>;
  template class TouchedNodes<3>;
} // namespace magmpm
