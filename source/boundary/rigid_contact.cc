#include <magmpm/boundary/rigid_contact.h>

#include <limits>

namespace magmpm
{
  namespace
  {
    /** Contacts at rest are found as well, whatever rounding does to their gaps. */
    constexpr double rest_reach = 0.05; // of the distance between surface points

    constexpr int max_sweeps = 200;

    double
    friction_of(const SurfaceContact &contact)
    {
      return contact.condition == ContactCondition::stick ? std::numeric_limits<double>::infinity()
                                                          : contact.friction;
    }

    /** A contact, how easily it gives way, and its impulse so far. */
    template <int dim>
    struct ContactState
    {
      const RigidContact<dim> &contact;
      Vector<dim> arm, arm_of_other; ///< from the centres of mass [m]
      double normal_impulse = 0.;    ///< [N s]
      Vector<dim> friction_impulse;  ///< [N s]
    };

    /** Sequential impulses. */
    template <int dim>
    class ContactSweep
    {
    public:
      ContactSweep(const std::vector<RigidBody<dim>> &bodies,
                   const std::vector<RigidContact<dim>> &contacts,
                   const std::vector<RigidEquation<dim>> &equations,
                   const double time_step)
        : time_step(time_step)
        , mobility(bodies.size())
        , motions(bodies.size())
      {
        for (std::size_t b = 0; b < bodies.size(); ++b)
          if (bodies[b].is_free())
            {
              mobility[b] = inverse(equations[b].inertia);
              motions[b]  = mobility[b] * equations[b].momentum;
              // Takes back the rounding of the inverse.
              motions[b] += mobility[b] *
                            (equations[b].momentum - equations[b].inertia * motions[b]);
            }
        for (const RigidContact<dim> &contact : contacts)
          states.push_back({contact,
                            contact.point - bodies[contact.body].pose().position,
                            contact.other == RigidContact<dim>::none
                              ? Vector<dim>()
                              : contact.point - bodies[contact.other].pose().position,
                            0.,
                            {}});
      }

      std::vector<RigidVector<dim>>
      run()
      {
        for (int sweep = 0; sweep < max_sweeps; ++sweep)
          {
            double change = 0., size = 0.;
            for (ContactState<dim> &state : states)
              {
                change = std::max({change, press(state), rub(state)});
                size   = std::max(size, state.normal_impulse);
              }
            if (change <= 1e-10 * size)
              break;
          }
        return motions;
      }

    private:
      Vector<dim>
      relative_velocity(const ContactState<dim> &state) const
      {
        const RigidContact<dim> &contact = state.contact;
        return motion_of<dim>(motions[contact.body]).velocity_at(state.arm) -
               (contact.other == RigidContact<dim>::none
                  ? contact.surface_velocity
                  : motion_of<dim>(motions[contact.other]).velocity_at(state.arm_of_other));
      }

      /** Velocity along @p direction that a unit impulse along it makes [1/kg]. */
      double
      give(const ContactState<dim> &state, const Vector<dim> &direction) const
      {
        const RigidVector<dim> momentum = momentum_of(direction, state.arm);
        double sum                      = dot(momentum, mobility[state.contact.body] * momentum);
        if (state.contact.other != RigidContact<dim>::none)
          {
            const RigidVector<dim> opposite = momentum_of(direction, state.arm_of_other);
            sum += dot(opposite, mobility[state.contact.other] * opposite);
          }
        return sum;
      }

      void
      apply(const ContactState<dim> &state, const Vector<dim> &impulse)
      {
        const RigidContact<dim> &contact = state.contact;
        motions[contact.body] += mobility[contact.body] * momentum_of(impulse, state.arm);
        if (contact.other != RigidContact<dim>::none)
          motions[contact.other] -= mobility[contact.other] *
                                    momentum_of(impulse, state.arm_of_other);
      }

      /** The normal impulse. @return by how much it changed [N s]. */
      double
      press(ContactState<dim> &state)
      {
        const Vector<dim> &normal = state.contact.normal;
        // What is open may close, and no further; what overlaps does not come back by itself.
        const double allowed = -std::max(state.contact.gap, 0.) / time_step;
        const double wanted  = (allowed - dot(relative_velocity(state), normal)) /
                              give(state, normal);
        const double before  = state.normal_impulse;
        state.normal_impulse = std::max(0., before + wanted);
        apply(state, (state.normal_impulse - before) * normal);
        return std::abs(state.normal_impulse - before);
      }

      /** Friction, bounded by the normal impulse. @return by how much it changed [N s]. */
      double
      rub(ContactState<dim> &state)
      {
        if (state.contact.friction == 0. || state.normal_impulse == 0.)
          {
            const double before = norm(state.friction_impulse);
            apply(state, (-1.) * state.friction_impulse);
            state.friction_impulse = {};
            return before;
          }
        const Vector<dim> &normal  = state.contact.normal;
        const Vector<dim> relative = relative_velocity(state);
        const Vector<dim> sliding  = relative - dot(relative, normal) * normal;
        const double speed         = norm(sliding);
        if (speed == 0.)
          return 0.;
        const Vector<dim> direction = (1. / speed) * sliding;
        const Vector<dim> before    = state.friction_impulse;
        Vector<dim> wanted          = before - (speed / give(state, direction)) * direction;
        const double allowed        = state.contact.friction * state.normal_impulse;
        if (norm(wanted) > allowed)
          wanted *= allowed / norm(wanted);
        state.friction_impulse = wanted;
        apply(state, wanted - before);
        return norm(wanted - before);
      }

      const double time_step;
      std::vector<RigidMatrix<dim>> mobility; ///< by body
      std::vector<RigidVector<dim>> motions;  ///< by body
      std::vector<ContactState<dim>> states;
    };
  } // namespace

  template <int dim>
  RigidContactSearch<dim>::RigidContactSearch(const Lattice<dim> &lattice,
                                              const WallParameters<dim> &walls,
                                              const std::vector<RigidBody<dim>> &bodies,
                                              const double spacing)
    : lattice(lattice)
    , walls(walls)
    , spacing(spacing)
  {
    for (const RigidBody<dim> &body : bodies)
      points.push_back(body.surface_points(spacing));
  }

  template <int dim>
  std::vector<RigidContact<dim>>
  RigidContactSearch<dim>::find(const std::vector<RigidBody<dim>> &bodies,
                                const double time_step) const
  {
    std::vector<RigidContact<dim>> contacts;
    const int n_bodies = static_cast<int>(bodies.size());
    for (int a = 0; a < n_bodies; ++a)
      {
        if (!bodies[a].is_free() || bodies[a].contact().condition == ContactCondition::none)
          continue;
        // Impulses of this step may make it faster than it is.
        const double way = rest_reach * spacing + 2. * time_step * bodies[a].max_speed();
        find_walls(bodies, a, way, contacts);
        for (int b = 0; b < n_bodies; ++b)
          {
            if (a == b || (bodies[b].is_free() && b < a) ||
                bodies[b].contact().condition == ContactCondition::none)
              continue;
            const double reach = way + 2. * time_step * bodies[b].max_speed();
            if (!bodies[a].is_near(bodies[b].pose().position, bodies[b].bounding_radius() + reach))
              continue;
            find_pair(bodies, a, b, reach, contacts);
            find_pair(bodies, b, a, reach, contacts);
          }
      }
    return contacts;
  }

  template <int dim>
  void
  RigidContactSearch<dim>::find_walls(const std::vector<RigidBody<dim>> &bodies,
                                      const int body,
                                      const double reach,
                                      std::vector<RigidContact<dim>> &contacts) const
  {
    const RigidBody<dim> &mover = bodies[body];
    const Vector<dim> centre    = mover.pose().position;
    const Vector<dim> upper     = lattice.upper_corner();
    for (int face = 0; face < 2 * dim; ++face)
      {
        if (walls.condition[face] == WallCondition::open)
          continue;
        const int d            = face / 2;
        const double direction = (face % 2 == 0 ? 1. : -1.);
        const double place     = (face % 2 == 0 ? lattice.lower_corner[d] : upper[d]);
        if (direction * (centre[d] - place) > mover.bounding_radius() + reach)
          continue;
        const double friction = (walls.condition[face] == WallCondition::stick
                                   ? std::numeric_limits<double>::infinity()
                                   : std::max(friction_of(mover.contact()), walls.friction[face]));
        Vector<dim> normal;
        normal[d] = direction;
        for (const Vector<dim> &own : points[body])
          {
            const Vector<dim> point = mover.pose().to_world(own);
            const double gap        = direction * (point[d] - place);
            if (gap < reach)
              contacts.push_back({body, RigidContact<dim>::none, point, normal, gap, friction, {}});
          }
      }
  }

  template <int dim>
  void
  RigidContactSearch<dim>::find_pair(const std::vector<RigidBody<dim>> &bodies,
                                     const int sampled,
                                     const int surface,
                                     const double reach,
                                     std::vector<RigidContact<dim>> &contacts) const
  {
    const RigidBody<dim> &one = bodies[sampled], &other = bodies[surface];
    const double friction = std::max(friction_of(one.contact()), friction_of(other.contact()));
    for (const Vector<dim> &own : points[sampled])
      {
        const Vector<dim> point = one.pose().to_world(own);
        if (!other.is_near(point, reach))
          continue;
        const SurfaceDistance<dim> nearest = other.surface_distance(point);
        if (nearest.distance > reach)
          continue;
        if (one.is_free() && other.is_free())
          contacts.push_back(
            {sampled, surface, point, nearest.normal, nearest.distance, friction, {}});
        else if (one.is_free())
          contacts.push_back({sampled,
                              RigidContact<dim>::none,
                              point,
                              nearest.normal,
                              nearest.distance,
                              friction,
                              other.velocity_at(point)});
        else
          contacts.push_back({surface,
                              RigidContact<dim>::none,
                              point,
                              (-1.) * nearest.normal,
                              nearest.distance,
                              friction,
                              one.velocity_at(point)});
      }
  }

  template <int dim>
  std::vector<RigidVector<dim>>
  solve_contacts(const std::vector<RigidBody<dim>> &bodies,
                 const std::vector<RigidContact<dim>> &contacts,
                 const std::vector<RigidEquation<dim>> &equations,
                 const double time_step)
  {
    return ContactSweep<dim>(bodies, contacts, equations, time_step).run();
  }

  template <int dim>
  void
  separate_overlaps(const std::vector<RigidContact<dim>> &contacts,
                    const double tolerance,
                    std::vector<RigidBody<dim>> &bodies)
  {
    const auto shift = [&](const int body, const Vector<dim> &way) {
      Pose<dim> pose = bodies[body].pose();
      pose.position += way;
      bodies[body].set_pose(pose);
    };
    // Of each body the deepest overlap alone: those beside it mostly go with it.
    std::vector<const RigidContact<dim> *> deepest(bodies.size(), nullptr);
    for (const RigidContact<dim> &contact : contacts)
      if (contact.gap < -tolerance &&
          (deepest[contact.body] == nullptr || contact.gap < deepest[contact.body]->gap))
        deepest[contact.body] = &contact;
    for (const RigidContact<dim> *contact : deepest)
      {
        if (contact == nullptr)
          continue;
        const Vector<dim> way = (-tolerance - contact->gap) * contact->normal;
        if (contact->other == RigidContact<dim>::none)
          {
            shift(contact->body, way);
            continue;
          }
        const double one = bodies[contact->body].mass(), other = bodies[contact->other].mass();
        shift(contact->body, (other / (one + other)) * way);
        shift(contact->other, (-one / (one + other)) * way);
      }
  }

#define MAGMPM_INSTANTIATE(dim)                                                                  \
  template class RigidContactSearch<dim>;                                                        \
  template std::vector<RigidVector<dim>> solve_contacts(const std::vector<RigidBody<dim>> &,     \
                                                        const std::vector<RigidContact<dim>> &,  \
                                                        const std::vector<RigidEquation<dim>> &, \
                                                        const double);                           \
  template void separate_overlaps(                                                               \
    const std::vector<RigidContact<dim>> &, const double, std::vector<RigidBody<dim>> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
