#include <magmpm/boundary/fluid_contact.h>
#include <magmpm/lattice/lattice_node.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace magmpm
{
  namespace
  {
    constexpr int most_sweeps = 150, sweeps_a_round = 3;

    /** It ends when velocities change by less than this part of the largest relative one. */
    constexpr double tolerance = 1e-9;

    template <int dim>
    Vector<dim>
    mirrored(const Vector<dim> &mirror, Vector<dim> vector)
    {
      for (int d = 0; d < dim; ++d)
        vector[d] *= mirror[d];
      return vector;
    }

    /** Inverse mass and inertia of a free body. */
    template <int dim>
    RigidMatrix<dim>
    mobility_of(const RigidBody<dim> &body)
    {
      RigidMatrix<dim> inertia;
      const auto of_rotation = body.inertia();
      for (int d = 0; d < dim; ++d)
        inertia(d, d) = body.mass();
      for (int k = 0; k < n_axial_components<dim>; ++k)
        for (int l = 0; l < n_axial_components<dim>; ++l)
          inertia(dim + k, dim + l) = of_rotation(k, l);
      return inverse(inertia);
    }

    /** x of A x = b; A symmetric, and not negative, directions in which it is next to zero are left out. */
    template <int n>
    Vector<n>
    solved(Matrix<n> a, Vector<n> b)
    {
      Vector<n> scale;
      for (int i = 0; i < n; ++i)
        scale[i] = (a(i, i) > 0. ? 1. / std::sqrt(a(i, i)) : 0.);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          a(i, j) = scale[i] * a(i, j) * scale[j] + (i == j ? (scale[i] > 0. ? 1e-12 : 1.) : 0.);
      for (int i = 0; i < n; ++i)
        b[i] *= scale[i];
      Vector<n> x = inverse(a) * b;
      for (int i = 0; i < n; ++i)
        x[i] *= scale[i];
      return x;
    }
  } // namespace

  template <int dim>
  FluidContact<dim>::FluidContact(const std::vector<FluidConstraint<dim>> &constraints)
    : constraints(constraints)
  {
    number_nodes();
  }

  template <int dim>
  void
  FluidContact<dim>::number_nodes()
  {
    std::unordered_map<std::uint64_t, int> numbers;
    numbers.reserve(2 * constraints.size());
    now.impulses.resize(constraints.size());
    for (std::size_t i = 0; i < constraints.size(); ++i)
      for (int t = 0; t < constraints[i].n_terms; ++t)
        {
          const FluidTerm<dim> &term = constraints[i].terms[t];
          const auto place           = numbers.emplace(block_key<dim>(term.node),
                                             static_cast<int>(now.nodes.size()));
          if (place.second)
            now.nodes.push_back({term.node, term.mass, term.velocity});
          now.impulses[i].nodes[t] = place.first->second;
        }
  }

  template <int dim>
  void
  FluidContact<dim>::find_mobilities()
  {
    // What each node gets if all constraints have an impulse of one along their normals.
    std::vector<Vector<dim>> pushes(now.nodes.size());
    const auto for_terms = [&](const std::size_t i, const auto &f) {
      for (int t = 0; t < constraints[i].n_terms; ++t)
        f(constraints[i].terms[t],
          mirrored(constraints[i].terms[t].mirror, constraints[i].normal),
          pushes[now.impulses[i].nodes[t]]);
    };
    for (std::size_t i = 0; i < constraints.size(); ++i)
      for_terms(i, [](const FluidTerm<dim> &term, const Vector<dim> &normal, Vector<dim> &push) {
        push += (term.weight / term.mass) * normal;
      });
    for (std::size_t i = 0; i < constraints.size(); ++i)
      {
        const FluidConstraint<dim> &constraint = constraints[i];
        Impulse &impulse                       = now.impulses[i];
        double of_nodes                        = 0.;
        impulse.common                         = 0.;
        for_terms(i, [&](const FluidTerm<dim> &term, const Vector<dim> &normal, Vector<dim> &push) {
          of_nodes += term.weight * term.weight / term.mass;
          impulse.common += term.weight * dot(push, normal);
        });
        impulse.common   = std::max(impulse.common, of_nodes);
        const auto along = [&](const Vector<dim> &direction) {
          const RigidVector<dim> momentum = constraint.weight *
                                            momentum_of(direction, constraint.from_centre);
          return dot(momentum, mobilities[constraint.body] * momentum);
        };
        double of_body = 0.;
        for (int d = 0; d < dim; ++d)
          {
            Vector<dim> axis;
            axis[d] = 1.;
            of_body += along(axis);
          }
        const double of_normal = along(constraint.normal);
        impulse.along_normal   = of_nodes + of_normal;
        impulse.tangential     = of_nodes + std::max(of_body - of_normal, 0.);
        impulse.start          = relative_velocity(now, i);
      }
  }

  template <int dim>
  Vector<dim>
  FluidContact<dim>::relative_velocity(const State &state, const std::size_t i) const
  {
    const FluidConstraint<dim> &constraint = constraints[i];
    Vector<dim> relative =
      (-constraint.weight) *
      motion_of<dim>(state.motions[constraint.body]).velocity_at(constraint.from_centre);
    for (int t = 0; t < constraint.n_terms; ++t)
      relative += constraint.terms[t].weight *
                  mirrored(constraint.terms[t].mirror,
                           state.nodes[state.impulses[i].nodes[t]].velocity);
    return relative;
  }

  template <int dim>
  void
  FluidContact<dim>::add_impulse(const std::size_t i, const Vector<dim> &change, State &state) const
  {
    const FluidConstraint<dim> &constraint = constraints[i];
    state.impulses[i].value += change;
    state.motions[constraint.body] -=
      mobilities[constraint.body] *
      (constraint.weight * momentum_of(change, constraint.from_centre));
    for (int t = 0; t < constraint.n_terms; ++t)
      state.nodes[state.impulses[i].nodes[t]].velocity +=
        (constraint.terms[t].weight / constraint.terms[t].mass) *
        mirrored(constraint.terms[t].mirror, change);
  }

  template <int dim>
  Vector<dim>
  FluidContact<dim>::allowed(const std::size_t i,
                             const Vector<dim> &wanted,
                             ContactShare &active) const
  {
    const SurfaceContact &contact = contacts[constraints[i].body];
    const Vector<dim> &normal     = constraints[i].normal;
    active                        = {1., 1.};
    if (contact.condition == ContactCondition::stick)
      return wanted;
    const double pressing        = dot(wanted, normal);
    const Vector<dim> tangential = wanted - pressing * normal;
    if (contact.condition == ContactCondition::separate && pressing <= 0.)
      {
        active = {};
        return {};
      }
    const double sliding = norm(tangential), most = contact.friction * std::abs(pressing);
    if (sliding <= most && most > 0.)
      return wanted;
    active.tangential = 0.;
    return pressing * normal + (sliding > 0. ? most / sliding : 0.) * tangential;
  }

  template <int dim>
  double
  FluidContact<dim>::sweep()
  {
    double largest = 0.;
    for (std::size_t i = 0; i < constraints.size(); ++i)
      {
        Impulse &impulse           = now.impulses[i];
        const Vector<dim> relative = relative_velocity(now, i);
        const Vector<dim> across   = dot(relative, constraints[i].normal) * constraints[i].normal;
        const Vector<dim> wanted   = impulse.value - (1. / impulse.along_normal) * across -
                                   (1. / impulse.tangential) * (relative - across);
        const Vector<dim> change = allowed(i, wanted, impulse.active) - impulse.value;
        add_impulse(i, change, now);
        largest = std::max(largest, impulse.along_normal * norm(change));
      }
    return largest;
  }

  template <int dim>
  Vector<dim>
  FluidContact<dim>::pattern(const std::size_t i, const int k) const
  {
    RigidVector<dim> motion;
    motion[k] = 1.;
    return (constraints[i].weight / now.impulses[i].common) *
           taken_by(now.impulses[i].active,
                    constraints[i].normal,
                    motion_of<dim>(motion).velocity_at(constraints[i].from_centre));
  }

  template <int dim>
  double
  FluidContact<dim>::energy(const State &state) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < constraints.size(); ++i)
      sum += 0.5 *
             dot(state.impulses[i].value, state.impulses[i].start + relative_velocity(state, i));
    return sum;
  }

  template <int dim>
  void
  FluidContact<dim>::push_together(const int body)
  {
    constexpr int n = n_rigid_components<dim>;
    Matrix<n> stiffness;
    Vector<n> defect;
    for (int k = 0; k < n; ++k)
      {
        State pushed = now;
        for (std::size_t i = 0; i < constraints.size(); ++i)
          if (constraints[i].body == body)
            add_impulse(i, pattern(i, k), pushed);
        for (std::size_t i = 0; i < constraints.size(); ++i)
          if (constraints[i].body == body)
            {
              const Vector<dim> before = relative_velocity(now, i);
              const Vector<dim> change = relative_velocity(pushed, i) - before;
              defect[k] += dot(pattern(i, k), before);
              for (int l = 0; l < n; ++l)
                stiffness(l, k) += dot(pattern(i, l), change);
            }
      }
    const Vector<n> amount = solved(stiffness, (-1.) * defect);
    State pushed           = now;
    for (std::size_t i = 0; i < constraints.size(); ++i)
      if (constraints[i].body == body)
        {
          Vector<dim> wanted = now.impulses[i].value;
          for (int k = 0; k < n; ++k)
            wanted += amount[k] * pattern(i, k);
          const Vector<dim> change = allowed(i, wanted, pushed.impulses[i].active) -
                                     now.impulses[i].value;
          add_impulse(i, change, pushed);
        }
    if (energy(pushed) < energy(now))
      now = pushed;
  }

  template <int dim>
  int
  FluidContact<dim>::solve(std::vector<RigidBody<dim>> &bodies)
  {
    if (constraints.empty())
      return 0;
    for (const RigidBody<dim> &body : bodies)
      {
        const RigidMotion<dim> motion = body.motion();
        now.motions.push_back(rigid_vector<dim>(motion.velocity, motion.angular_velocity));
        contacts.push_back(body.contact());
        mobilities.push_back(body.is_free() ? mobility_of(body) : RigidMatrix<dim>());
      }
    find_mobilities();
    double largest = 0.;
    for (const Impulse &impulse : now.impulses)
      largest = std::max(largest, norm(impulse.start));
    int n_sweeps = 0;
    while (n_sweeps < most_sweeps && sweep() > tolerance * largest)
      if (++n_sweeps % sweeps_a_round == 0)
        for (std::size_t b = 0; b < bodies.size(); ++b)
          if (bodies[b].is_free())
            push_together(static_cast<int>(b));
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (bodies[b].is_free())
        bodies[b].set_motion(motion_of<dim>(now.motions[b]));
    return n_sweeps;
  }

  template <int dim>
  void
  FluidContact<dim>::apply(const BlockSet<dim> &blocks,
                           const LatticeBoundary<dim> &boundary,
                           NodeField<dim> &field,
                           NodeField<dim> &unconstrained) const
  {
    for (const Node &node : now.nodes)
      {
        const auto [slot, number] = lattice_node<dim>(blocks, node.index);
        if (slot == invalid_slot || slot >= blocks.n_owned())
          continue;
        if (unconstrained.n_blocks() > 0)
          unconstrained.set(NodeMotion::velocity, slot, number, node.velocity);
        field.set(
          NodeMotion::velocity, slot, number, boundary.constrained(node.index, node.velocity));
      }
  }

  template class FluidContact<2>;
  template class FluidContact<3>;
} // namespace magmpm
