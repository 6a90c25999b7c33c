#include <magmpm/base/number_text.h>
#include <magmpm/coupling/group_contact.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/parallel/reduce.h>

#include <algorithm>
#include <limits>

namespace magmpm
{
  namespace
  {
    /** Bodies may start overlapped by so much: places of particles in cut cells are not exact. */
    constexpr double tolerated_overlap_at_start = 0.02; // dx

    /** The names of the bodies of a group, for a message. */
    template <int dim>
    std::string
    names_of_group(const std::vector<Body<dim>> &bodies, const int group)
    {
      std::string names;
      for (const Body<dim> &body : bodies)
        if (body.contact_group == group)
          names += (names.empty() ? "'" : ", '") + body.name + "'";
      return names + " (contact group " + std::to_string(group) + ")";
    }
  } // namespace

  template <int dim>
  GroupContact<dim>::GroupContact(const Lattice<dim> &lattice,
                                  const std::vector<int> &groups,
                                  const std::vector<GroupContactParameters> &listed,
                                  const MPI_Comm communicator)
    : lattice(lattice)
    , communicator(communicator)
  {
    for (std::size_t b = 0; b < groups.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        pairs.push_back(
          {a, b, {groups[a], groups[b], contact_between(listed, groups[a], groups[b])}, 0.});
  }

  template <int dim>
  void
  GroupContact<dim>::act(const BlockPartition<dim> &partition,
                         const std::vector<Body<dim>> &bodies,
                         const double time_step,
                         const double least_mass,
                         std::vector<GroupMotion<dim>> &motions)
  {
    if (pairs.empty())
      return;
    the_energy = 0.;
    for (GroupMotion<dim> &group : motions)
      partition.update_ghosts(group.motion);
    for (Pair &pair : pairs)
      {
        NodeField<dim> &a = motions[pair.a].motion, &b = motions[pair.b].motion;
        pair.depth = 0.;
        if (!find_shared_nodes(partition, least_mass, a, b))
          continue;
        find_sums(partition, bodies, pair);
        press(partition.blocks(), time_step, pair, a, b);
      }
  }

  template <int dim>
  bool
  GroupContact<dim>::find_shared_nodes(const BlockPartition<dim> &partition,
                                       const double least_mass,
                                       const NodeField<dim> &a,
                                       const NodeField<dim> &b)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    shared.reinit(blocks.size());
    int any = 0;
    for_nodes_and_ghosts(blocks, [&](const int slot, const int n) {
      if (!(a.get(NodeMotion::mass, slot, n) > least_mass &&
            b.get(NodeMotion::mass, slot, n) > least_mass))
        return;
      shared.set(SingleScalar::value, slot, n, 1.);
      any = 1;
    });
    return parallel::max(any, communicator) != 0;
  }

  template <int dim>
  void
  GroupContact<dim>::find_sums(const BlockPartition<dim> &partition,
                               const std::vector<Body<dim>> &bodies,
                               const Pair &pair)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    material.reinit(blocks.size());
    gaps.reinit(blocks.size());
    const int groups[] = {pair.contact.first, pair.contact.second};
    for (const int side : {0, 1})
      add_shared_material(bodies, groups[side], side, blocks, lattice, shared, material);
    partition.add_ghosts_to_owners(material);
    partition.update_ghosts(material);
    for (const int side : {0, 1})
      add_shared_gaps(bodies, groups[side], side, blocks, lattice, shared, material, gaps);
    partition.add_ghosts_to_owners(gaps);
  }

  template <int dim>
  void
  GroupContact<dim>::press(const BlockSet<dim> &blocks,
                           const double time_step,
                           Pair &pair,
                           NodeField<dim> &a,
                           NodeField<dim> &b)
  {
    for_nodes(blocks, [&](const int slot, const int n) {
      SharedSurface<dim> surface;
      if (shared.get(SingleScalar::value, slot, n) == 0. || !find_surface(slot, n, surface))
        return;
      const double mass_a  = a.get(NodeMotion::mass, slot, n);
      const double mass_b  = b.get(NodeMotion::mass, slot, n);
      surface.reduced_mass = mass_a * mass_b / (mass_a + mass_b);
      surface.contact      = pair.contact.contact;
      // Gravity is the same for both.
      const Vector<dim> relative = (1. / mass_b) * b.get(NodeMotion::momentum, slot, n) -
                                   (1. / mass_a) * a.get(NodeMotion::momentum, slot, n);
      const Vector<dim> impulse = impulse_between(surface, lattice.spacing, time_step, relative);
      a.add(NodeMotion::momentum, slot, n, -1. * impulse);
      b.add(NodeMotion::momentum, slot, n, impulse);

      if (surface.area == 0.)
        return;
      pair.depth       = std::max(pair.depth, -surface.gap);
      const double way = 0.5 * time_step *
                         dot(relative + (1. / surface.reduced_mass) * impulse, surface.normal);
      the_energy += surface.area * surface.modulus * lattice.spacing *
                    contact_energy(std::max(0., -surface.gap - way) / lattice.spacing);
    });
  }

  template <int dim>
  bool
  GroupContact<dim>::find_surface(const int slot, const int n, SharedSurface<dim> &surface) const
  {
    const SharedMaterial<dim> a = material_at(material, 0, slot, n);
    const SharedMaterial<dim> b = material_at(material, 1, slot, n);
    const auto normals          = contact_normals(a, b);
    const auto way              = [&](const int side, const int k) {
      return gaps.get(SharedNodeGaps::weighted_way(side, k), slot, n) /
             gaps.get(SharedNodeGaps::weight(side, k), slot, n);
    };
    const auto is_known = [&](const int side, const int k) {
      return gaps.get(SharedNodeGaps::weight(side, k), slot, n) > 0.;
    };
    surface.gap = std::numeric_limits<double>::lowest();
    for (int k = 0; k < n_contact_normals; ++k)
      {
        if (norm(normals[k]) == 0. || !is_known(0, k) || !is_known(1, k))
          continue;
        const double gap = way(0, k) + way(1, k);
        if (gap <= surface.gap)
          continue;
        surface.gap    = gap;
        surface.normal = normals[k];
      }
    if (surface.gap == std::numeric_limits<double>::lowest())
      return false;
    surface.area    = shared_area(a, b, surface.normal);
    surface.modulus = modulus_in_series(a.modulus, b.modulus);
    return true;
  }

  template <int dim>
  double
  GroupContact<dim>::depth() const
  {
    double deepest = 0.;
    for (const Pair &pair : pairs)
      deepest = std::max(deepest, pair.depth);
    return deepest;
  }

  template <int dim>
  std::vector<std::string>
  GroupContact<dim>::find_overlaps(const std::vector<Body<dim>> &bodies) const
  {
    std::vector<std::string> lines;
    if (pairs.empty())
      return lines;
    std::vector<double> depths;
    for (const Pair &pair : pairs)
      depths.push_back(pair.depth / lattice.spacing);
    parallel::Reduction reduction;
    reduction.max(depths);
    reduction.carry_out(communicator);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (depths[i] > tolerated_overlap_at_start)
        lines.push_back("the bodies " + names_of_group(bodies, pairs[i].contact.first) + " and " +
                        names_of_group(bodies, pairs[i].contact.second) +
                        " overlap at the start by " + to_text(depths[i] * lattice.spacing) +
                        " m, that is " + to_text(depths[i]) +
                        " cells: contact throws them apart. Move them apart by as much.");
    return lines;
  }

  template class GroupContact<2>;
  template class GroupContact<3>;
} // namespace magmpm
