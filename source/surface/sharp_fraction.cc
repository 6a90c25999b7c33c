#include <magmpm/lattice/node_window.h>
#include <magmpm/mesh/node_filters.h>
#include <magmpm/surface/sharp_fraction.h>
#include <magmpm/surface/sharp_profile.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /**
     * Of |grad v| dx, at which the normal has lost 30 % of its length: at surfaces |grad v| dx is about
     * 1/2, in the middle of isolated particles and thin sheets 0.
     */
    constexpr double smallest_gradient = 1e-3;
  } // namespace

  template <int dim>
  void
  SharpFraction<dim>::reinit(const BlockPartition<dim> &partition,
                             const NodeField<dim, SingleScalar> &volumes)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, SingleScalar> sharpened(volumes);
    remove_smear(partition, sharpened);

    // Twice over 3^dim nodes is once over 5^dim.
    NodeField<dim, SingleScalar> largest(sharpened);
    for (int pass = 0; pass < 2; ++pass)
      maximize(partition, largest);

    clipped = 0;
    nodes.reinit(blocks.size());
    for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
      const double around = largest.get(SingleScalar::value, slot, node);
      nodes.set(Nodes::volume, slot, node, sharpened.get(SingleScalar::value, slot, node));
      nodes.set(Nodes::full, slot, node, std::clamp(around, smallest_full_volume, 1.));
      clipped += slot < blocks.n_owned() && around < smallest_full_volume &&
                 volumes.get(SingleScalar::value, slot, node) > 0.;
    });
  }

  template <int dim>
  Vector<dim>
  SharpFraction<dim>::normal(const Matrix<dim> &gradient_square)
  {
    const double total = trace(gradient_square);
    if (!(total > 0.))
      return {};
    // Its 2^n th power leaves only the largest eigenvalue; of two equal ones it takes a mixture.
    constexpr int n_squares = 10;
    Matrix<dim> power       = (1. / total) * gradient_square;
    for (int i = 0; i < n_squares; ++i)
      {
        power = power * power;
        power *= 1. / trace(power);
      }
    int largest = 0;
    for (int d = 1; d < dim; ++d)
      largest = power(d, d) > power(largest, largest) ? d : largest;
    Vector<dim> direction;
    for (int d = 0; d < dim; ++d)
      direction[d] = power(d, largest);
    direction *= 1. / norm(direction);
    const double eigenvalue = dot(direction, gradient_square * direction);
    return std::sqrt(eigenvalue / (eigenvalue + smallest_gradient * smallest_gradient)) * direction;
  }

  template class SharpFraction<2>;
  template class SharpFraction<3>;
} // namespace magmpm
