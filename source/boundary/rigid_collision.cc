#include <magmpm/boundary/rigid_collision.h>
#include <magmpm/boundary/touched_nodes.h>
#include <magmpm/parallel/reduce.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr int max_iterations = 20;

    /** Overlaps of bodies below this are left alone: rounding makes them, and motion along a surface. */
    constexpr double tolerated_overlap = 0.01; // of dx

    /** Sums the symmetric matrices and right hand sides of free bodies over the ranks. */
    template <int dim>
    void
    sum_over_ranks(const std::vector<RigidBody<dim>> &bodies,
                   const MPI_Comm communicator,
                   std::vector<RigidEquation<dim>> &equations)
    {
      parallel::Reduction reduction;
      for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].is_free())
          reduction.sum(equations[b]);
      reduction.carry_out(communicator);
      for (RigidEquation<dim> &equation : equations)
        for (int i = 0; i < n_rigid_components<dim>; ++i)
          for (int j = 0; j < i; ++j)
            equation.inertia(j, i) = equation.inertia(i, j);
    }

    /** Whether nothing touches the bodies. */
    template <int dim>
    bool
    are_zero(const std::vector<RigidEquation<dim>> &equations)
    {
      return std::all_of(equations.begin(), equations.end(), [](const auto &equation) {
        return frobenius_norm(equation.inertia) == 0. && norm(equation.momentum) == 0.;
      });
    }

    /** Adds what the bodies themselves are. */
    template <int dim>
    void
    add_bodies(const std::vector<RigidBody<dim>> &bodies,
               std::vector<RigidEquation<dim>> &equations)
    {
      for (std::size_t b = 0; b < bodies.size(); ++b)
        {
          if (!bodies[b].is_free())
            continue;
          const auto inertia = bodies[b].inertia();
          for (int d = 0; d < dim; ++d)
            equations[b].inertia(d, d) += bodies[b].mass();
          for (int k = 0; k < n_axial_components<dim>; ++k)
            for (int l = 0; l < n_axial_components<dim>; ++l)
              equations[b].inertia(dim + k, dim + l) += inertia(k, l);
          equations[b].momentum += rigid_vector<dim>(bodies[b].mass() * bodies[b].motion().velocity,
                                                     bodies[b].angular_momentum());
        }
    }

    /** The largest change of the velocity of a point of a free body, and the largest velocity. */
    template <int dim>
    bool
    is_converged(const std::vector<RigidBody<dim>> &bodies,
                 const std::vector<RigidVector<dim>> &before,
                 const std::vector<RigidVector<dim>> &now)
    {
      double change = 0., size = 0.;
      for (std::size_t b = 0; b < bodies.size(); ++b)
        {
          const auto speed = [&](const RigidVector<dim> &vector) {
            const RigidMotion<dim> motion = motion_of<dim>(vector);
            return norm(motion.velocity) +
                   bodies[b].bounding_radius() * norm(motion.angular_velocity);
          };
          change = std::max(change, speed(now[b] - before[b]));
          size   = std::max({size, speed(now[b]), speed(before[b])});
        }
      return change <= 1e-10 * size;
    }
  } // namespace

  template <int dim>
  RigidCollision<dim>::RigidCollision(const Lattice<dim> &lattice,
                                      const WallParameters<dim> &walls,
                                      const std::vector<RigidBody<dim>> &bodies,
                                      const double spacing_of_points)
    : lattice(lattice)
    , search(lattice, walls, bodies, spacing_of_points)
  {
  }

  template <int dim>
  int
  RigidCollision<dim>::collide(const BlockSet<dim> &blocks,
                               const LatticeBoundary<dim> &boundary,
                               const double time_step,
                               const MPI_Comm communicator,
                               const std::vector<CollidingGroup<dim>> &groups,
                               std::vector<RigidBody<dim>> &bodies) const
  {
    if (std::none_of(bodies.begin(), bodies.end(), [](const auto &body) { return body.is_free(); }))
      return 0;
    const std::vector<RigidContact<dim>> contacts = search.find(bodies, time_step);
    separate_overlaps(contacts, tolerated_overlap * lattice.spacing, bodies);

    std::vector<TouchedNodes<dim>> nodes;
    for (const CollidingGroup<dim> &group : groups)
      nodes.emplace_back(bodies, group.contact, blocks, lattice, group.field);
    std::vector<RigidVector<dim>> motions(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b)
      motions[b] = rigid_vector<dim>(bodies[b].motion().velocity,
                                     bodies[b].motion().angular_velocity);
    int iteration = 0;
    for (bool converged = false; !converged && iteration < max_iterations; ++iteration)
      {
        std::vector<RigidEquation<dim>> equations(bodies.size());
        for (std::size_t g = 0; g < groups.size(); ++g)
          {
            nodes[g].update_shares(bodies, motions);
            nodes[g].add_to(equations);
            for (std::size_t b = 0; b < bodies.size(); ++b)
              equations[b].momentum += groups[g].contact.impulses()[b];
          }
        sum_over_ranks(bodies, communicator, equations);
        if (iteration == 0 && contacts.empty() && are_zero(equations))
          return 1;
        add_bodies(bodies, equations);
        const std::vector<RigidVector<dim>> before = motions;
        motions   = solve_contacts(bodies, contacts, equations, time_step);
        converged = is_converged(bodies, before, motions);
      }
    // With the shares of the last equations: then momentum is conserved, converged or not.
    for (std::size_t g = 0; g < groups.size(); ++g)
      nodes[g].apply(motions, blocks, boundary, groups[g].field, groups[g].unconstrained);
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (bodies[b].is_free())
        bodies[b].set_motion(motion_of<dim>(motions[b]));
    return iteration;
  }

  template class RigidCollision<2>;
  template class RigidCollision<3>;
} // namespace magmpm
