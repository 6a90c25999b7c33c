#include <magmpm/boundary/lattice_boundary.h>

namespace magmpm
{
  namespace
  {
    ContactCondition
    as_contact(const WallCondition condition)
    {
      switch (condition)
        {
          case WallCondition::stick:
            return ContactCondition::stick;
          case WallCondition::slip:
            return ContactCondition::slip;
          case WallCondition::open:
            return ContactCondition::none;
          case WallCondition::separate:
          default:
            return ContactCondition::separate;
        }
    }
  } // namespace

  template <int dim>
  LatticeBoundary<dim>::LatticeBoundary(const Lattice<dim> &lattice,
                                        const WallParameters<dim> &walls)
    : lattice(lattice)
    , walls(walls)
  {
  }

  template <int dim>
  Vector<dim>
  LatticeBoundary<dim>::constrained(const Index<dim> &node, Vector<dim> velocity) const
  {
    for (int face = 0; face < 2 * dim; ++face)
      if (is_at_wall(node, face))
        {
          Vector<dim> normal;
          normal[face / 2] = (face % 2 == 0 ? 1. : -1.);
          velocity -=
            taken_by(contact_share(
                       {as_contact(walls.condition[face]), walls.friction[face]}, normal, velocity),
                     normal,
                     velocity);
        }
    return velocity;
  }

  template <int dim>
  Vector<dim>
  LatticeBoundary<dim>::at_sticking_walls(const Index<dim> &node, const Vector<dim> &velocity) const
  {
    for (int face = 0; face < 2 * dim; ++face)
      if (walls.condition[face] == WallCondition::stick && is_at_wall(node, face))
        return {};
    return velocity;
  }

  template class LatticeBoundary<2>;
  template class LatticeBoundary<3>;
} // namespace magmpm
