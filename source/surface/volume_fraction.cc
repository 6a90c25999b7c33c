#include <magmpm/parallel/reduce.h>

#include <magmpm/lattice/bspline.h>
#include <magmpm/particles/particle_quantities.h>
#include <magmpm/surface/volume_fraction.h>

#include <algorithm>
#include <limits>

namespace magmpm
{
  namespace
  {
    /** Sets first and count so that the nodes of all particles, and one more, lie in the box. */
    template <int dim>
    void
    set_box(const Body<dim> &body,
            const Lattice<dim> &lattice,
            const MPI_Comm communicator,
            VolumeFraction<dim> &fraction)
    {
      // Lower corners, and upper ones with the sign changed, so that one minimum does for both.
      std::vector<int> corners(2 * dim, std::numeric_limits<int>::max());
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        {
          const Index<dim> base = lattice.base_node(body.particles.position(p));
          for (int d = 0; d < dim; ++d)
            {
              corners[d]       = std::min(corners[d], base[d] - 1);
              corners[dim + d] = std::min(corners[dim + d], -(base[d] + stencil_width));
            }
        }
      corners = parallel::min(corners, communicator);
      if (corners[0] == std::numeric_limits<int>::max())
        return;
      for (int d = 0; d < dim; ++d)
        {
          fraction.first[d] = corners[d];
          fraction.count[d] = -corners[dim + d] - corners[d] + 1;
        }
    }

    /** The place in VolumeFraction::values of a node. */
    template <int dim>
    std::size_t
    place_of(const VolumeFraction<dim> &fraction, const Index<dim> &node)
    {
      std::size_t place = 0;
      for (int d = dim - 1; d >= 0; --d)
        place = place * fraction.count[d] + (node[d] - fraction.first[d]);
      return place;
    }
  } // namespace

  template <int dim>
  VolumeFraction<dim>
  volume_fraction(const Body<dim> &body, const Lattice<dim> &lattice, const MPI_Comm communicator)
  {
    VolumeFraction<dim> fraction;
    set_box(body, lattice, communicator, fraction);
    std::size_t n_nodes = 1;
    for (int d = 0; d < dim; ++d)
      n_nodes *= fraction.count[d];
    fraction.values.assign(n_nodes, 0.);

    const double cell_volume = std::pow(lattice.spacing, dim);
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      {
        const Vector<dim> x   = body.particles.position(p);
        const Index<dim> base = lattice.base_node(x);
        double weights[dim][stencil_width];
        for (int d = 0; d < dim; ++d)
          quadratic_bspline(lattice.reduced(x)[d] - base[d], weights[d]);
        const double part = particle_volume_ratio(body, p) *
                            body.particles.component(ParticleProperty::volume, 0)[p] / cell_volume;
        for (int i = 0; i < power(stencil_width, dim); ++i)
          {
            Index<dim> node = base;
            double weight   = part;
            for (int d = 0, rest = i; d < dim; ++d, rest /= stencil_width)
              {
                node[d] += rest % stencil_width;
                weight *= weights[d][rest % stencil_width];
              }
            fraction.values[place_of<dim>(fraction, node)] += weight;
          }
      }

    const bool is_first = parallel::rank(communicator) == 0;
    MPI_Reduce(is_first ? MPI_IN_PLACE : fraction.values.data(),
               fraction.values.data(),
               static_cast<int>(n_nodes),
               MPI_DOUBLE,
               MPI_SUM,
               0,
               communicator);
    return fraction;
  }

  template VolumeFraction<2>
  volume_fraction(const Body<2> &, const Lattice<2> &, MPI_Comm);
  template VolumeFraction<3>
  volume_fraction(const Body<3> &, const Lattice<3> &, MPI_Comm);
} // namespace magmpm
