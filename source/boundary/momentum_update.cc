#include <magmpm/boundary/momentum_update.h>
#include <magmpm/lattice/node_window.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /**
     * @p value along the axes along which no boundary has changed the velocity of a node, along the others
     * @p otherwise: what slips along a wall is not held along it.
     */
    template <int dim>
    Vector<dim>
    where_free(const NodeField<dim> &motion,
               const NodeField<dim> &unconstrained,
               const int slot,
               const int node,
               Vector<dim> value,
               const Vector<dim> &otherwise)
    {
      const Vector<dim> velocity = motion.get(NodeMotion::velocity, slot, node);
      const Vector<dim> free     = unconstrained.get(NodeMotion::velocity, slot, node);
      for (int d = 0; d < dim; ++d)
        if (velocity[d] != free[d])
          value[d] = otherwise[d];
      return value;
    }
  } // namespace

  template <int dim>
  void
  update_lattice_momentum(const BlockSet<dim> &blocks,
                          const LatticeBoundary<dim> &boundary,
                          SolidContact<dim> &contact,
                          const Vector<dim> &gravity,
                          const double time_step,
                          const double damping_rate,
                          const double typical_mass,
                          NodeField<dim> &field,
                          NodeField<dim> &unconstrained)
  {
    const double least_mass = negligible_mass(typical_mass);
    const double remaining  = std::exp(-damping_rate * time_step);
    const bool keeps_both   = unconstrained.n_blocks() > 0;
    for_nodes(blocks, [&](const int slot, const int n) {
      const double mass = field.get(NodeMotion::mass, slot, n);
      if (mass == 0.)
        return;
      Vector<dim> velocity, free;
      if (mass > least_mass)
        {
          const Vector<dim> momentum = field.get(NodeMotion::momentum, slot, n);
          for (int d = 0; d < dim; ++d)
            free[d] = remaining * (momentum[d] / mass + time_step * gravity[d]);
          const Index<dim> node = node_of_block<dim>(blocks.block(slot), n);
          if (contact.acts_on(slot, n, mass))
            {
              free     = contact.pressed(slot, n, node, time_step, mass, free);
              velocity = boundary.at_sticking_walls(node,
                                                    contact.held(slot, n, node, time_step, free));
            }
          else
            velocity = boundary.constrained(node, free);
        }
      field.set(NodeMotion::velocity, slot, n, velocity);
      if (keeps_both)
        unconstrained.set(NodeMotion::velocity, slot, n, free);
    });
  }

  template <int dim>
  void
  update_filtered_velocity(const BlockSet<dim> &blocks,
                           const double typical_mass,
                           const NodeField<dim> &motion,
                           const NodeField<dim> &unconstrained,
                           NodeField<dim> &filtered)
  {
    for_nodes(blocks, [&](const int slot, const int n) {
      Vector<dim> velocity = motion.get(NodeMotion::velocity, slot, n);
      const double mass    = motion.get(NodeMotion::mass, slot, n);
      if (mass > negligible_mass(typical_mass))
        velocity = where_free(motion,
                              unconstrained,
                              slot,
                              n,
                              (1. / mass) * filtered.get(NodeMotion::momentum, slot, n),
                              velocity);
      filtered.set(NodeMotion::velocity, slot, n, velocity);
    });
  }

  template <int dim>
  void
  give_back(const BlockSet<dim> &blocks,
            const double share,
            const NodeField<dim> &motion,
            const NodeField<dim> &filtered,
            NodeField<dim> &taken)
  {
    for_nodes_and_ghosts(blocks, [&](const int slot, const int n) {
      const Vector<dim> velocity = motion.get(NodeMotion::velocity, slot, n);
      taken.set(NodeMotion::velocity,
                slot,
                n,
                velocity + share * (velocity - filtered.get(NodeMotion::velocity, slot, n)));
    });
  }

  template <int dim>
  void
  give_back_by_particle(const BlockSet<dim> &blocks,
                        const double typical_mass,
                        const NodeField<dim> &motion,
                        const NodeField<dim> &unconstrained,
                        NodeField<dim> &taken)
  {
    for_nodes(blocks, [&](const int slot, const int n) {
      const Vector<dim> velocity = motion.get(NodeMotion::velocity, slot, n);
      const double mass          = motion.get(NodeMotion::mass, slot, n);
      Vector<dim> given;
      if (mass > negligible_mass(typical_mass))
        given = where_free(motion,
                           unconstrained,
                           slot,
                           n,
                           (1. / mass) * (taken.get(NodeMotion::mass, slot, n) * velocity -
                                          taken.get(NodeMotion::momentum, slot, n)),
                           {});
      taken.set(NodeMotion::velocity, slot, n, velocity + given);
    });
  }

#define INSTANTIATE(dim)                                              \
  template void update_lattice_momentum(const BlockSet<dim> &,        \
                                        const LatticeBoundary<dim> &, \
                                        SolidContact<dim> &,          \
                                        const Vector<dim> &,          \
                                        double,                       \
                                        double,                       \
                                        double,                       \
                                        NodeField<dim> &,             \
                                        NodeField<dim> &);            \
  template void update_filtered_velocity(const BlockSet<dim> &,       \
                                         double,                      \
                                         const NodeField<dim> &,      \
                                         const NodeField<dim> &,      \
                                         NodeField<dim> &);           \
  template void give_back(const BlockSet<dim> &,                      \
                          double,                                     \
                          const NodeField<dim> &,                     \
                          const NodeField<dim> &,                     \
                          NodeField<dim> &);                          \
  template void give_back_by_particle(const BlockSet<dim> &,          \
                                      double,                         \
                                      const NodeField<dim> &,         \
                                      const NodeField<dim> &,         \
                                      NodeField<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
