#include <magmpm/boundary/body_share.h>
#include <magmpm/lattice/node_window.h>

#include <cmath>

namespace magmpm
{
  double
  share_inside(const double t)
  {
    constexpr double reach = bspline_reach;
    const double a         = std::abs(t);
    if (a >= reach)
      return t > 0. ? 0. : 1.;
    const double share = (a < 0.5 ? 0.5 - 0.75 * a + a * a * a / 3.
                                  : (reach - a) * (reach - a) * (reach - a) / 6.);
    return t > 0. ? share : 1. - share;
  }

  template <int dim>
  void
  add_share_in_bodies(const std::vector<RigidBody<dim>> &bodies,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      NodeField<dim, SingleScalar> &fraction)
  {
    for (const RigidBody<dim> &body : bodies)
      if (body.contact().condition != ContactCondition::none)
        for_nodes(blocks, [&](const int slot, const int n) {
          const Vector<dim> position =
            lattice.node_position(node_of_block<dim>(blocks.block(slot), n));
          if (body.is_near(position, bspline_reach * lattice.spacing))
            fraction.add(SingleScalar::value,
                         slot,
                         n,
                         share_inside(body.surface_distance(position).distance / lattice.spacing));
        });
  }

#define INSTANTIATE(dim)                                                 \
  template void add_share_in_bodies(const std::vector<RigidBody<dim>> &, \
                                    const BlockSet<dim> &,               \
                                    const Lattice<dim> &,                \
                                    NodeField<dim, SingleScalar> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
