#include <magmpm/mesh/potential_box.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  template <int dim>
  Index<dim>
  PotentialBox<dim>::n_blocks() const
  {
    Index<dim> n;
    for (int d = 0; d < dim; ++d)
      n[d] = n_roots[d] << root_level;
    return n;
  }

  template <int dim>
  bool
  PotentialBox<dim>::holds(const Index<dim> &block) const
  {
    return block == nearest(block);
  }

  template <int dim>
  Index<dim>
  PotentialBox<dim>::nearest(Index<dim> block) const
  {
    const Index<dim> n = n_blocks();
    for (int d = 0; d < dim; ++d)
      block[d] = std::clamp(block[d], lower[d], lower[d] + n[d] - 1);
    return block;
  }

  template <int dim>
  PotentialBox<dim>
  potential_box(const Lattice<dim> &lattice, const MeshParameters<dim> &parameters)
  {
    PotentialBox<dim> box;
    Index<dim> needed, wall_to_wall;
    for (int d = 0; d < dim; ++d)
      {
        wall_to_wall[d]  = lattice.n_cells[d] / block_edge;
        const int n_open = parameters.carries_potential
                             ? 2 - parameters.shielded[2 * d] - parameters.shielded[2 * d + 1]
                             : 0;
        needed[d]        = wall_to_wall[d];
        if (n_open > 0)
          needed[d] = std::max(
            wall_to_wall[d] + 2 * n_open,
            static_cast<int>(std::ceil(wall_to_wall[d] * parameters.potential_box_factor)));
        const bool fixed = parameters.carries_potential && n_open == 0;
        int level        = 0;
        while (fixed ? needed[d] % (2 << level) == 0 : (2 << level) <= needed[d])
          ++level;
        box.root_level = (d == 0 ? level : std::min(box.root_level, level));
      }
    for (int d = 0; d < dim; ++d)
      box.n_roots[d] = ((needed[d] - 1) >> box.root_level) + 1;

    const auto is_even = [](const int n) { return n % 2 == 0; };
    while (std::all_of(box.n_roots.begin(), box.n_roots.end(), is_even))
      {
        ++box.root_level;
        for (int &n : box.n_roots)
          n /= 2;
      }
    for (int d = 0; d < dim; ++d)
      {
        const int outside     = box.n_blocks()[d] - wall_to_wall[d];
        const bool open_below = !(parameters.carries_potential && parameters.shielded[2 * d]);
        const bool open_above = !(parameters.carries_potential && parameters.shielded[2 * d + 1]);
        box.lower[d]          = (open_below ? (open_above ? -(outside / 2) : -outside) : 0);
      }
    return box;
  }

  template struct PotentialBox<2>;
  template struct PotentialBox<3>;
  template PotentialBox<2>
  potential_box(const Lattice<2> &, const MeshParameters<2> &);
  template PotentialBox<3>
  potential_box(const Lattice<3> &, const MeshParameters<3> &);
} // namespace magmpm
