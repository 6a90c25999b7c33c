#include <magmpm/base/number_text.h>
#include <magmpm/parallel/gather.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/box_faces.h>
#include <magmpm/particles/particle_migration.h>
#include <magmpm/simulation/domain_decomposition.h>

#include <algorithm>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /**
     * When the mesh changes it is made for the time in which the fastest particle goes this way. Every
     * change costs the set-up of a solve; every block more costs unknowns in all solves to come.
     */
    constexpr double foreseen_way = 4.; // in dx

    /** Particles are grouped again before any of them can have left the arena of its block. */
    constexpr double tolerated_drift = 0.99; // in dx

    template <int dim>
    std::string
    describe(const Departure<dim> &departure, const std::string &body)
    {
      std::ostringstream text;
      text << "particle " << departure.id << " of body '" << body << "' through '"
           << (departure.face % 2 == 0 ? "Lower " : "Upper ") << "xyz"[departure.face / 2]
           << "', to (" << components(departure.position) << ") m with a velocity of ("
           << components(departure.velocity) << ") m/s";
      return text.str();
    }
  } // namespace

  std::string
  report(const Regrouping &regrouping, const double time)
  {
    const bool one = (regrouping.n_lost == 1);
    std::ostringstream text;
    text << regrouping.n_lost << (one ? " particle has" : " particles have")
         << " left the box by t = " << time << " s: " << (one ? "" : "one is ")
         << regrouping.first_lost << ".";
    return text.str();
  }

  std::string
  report(const MeshAdaptation &mesh, const int n_ranks)
  {
    return "load imbalance " + three_digits(mesh.imbalance_before) + " on " +
           std::to_string(n_ranks) + " ranks: cells and particles dealt out anew, now " +
           three_digits(mesh.imbalance);
  }

  template <int dim>
  bool
  DomainDecomposition<dim>::regrouping_is_due() const
  {
    return drift > tolerated_drift * lattice.spacing;
  }

  template <int dim>
  DomainDecomposition<dim>::DomainDecomposition(const Parameters<dim> &parameters,
                                                const MPI_Comm communicator)
    : lattice(parameters.lattice)
    , open_faces(parameters.walls.open_faces())
    , communicator(communicator)
    , has_force(parameters.mesh.carries_potential)
    , background_mesh(communicator, parameters.lattice, parameters.mesh)
    , block_partition(background_mesh)
  {
  }

  template <int dim>
  Regrouping
  DomainDecomposition<dim>::regroup(std::vector<Body<dim>> &bodies)
  {
    std::size_t n_lost = 0;
    std::string first_lost;
    for (Body<dim> &body : bodies)
      {
        const std::vector<Departure<dim>> departed = remove_departed(lattice, open_faces, body);
        if (n_lost == 0 && !departed.empty())
          first_lost = describe(departed.front(), body.name);
        n_lost += departed.size();
      }
    n_lost = parallel::sum(n_lost, communicator);
    if (n_lost > 0)
      for (const std::string &text : parallel::all_gather(first_lost, communicator))
        if (first_lost.empty())
          first_lost = text;

    const OccupiedBlocks<dim> occupied = occupied_blocks(bodies, lattice, has_force);
    Regrouping done;
    done.mesh = background_mesh.adapt(occupied.blocks, occupied.n_particles, blocks_ahead(bodies));
    done.n_migrated = parallel::sum(migrate_to_owners(occupied, bodies), communicator);
    block_partition.rebuild(occupied_blocks(bodies, lattice, has_force).blocks);
    for (Body<dim> &body : bodies)
      sort_into_blocks(blocks(), lattice, body);
    drift           = 0.;
    done.n_lost     = n_lost;
    done.first_lost = first_lost;
    return done;
  }

  template <int dim>
  std::vector<Index<dim>>
  DomainDecomposition<dim>::blocks_ahead(const std::vector<Body<dim>> &bodies) const
  {
    double speed = 0.;
    for (const Body<dim> &body : bodies)
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        speed = std::max(speed, norm(body.particles.vector(ParticleProperty::velocity, p)));
    speed = parallel::max(speed, communicator);
    if (speed == 0.)
      return {};
    return approached_blocks<dim>(
      bodies, lattice, foreseen_way * lattice.spacing / speed, has_force);
  }

  template <int dim>
  std::size_t
  DomainDecomposition<dim>::migrate_to_owners(const OccupiedBlocks<dim> &occupied,
                                              std::vector<Body<dim>> &bodies) const
  {
    const BlockSet<dim> occupied_set(occupied.blocks, static_cast<int>(occupied.blocks.size()));
    const std::vector<unsigned int> owners = background_mesh.owners(occupied.blocks);
    std::vector<std::vector<unsigned int>> destinations;
    std::vector<ParticleSet<dim> *> sets;
    for (Body<dim> &body : bodies)
      {
        sets.push_back(&body.particles);
        std::vector<unsigned int> &of_body = destinations.emplace_back(body.particles.size());
        for (std::size_t p = 0; p < of_body.size(); ++p)
          of_body[p] =
            owners[occupied_set.slot(block_of<dim>(lattice.base_node(body.particles.position(p))))];
      }
    return migrate_particles(communicator, destinations, sets);
  }

  template class DomainDecomposition<2>;
  template class DomainDecomposition<3>;
} // namespace magmpm
