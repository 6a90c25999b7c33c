#include <magmpm/boundary/momentum_update.h>

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
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        {
          double *node      = field.node(slot, n);
          const double mass = node[3];
          if (mass == 0.)
            continue;
          Vector<dim> velocity;
          if (mass > negligible_mass)
            {
              for (int d = 0; d < dim; ++d)
                velocity[d] = remaining * (node[d] / mass + time_step * gravity[d]);
              velocity = boundary.constrained(node_of_block<dim>(blocks.block(slot), n), velocity);
            }
          for (int d = 0; d < dim; ++d)
            node[d] = velocity[d];
        }
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
