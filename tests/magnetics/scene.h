#pragma once

#include <magmpm/lattice/bspline.h>
#include <magmpm/magnetics/potential_problem.h>
#include <magmpm/materials/magnetization.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/reduce.h>

#include <cstdio>
#include <functional>
#include <string>
#include <unordered_map>

namespace magmpm::test
{
  /** A body of one material, given by its points. */
  template <int dim>
  struct TestBody
  {
    std::function<bool(const Vector<dim> &)> contains;
    Vector<dim> lower, upper; ///< of a box around it [m]
    MagneticContent material;
  };

  template <int dim>
  TestBody<dim>
  sphere(const Vector<dim> &centre, const double radius, const MagneticContent &material)
  {
    TestBody<dim> body;
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
  TestBody<dim>
  box(const Vector<dim> &lower, const Vector<dim> &upper, const MagneticContent &material)
  {
    TestBody<dim> body;
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

  /** A particle: its volume counts, whatever its distance to others. */
  template <int dim>
  struct TestParticle
  {
    Vector<dim> position; ///< [m]
    double volume;        ///< over that of a lattice cell [-]
    MagneticContent material;
  };

  /**
   * Bodies on a mesh without particles: node fields as P2G would make them of very many particles,
   * by sampling the bodies on a regular grid of points.
   */
  template <int dim>
  class Scene
  {
  public:
    /**
     * @param n_cells    lattice cells along an edge of the mechanical box; its corner is the origin.
     * @param factor     of the potential box.
     * @param cell_edge  of the potential's cells, in dx.
     */
    Scene(const int n_cells,
          const double spacing,
          const double factor,
          const MagneticsParameters<dim> &magnetics,
          const std::array<bool, 2 *dim> &shielded = {},
          const int cell_edge                      = 2)
      : lattice(make_lattice(n_cells, spacing))
      , mesh(MPI_COMM_WORLD, lattice, make_mesh_parameters(factor, shielded, cell_edge))
      , partition(mesh)
      , problem(mesh, partition, with_shields(magnetics, shielded), timer)
    {
    }

    /** Puts bodies in place of those before; mesh, partition and node fields follow. Collective. */
    void
    set_bodies(const std::vector<TestBody<dim>> &bodies, const int samples_per_cell_edge = 5);

    /** The same with single particles. Collective; all ranks give the same. */
    void
    set_particles(const std::vector<TestParticle<dim>> &particles);

    const Lattice<dim> lattice;
    BackgroundMesh<dim> mesh;
    BlockPartition<dim> partition;
    parallel::PhaseTimer timer;
    PotentialProblem<dim> problem;
    NodeField<dim> content; ///< {v, density of M_s, density of chi_0, 1}
    NodeField<dim> mass;    ///< lane 3: v dx^dim, as of density 1

    /** Sum over the nodes of all ranks of weight(position) times a lane of @p field. */
    double
    sum(
      const NodeField<dim> &field,
      const int lane,
      const std::function<double(const Vector<dim> &)> &weight = [](const auto &) {
        return 1.;
      }) const
    {
      double result = 0.;
      for_owned_nodes([&](const int slot, const int node, const Vector<dim> &position) {
        result += weight(position) * field.node(slot, node)[lane];
      });
      return parallel::sum(result, MPI_COMM_WORLD);
    }

    template <typename Action>
    void
    for_owned_nodes(const Action &action) const
    {
      for (int slot = 0; slot < partition.blocks().n_owned(); ++slot)
        for (int node = 0; node < nodes_per_block<dim>; ++node)
          action(slot,
                 node,
                 lattice.node_position(node_of_block<dim>(partition.blocks().block(slot), node)));
    }

  private:
    static Lattice<dim>
    make_lattice(const int n_cells, const double spacing)
    {
      Lattice<dim> lattice;
      lattice.spacing = spacing;
      lattice.n_cells.fill(n_cells);
      return lattice;
    }

    static MeshParameters<dim>
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

    static MagneticsParameters<dim>
    with_shields(MagneticsParameters<dim> parameters, const std::array<bool, 2 * dim> &shielded)
    {
      parameters.shielded = shielded;
      return parameters;
    }

    /** Blocks with particles and the particles in each. */
    struct Samples
    {
      std::vector<Index<dim>> blocks;
      std::unordered_map<std::uint64_t, std::vector<TestParticle<dim>>> of_block;

      void
      add(const Lattice<dim> &lattice, const TestParticle<dim> &particle);
    };

    Samples
    sample(const std::vector<TestBody<dim>> &bodies, const int per_edge) const;

    void
    set_samples(const Samples &samples);

    void
    scatter(const TestParticle<dim> &sample);
  };

  template <int dim>
  void
  Scene<dim>::Samples::add(const Lattice<dim> &lattice, const TestParticle<dim> &particle)
  {
    Index<dim> cell;
    for (int d = 0; d < dim; ++d)
      cell[d] = static_cast<int>(std::floor(particle.position[d] / lattice.spacing));
    auto &list = of_block[block_key<dim>(block_of<dim>(cell))];
    if (list.empty())
      blocks.push_back(block_of<dim>(cell));
    list.push_back(particle);
  }

  template <int dim>
  typename Scene<dim>::Samples
  Scene<dim>::sample(const std::vector<TestBody<dim>> &bodies, const int per_edge) const
  {
    Samples samples;
    const double distance = lattice.spacing / per_edge;
    for (const TestBody<dim> &body : bodies)
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
            TestParticle<dim> sample = {{}, std::pow(1. / per_edge, dim), body.material};
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
  Scene<dim>::set_bodies(const std::vector<TestBody<dim>> &bodies, const int per_edge)
  {
    set_samples(sample(bodies, per_edge));
  }

  template <int dim>
  void
  Scene<dim>::set_particles(const std::vector<TestParticle<dim>> &particles)
  {
    Samples samples;
    for (const TestParticle<dim> &particle : particles)
      samples.add(lattice, particle);
    set_samples(samples);
  }

  template <int dim>
  void
  Scene<dim>::set_samples(const Samples &samples)
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
      for (const TestParticle<dim> &sample : samples.of_block.at(block_key<dim>(block)))
        scatter(sample);
    partition.add_ghosts_to_owners(content);
    partition.update_ghosts(content);
    partition.add_ghosts_to_owners(mass);
    partition.update_ghosts(mass);
  }

  template <int dim>
  void
  Scene<dim>::scatter(const TestParticle<dim> &sample)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    const Index<dim> base       = lattice.base_node(sample.position);
    const Vector<dim> reduced   = lattice.reduced(sample.position);
    double weights[dim][stencil_width];
    for (int d = 0; d < dim; ++d)
      quadratic_bspline(reduced[d] - base[d], weights[d]);

    for (int i = 0; i < power(stencil_width, dim); ++i)
      {
        double weight = sample.volume;
        Index<dim> node;
        for (int d = 0, rest = i; d < dim; ++d, rest /= stencil_width)
          {
            node[d] = base[d] + rest % stencil_width;
            weight *= weights[d][rest % stencil_width];
          }
        const Index<dim> block = block_of<dim>(node);
        const int other        = blocks.slot(block);
        int number             = 0;
        for (int d = dim - 1; d >= 0; --d)
          number = block_edge * number + node[d] - block_edge * block[d];
        double *lanes = content.node(other, number);
        lanes[0] += weight;
        lanes[1] += weight * sample.material.saturation_magnetization;
        lanes[2] += weight * sample.material.initial_susceptibility;
        lanes[3] += weight;
        mass.node(other, number)[n_lanes - 1] += weight * std::pow(lattice.spacing, dim);
      }
  }

  /** Prints a line of figures, once. */
  template <typename... Numbers>
  void
  print_once(const char *format, const Numbers... numbers)
  {
    if (parallel::rank(MPI_COMM_WORLD) == 0)
      {
        std::printf(format, numbers...);
        std::printf("\n");
      }
  }

  /** "1; 2; 3" for a parameter. */
  template <int dim>
  std::string
  vector_text(const Vector<dim> &v)
  {
    std::string text;
    char number[64];
    for (int d = 0; d < dim; ++d)
      {
        std::snprintf(number, sizeof(number), "%.17g", v[d]);
        text += (d == 0 ? "" : "; ") + std::string(number);
      }
    return text;
  }

  /** What the magnetic force does to the nodes of all ranks. */
  template <int dim>
  struct Force
  {
    Vector<dim> total, dropped;
    double absolute = 0.; ///< sum over the nodes of |f_i|

    Vector<n_axial_components<dim>> torque; ///< about @p centre
  };

  template <int dim>
  Force<dim>
  force_on_nodes(const Scene<dim> &scene, const Vector<dim> &centre)
  {
    Force<dim> result;
    NodeField<dim> force;
    result.dropped = scene.problem.compute_force(scene.mass, force);
    scene.for_owned_nodes([&](const int slot, const int node, const Vector<dim> &x) {
      Vector<dim> f;
      std::copy_n(force.node(slot, node), dim, f.values);
      result.total += f;
      result.torque += cross(x - centre, f);
      result.absolute += norm(f);
    });
    const auto sum = [](double &value) { value = parallel::sum(value, MPI_COMM_WORLD); };
    for (double &component : result.total.values)
      sum(component);
    for (double &component : result.torque.values)
      sum(component);
    sum(result.absolute);
    return result;
  }

  template <int dim>
  SourceParameters<dim>
  uniform_source(const Vector<dim> &field)
  {
    SourceParameters<dim> source;
    source.name  = "uniform";
    source.type  = SourceType::uniform_field;
    source.field = vector_text(field);
    return source;
  }

  template <int dim>
  SourceParameters<dim>
  sphere_source(const Vector<dim> &centre, const double radius, const Vector<dim> &magnetization)
  {
    SourceParameters<dim> source;
    source.name          = "magnet";
    source.type          = SourceType::magnetized_sphere;
    source.position      = vector_text(centre);
    source.magnetization = vector_text(magnetization);
    source.radius        = radius;
    return source;
  }
} // namespace magmpm::test
