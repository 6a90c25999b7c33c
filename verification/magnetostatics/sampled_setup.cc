#include <magmpm/lattice/bspline.h>
#include <magmpm/parallel/reduce.h>

#include <verification/magnetostatics/sampled_setup.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    template <int dim>
    Lattice<dim>
    make_lattice(const int n_cells, const double spacing)
    {
      Lattice<dim> lattice;
      lattice.spacing = spacing;
      lattice.n_cells.fill(n_cells);
      return lattice;
    }

    template <int dim>
    MeshParameters<dim>
    make_mesh_parameters(const double factor,
                         const std::array<bool, 2 * dim> &shielded,
                         const int cell_edge)
    {
      MeshParameters<dim> parameters;
      parameters.potential_box_factor = factor;
      parameters.shielded             = shielded;
      parameters.cell_edge            = cell_edge;
      return parameters;
    }

    template <int dim>
    MagneticsParameters<dim>
    with_shields(MagneticsParameters<dim> parameters, const std::array<bool, 2 * dim> &shielded)
    {
      parameters.shielded = shielded;
      return parameters;
    }
  } // namespace

  template <int dim>
  SampledBody<dim>
  sphere(const Vector<dim> &centre, const double radius, const MagneticContent &material)
  {
    SampledBody<dim> body;
    body.contains = [=](const Vector<dim> &x) { return norm(x - centre) < radius; };
    for (int d = 0; d < dim; ++d)
      {
        body.lower[d] = centre[d] - radius;
        body.upper[d] = centre[d] + radius;
      }
    body.material = material;
    return body;
  }

  template <int dim>
  SampledBody<dim>
  box(const Vector<dim> &lower, const Vector<dim> &upper, const MagneticContent &material)
  {
    SampledBody<dim> body;
    body.contains = [=](const Vector<dim> &x) {
      for (int d = 0; d < dim; ++d)
        if (x[d] < lower[d] || x[d] > upper[d])
          return false;
      return true;
    };
    body.lower    = lower;
    body.upper    = upper;
    body.material = material;
    return body;
  }

  template <int dim>
  SampledSetup<dim>::SampledSetup(const int n_cells,
                                  const double spacing,
                                  const double factor,
                                  const MagneticsParameters<dim> &magnetics,
                                  const std::array<bool, 2 * dim> &shielded,
                                  const int cell_edge)
    : MagneticSetup<dim>(MPI_COMM_WORLD,
                         make_lattice<dim>(n_cells, spacing),
                         make_mesh_parameters<dim>(factor, shielded, cell_edge),
                         with_shields(magnetics, shielded))
  {
  }

  template <int dim>
  void
  SampledSetup<dim>::SortedSamples::add(const Lattice<dim> &lattice, const Sample<dim> &sample)
  {
    Index<dim> cell;
    for (int d = 0; d < dim; ++d)
      cell[d] = static_cast<int>(std::floor(sample.position[d] / lattice.spacing));
    auto &list = of_block[block_key<dim>(block_of<dim>(cell))];
    if (list.empty())
      blocks.push_back(block_of<dim>(cell));
    list.push_back(sample);
  }

  template <int dim>
  typename SampledSetup<dim>::SortedSamples
  SampledSetup<dim>::sample(const std::vector<SampledBody<dim>> &bodies, const int per_edge) const
  {
    SortedSamples samples;
    const double distance = lattice.spacing / per_edge;
    for (const SampledBody<dim> &body : bodies)
      {
        Index<dim> first, n;
        int total = 1;
        for (int d = 0; d < dim; ++d)
          {
            first[d] = static_cast<int>(std::floor(body.lower[d] / distance));
            n[d]     = static_cast<int>(std::ceil(body.upper[d] / distance)) - first[d];
            total *= n[d];
          }
        for (int i = 0; i < total; ++i)
          {
            Sample<dim> sample = {{}, std::pow(1. / per_edge, dim), body.material};
            for (int d = 0, rest = i; d < dim; ++d, rest /= n[d - 1])
              sample.position[d] = (first[d] + rest % n[d] + 0.5) * distance;
            if (body.contains(sample.position))
              samples.add(lattice, sample);
          }
      }
    return samples;
  }

  template <int dim>
  void
  SampledSetup<dim>::set_bodies(const std::vector<SampledBody<dim>> &bodies, const int per_edge)
  {
    set_samples(sample(bodies, per_edge));
  }

  template <int dim>
  void
  SampledSetup<dim>::set_particles(const std::vector<Sample<dim>> &particles)
  {
    SortedSamples samples;
    for (const Sample<dim> &particle : particles)
      samples.add(lattice, particle);
    set_samples(samples);
  }

  template <int dim>
  void
  SampledSetup<dim>::set_samples(const SortedSamples &samples)
  {
    // Every rank knows all samples, tells the mesh of its share, and scatters those it owns.
    const std::vector<Index<dim>> &blocks = samples.blocks;
    const unsigned int rank               = parallel::rank(MPI_COMM_WORLD);
    const unsigned int n_ranks            = parallel::n_ranks(MPI_COMM_WORLD);
    std::vector<Index<dim>> share;
    for (std::size_t b = rank; b < blocks.size(); b += n_ranks)
      share.push_back(blocks[b]);
    mesh.adapt(share, std::vector<unsigned int>(share.size(), 512));

    const std::vector<unsigned int> owners = mesh.owners(blocks);
    std::vector<Index<dim>> occupied;
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (owners[b] == rank)
        occupied.push_back(blocks[b]);
    partition.rebuild(occupied);

    content.reinit(partition.blocks().size());
    mass.reinit(partition.blocks().size());
    for (const Index<dim> &block : occupied)
      for (const Sample<dim> &sample : samples.of_block.at(block_key<dim>(block)))
        scatter(sample);
    partition.add_ghosts_to_owners(content, Parity());
    partition.update_ghosts(content);
    partition.add_ghosts_to_owners(mass);
    partition.update_ghosts(mass);
  }

  template <int dim>
  void
  SampledSetup<dim>::scatter(const Sample<dim> &sample)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    for_stencil(lattice, sample.position, [&](const Index<dim> &node, const double spline) {
      const double weight = sample.volume * spline;
      const int slot      = blocks.slot(block_of<dim>(node));
      const int number    = number_in_block<dim>(node);
      content.add(NodeContent::volume, slot, number, weight);
      content.add(
        NodeContent::saturation, slot, number, weight * sample.material.saturation_magnetization);
      content.add(
        NodeContent::susceptibility, slot, number, weight * sample.material.initial_susceptibility);
      content.add(NodeContent::grains, slot, number, weight);
      mass.add(SingleScalar::value, slot, number, weight * std::pow(lattice.spacing, dim));
    });
  }

  template <int dim>
  Force<dim>
  force_on_nodes(const SampledSetup<dim> &setup, const Vector<dim> &centre)
  {
    Force<dim> result;
    NodeField<dim, SingleVector> force;
    result.dropped = setup.problem.compute_force(setup.mass, force);
    setup.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
      const Vector<dim> f = force.get(SingleVector::value, slot, node);
      result.total += f;
      result.torque += cross(x - centre, f);
      result.absolute += norm(f);
    });
    parallel::Reduction reduction;
    reduction.sum(result.total);
    reduction.sum(result.torque);
    reduction.sum(result.absolute);
    reduction.carry_out(MPI_COMM_WORLD);
    return result;
  }

#define MAGMPM_INSTANTIATE(dim)                                                                 \
  template class SampledSetup<dim>;                                                             \
  template SampledBody<dim> sphere(const Vector<dim> &, const double, const MagneticContent &); \
  template SampledBody<dim> box(                                                                \
    const Vector<dim> &, const Vector<dim> &, const MagneticContent &);                         \
  template Force<dim> force_on_nodes(const SampledSetup<dim> &, const Vector<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm::verification
