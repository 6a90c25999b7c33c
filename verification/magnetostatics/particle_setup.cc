#include <magmpm/coupling/carried_force.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/particles/magnetic_transfer.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_migration.h>
#include <magmpm/particles/particle_state.h>

#include <verification/magnetostatics/particle_setup.h>

namespace magmpm::verification
{
  namespace
  {
    constexpr double density = 1000.; ///< undeformed [kg/m^3]; no figure depends on it

    template <int dim>
    BodyParameters<dim>
    body_parameters()
    {
      BodyParameters<dim> parameters;
      parameters.density = density;
      return parameters;
    }

    MaterialParameters
    elastic_material(const MagneticParameters &magnetic)
    {
      MaterialParameters material;
      material.law           = MechanicalLaw::neo_hookean;
      material.shear_modulus = 1e5;
      material.lame_lambda   = 1e5;
      material.magnetic      = magnetic;
      return material;
    }
  } // namespace

  template <int dim>
  void
  ParticleSetup<dim>::set_bodies(const std::vector<PointBody<dim>> &point_bodies)
  {
    bodies.clear();
    for (const PointBody<dim> &point_body : point_bodies)
      seed(point_body);
    distribute_particles();
  }

  template <int dim>
  void
  ParticleSetup<dim>::seed(const PointBody<dim> &point_body)
  {
    bodies.emplace_back(body_parameters<dim>(), elastic_material(point_body.magnetic));
    ParticleSet<dim> &particles = bodies.back().particles;
    const std::size_t rank      = parallel::rank(communicator);
    const std::size_t n_ranks   = parallel::n_ranks(communicator);
    const std::size_t n         = point_body.points.size();
    const double volume         = point_body.volume / n / determinant(point_body.deformation);
    for (std::size_t i = n * rank / n_ranks; i < n * (rank + 1) / n_ranks; ++i)
      {
        const std::size_t p = particles.size();
        particles.resize(p + 1);
        particles.ids()[p] = i;
        for (int d = 0; d < dim; ++d)
          particles.component(ParticleProperty::position, d)[p] = point_body.points[i][d];
        for (int k = 0; k < dim * dim; ++k)
          particles.component(ParticleProperty::deformation,
                              k)[p] = point_body.deformation(k / dim, k % dim);
        particles.component(ParticleProperty::volume, 0)[p] = volume;
        particles.component(ParticleProperty::mass, 0)[p]   = density * volume;
      }
  }

  template <int dim>
  void
  ParticleSetup<dim>::distribute_particles()
  {
    const OccupiedBlocks<dim> occupied = occupied_blocks(bodies, lattice, true);
    mesh.adapt(occupied.blocks, occupied.n_particles);

    const BlockSet<dim> blocks(occupied.blocks, static_cast<int>(occupied.blocks.size()));
    const std::vector<unsigned int> owners = mesh.owners(occupied.blocks);
    for (Body<dim> &body : bodies)
      {
        std::vector<unsigned int> destination(body.particles.size());
        for (std::size_t p = 0; p < destination.size(); ++p)
          destination[p] =
            owners[blocks.slot(block_of<dim>(lattice.base_node(body.particles.position(p))))];
        migrate_particles<dim>(communicator, {destination}, {&body.particles});
      }
    partition.rebuild(occupied_blocks(bodies, lattice, true).blocks);
    for (Body<dim> &body : bodies)
      sort_into_blocks(partition.blocks(), lattice, body);
  }

  template <int dim>
  SolveReport
  ParticleSetup<dim>::solve(const ExternalField<dim> &sources)
  {
    const SolveReport report                = problem.solve(magnetic_content(), sources);
    const NodeField<dim, SingleScalar> mass = node_mass();
    problem.compute_force(mass, node_force);
    hand_force_to_particles(mass);
    medium.clear();
    return report;
  }

  template <int dim>
  const std::vector<MaterialSample<dim>> &
  ParticleSetup<dim>::samples() const
  {
    if (medium.empty())
      medium = problem.material_samples();
    return medium;
  }

  template <int dim>
  NodeField<dim, NodeContent>
  ParticleSetup<dim>::magnetic_content()
  {
    NodeField<dim, NodeContent> content(partition.blocks().size());
    magnetic_content_to_lattice(bodies, partition.blocks(), lattice, content);
    partition.add_ghosts_to_owners(content, Parity());
    partition.update_ghosts(content);
    return content;
  }

  template <int dim>
  NodeField<dim, SingleScalar>
  ParticleSetup<dim>::node_mass()
  {
    NodeField<dim, SingleScalar> mass(partition.blocks().size());
    magnetic_mass_to_lattice(bodies, partition.blocks(), lattice, mass);
    partition.add_ghosts_to_owners(mass, Parity());
    partition.update_ghosts(mass);
    return mass;
  }

  template <int dim>
  void
  ParticleSetup<dim>::hand_force_to_particles(const NodeField<dim, SingleScalar> &mass)
  {
    carry_force(partition, lattice, mass, node_force, bodies);
  }

  template <int dim>
  Vector<dim>
  ParticleSetup<dim>::force() const
  {
    Vector<dim> sum;
    for_nodes(partition.blocks(), [&](const int slot, const int n) {
      sum += node_force.get(SingleVector::value, slot, n);
    });
    return parallel::sum(sum, communicator);
  }

  template <int dim>
  template <typename Action>
  void
  ParticleSetup<dim>::for_all_forces_of_particles(const std::size_t body,
                                                  const Action &action) const
  {
    const ParticleSet<dim> &particles = bodies[body].particles;
    const double *const mass          = particles.component(ParticleProperty::mass, 0);
    for (std::size_t p = 0; p < particles.size(); ++p)
      action(mass[p] * particles.vector(ParticleProperty::magnetic_acceleration, p),
             particles.position(p));
  }

  template <int dim>
  Vector<dim>
  ParticleSetup<dim>::force_on_body(const std::size_t body) const
  {
    Vector<dim> sum;
    for_all_forces_of_particles(body, [&](const Vector<dim> &f, const Vector<dim> &) { sum += f; });
    return parallel::sum(sum, communicator);
  }

  template <int dim>
  Matrix<dim>
  ParticleSetup<dim>::virial(const Vector<dim> &centre) const
  {
    Matrix<dim> sum;
    for_nodes(partition.blocks(), [&](const int slot, const int n) {
      const Index<dim> node = node_of_block<dim>(partition.blocks().block(slot), n);
      sum += outer(node_force.get(SingleVector::value, slot, n),
                   lattice.node_position(node) - centre);
    });
    return parallel::sum(sum, communicator);
  }

  template <int dim>
  Matrix<dim>
  ParticleSetup<dim>::virial_of_particles(const Vector<dim> &centre) const
  {
    Matrix<dim> sum;
    for (std::size_t body = 0; body < bodies.size(); ++body)
      {
        for_all_forces_of_particles(body, [&](const Vector<dim> &f, const Vector<dim> &x) {
          sum += outer(f, x - centre);
        });
        const auto particles = bodies[body].particles.arrays();
        for (std::size_t p = 0; p < bodies[body].particles.size(); ++p)
          sum += (0.25 * lattice.spacing * lattice.spacing * particles.mass[p]) *
                 load_matrix<dim>(particles.magnetic_acceleration_gradient, p);
      }
    return parallel::sum(sum, communicator);
  }

  template class ParticleSetup<2>;
  template class ParticleSetup<3>;
} // namespace magmpm::verification
