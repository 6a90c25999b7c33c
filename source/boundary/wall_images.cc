#include <magmpm/boundary/wall_images.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  WallImages<dim>::WallImages(const Lattice<dim> &lattice,
                              const WallParameters<dim> &walls,
                              const bool has_fluids)
    : lattice(lattice)
    , walls(walls)
  {
    for (const WallCondition condition : walls.condition)
      if (has_fluids && (condition == WallCondition::slip || condition == WallCondition::separate))
        any_chosen = true;
  }

  template <int dim>
  Vector<dim>
  WallImages<dim>::reflected(const int face, Vector<dim> vector) const
  {
    const bool sticks = walls.condition[face] == WallCondition::stick;
    for (int d = 0; d < dim; ++d)
      if (sticks || d == face / 2)
        vector[d] = -vector[d];
    return vector;
  }

  template <int dim>
  void
  WallImages<dim>::fold(const WallColumn &column, const int face, NodeField<dim> &momentum) const
  {
    const LatticeNode front = column.in_front(1), behind = column.behind(1);
    const auto take = [&](const auto quantity) {
      const auto taken = momentum.get(quantity, behind.slot, behind.number);
      momentum.set(quantity, behind.slot, behind.number, {});
      return taken;
    };
    momentum.add(NodeMotion::mass, front.slot, front.number, take(NodeMotion::mass));
    momentum.add(
      NodeMotion::momentum, front.slot, front.number, reflected(face, take(NodeMotion::momentum)));
  }

  template <int dim>
  void
  WallImages<dim>::unfold(const WallColumn &column, const int face, NodeField<dim> &velocity) const
  {
    const LatticeNode front = column.in_front(1), behind = column.behind(1);
    velocity.set(NodeMotion::velocity,
                 behind.slot,
                 behind.number,
                 reflected(face, velocity.get(NodeMotion::velocity, front.slot, front.number)));
  }

  template <int dim>
  void
  WallImages<dim>::fold_sticking(const BlockSet<dim> &blocks, NodeField<dim> &momentum) const
  {
    for (int face = 0; face < 2 * dim; ++face)
      if (walls.condition[face] == WallCondition::stick)
        for_wall_columns<dim>(
          blocks, blocks.size(), lattice.n_cells, face, [&](const WallColumn &column) {
            fold(column, face, momentum);
          });
  }

  template <int dim>
  bool
  WallImages<dim>::leaves(const LatticeNode &on_wall,
                          const int face,
                          const Vector<dim> &velocity_gain,
                          const NodeField<dim> &momentum) const
  {
    const int axis      = face / 2;
    const double inward = (face % 2 == 0 ? 1. : -1.);
    const double normal = momentum.get(NodeMotion::momentum, on_wall.slot, on_wall.number)[axis];
    const double mass   = momentum.get(NodeMotion::mass, on_wall.slot, on_wall.number);
    return inward * (normal + mass * velocity_gain[axis]) > 0.;
  }

  template <int dim>
  void
  WallImages<dim>::choose_and_fold(const BlockSet<dim> &blocks,
                                   const SolidContact<dim> &contact,
                                   const Vector<dim> &velocity_gain,
                                   NodeField<dim> &momentum)
  {
    chosen.clear();
    for (int face = 0; face < 2 * dim; ++face)
      if (is_chosen(face))
        for_wall_columns<dim>(
          blocks, blocks.size(), lattice.n_cells, face, [&](const WallColumn &column) {
            const LatticeNode on_wall = column.on_wall();
            const LatticeNode behind  = column.behind(1);
            const double mass = momentum.get(NodeMotion::mass, on_wall.slot, on_wall.number);
            if (momentum.get(NodeMotion::mass, behind.slot, behind.number) == 0. ||
                contact.acts_on(on_wall.slot, on_wall.number, mass) ||
                (walls.condition[face] == WallCondition::separate &&
                 leaves(on_wall, face, velocity_gain, momentum)))
              return;
            chosen.push_back({column, face});
            fold(column, face, momentum);
          });
  }

  template <int dim>
  void
  WallImages<dim>::fold_chosen(NodeField<dim> &momentum) const
  {
    for (const ChosenColumn &line : chosen)
      fold(line.column, line.face, momentum);
  }

  template <int dim>
  void
  WallImages<dim>::unfold(const BlockSet<dim> &blocks, NodeField<dim> &velocity) const
  {
    std::for_each(chosen.rbegin(), chosen.rend(), [&](const ChosenColumn &line) {
      unfold(line.column, line.face, velocity);
    });
    for (int face = 0; face < 2 * dim; ++face)
      if (walls.condition[face] == WallCondition::stick)
        for_wall_columns<dim>(
          blocks, blocks.size(), lattice.n_cells, face, [&](const WallColumn &column) {
            unfold(column, face, velocity);
          });
  }

  template class WallImages<2>;
  template class WallImages<3>;
} // namespace magmpm
