#include <magmpm/boundary/momentum_update.h>
#include <magmpm/lattice/node_window.h>

#include <cmath>

namespace magmpm
{
  template <int dim>
  void
  update_lattice_momentum(const BlockSet<dim> &blocks,
                          const LatticeBoundary<dim> &boundary,
                          const Vector<dim> &gravity,
                          const double time_step,
                          const double damping_rate,
                          const double typical_mass,
                          NodeField<dim> &field)
  {
    const double negligible_mass = 1e-12 * typical_mass;
    const double remaining       = std::exp(-damping_rate * time_step);
    for_nodes(blocks, [&](const int slot, const int n) {
      const double mass = field.get(NodeMotion::mass, slot, n);
      if (mass == 0.)
        return;
      Vector<dim> velocity;
      if (mass > negligible_mass)
        {
          const Vector<dim> momentum = field.get(NodeMotion::momentum, slot, n);
          for (int d = 0; d < dim; ++d)
            velocity[d] = remaining * (momentum[d] / mass + time_step * gravity[d]);
          velocity = boundary.constrained(node_of_block<dim>(blocks.block(slot), n), velocity);
        }
      field.set(NodeMotion::velocity, slot, n, velocity);
    });
  }

  template void
  update_lattice_momentum(const BlockSet<2> &,
                          const LatticeBoundary<2> &,
                          const Vector<2> &,
                          double,
                          double,
                          double,
                          NodeField<2> &);
  template void
  update_lattice_momentum(const BlockSet<3> &,
                          const LatticeBoundary<3> &,
                          const Vector<3> &,
                          double,
                          double,
                          double,
                          NodeField<3> &);
} // namespace magmpm
