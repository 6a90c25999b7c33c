#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/boundary/body_images.h>
#include <magmpm/coupling/closed_walls.h>
#include <magmpm/coupling/surface_tension.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/lattice/wall_columns.h>
#include <magmpm/surface/force_handover.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace magmpm
{
  namespace
  {
    /** A node with less of a full cell than this gives its force away: it would be shot off. */
    constexpr double least_share = 0.001;

    template <int dim>
    WettedWalls<dim>
    wetted_walls(const Lattice<dim> &lattice, const WallParameters<dim> &walls)
    {
      WettedWalls<dim> wetted;
      wetted.mirrors = closed_walls<dim>(lattice, walls.open_faces());
      for (std::size_t face = 0; face < walls.condition.size(); ++face)
        {
          wetted.sticks[face] = walls.condition[face] == WallCondition::stick;
          wetted.cosine[face] = cosine_of_angle(walls.contact_angle[face]);
        }
      return wetted;
    }

    /** Whether any of them is one that material touches. */
    template <int dim>
    bool
    has_surface(const std::vector<RigidBody<dim>> &bodies)
    {
      return std::any_of(bodies.begin(), bodies.end(), [](const RigidBody<dim> &body) {
        return body.contact().condition != ContactCondition::none;
      });
    }

    template <int dim>
    double
    density_of(const Body<dim> &body)
    {
      return std::visit([](const auto &law) { return law.density; }, body.material);
    }
  } // namespace

  template <int dim>
  SurfaceTension<dim>::SurfaceTension(const Lattice<dim> &lattice, const WallParameters<dim> &walls)
    : lattice(lattice)
    , walls(wetted_walls(lattice, walls))
    , surface(lattice, this->walls)
  {
  }

  template <int dim>
  void
  SurfaceTension<dim>::look_at(const std::vector<Body<dim>> &bodies)
  {
    tensions.clear();
    fluids.clear();
    largest_tension = largest_density = record.capillary_rate = 0.;
    is_one_fluid                                              = true;
    for (const Body<dim> &body : bodies)
      {
        is_one_fluid = is_one_fluid && is_fluid(body) &&
                       body.surface_tension == bodies.front().surface_tension &&
                       density_of(body) == density_of(bodies.front());
        if (!is_fluid(body))
          continue;
        const double tension = body.surface_tension;
        fluids += (fluids.empty() ? "'" : ", '") + body.name + "' " + to_text(tension) + " N/m";
        if (std::find(tensions.begin(), tensions.end(), tension) == tensions.end())
          tensions.push_back(tension);
        largest_tension = std::max(largest_tension, tension);
        if (tension > 0.)
          largest_density = std::max(largest_density, density_of(body));
        record.capillary_rate =
          std::max(record.capillary_rate,
                   std::sqrt(tension / (density_of(body) * std::pow(lattice.spacing, 3))));
      }
    std::sort(tensions.begin(), tensions.end());
  }

  template <int dim>
  void
  SurfaceTension<dim>::act(const Clock &clock,
                           const BlockPartition<dim> &partition,
                           const std::vector<RigidBody<dim>> &rigid_bodies,
                           std::vector<Body<dim>> &bodies,
                           NodeField<dim> &momentum)
  {
    if (tensions.empty())
      look_at(bodies);
    if (largest_tension == 0.)
      return;
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, SingleVector> force;
    {
      SurfaceFields<dim> fields;
      fields.is_uniform = is_one_fluid;
      fields.content    = is_one_fluid ? content_of_mass(partition, momentum)
                                       : content_of_bodies(partition, bodies);
      if (has_surface(rigid_bodies))
        mirror_at_bodies(partition, rigid_bodies, fields);
      record.energy = largest_tension * std::pow(lattice.spacing, dim - 1) *
                      surface.find(partition, fields, force);
      record.touches = fluids_touch(blocks, fields.content);
    }
    const double unit = largest_tension * std::pow(lattice.spacing, dim - 2);
    record.dropped = unit * hand_force_inward(partition, taking_masses(partition, momentum), force);
    for_nodes(blocks, [&](const int slot, const int n) {
      momentum.add(NodeMotion::momentum,
                   slot,
                   n,
                   (clock.time_step * unit) * force.get(SingleVector::value, slot, n));
    });
  }

  template <int dim>
  NodeField<dim, SurfaceContent>
  SurfaceTension<dim>::content_of_mass(const BlockPartition<dim> &partition,
                                       const NodeField<dim> &momentum) const
  {
    const BlockSet<dim> &blocks = partition.blocks();
    const double full_cell      = largest_density * std::pow(lattice.spacing, dim);
    NodeField<dim, SurfaceContent> content(blocks.size());
    for_nodes(blocks, [&](const int slot, const int n) {
      content.set(
        SurfaceContent::volume, slot, n, momentum.get(NodeMotion::mass, slot, n) / full_cell);
    });
    partition.update_ghosts(content);
    return content;
  }

  template <int dim>
  NodeField<dim, SurfaceContent>
  SurfaceTension<dim>::content_of_bodies(const BlockPartition<dim> &partition,
                                         std::vector<Body<dim>> &bodies) const
  {
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, SurfaceContent> content(blocks.size());
    surface_content_to_lattice(bodies, blocks, lattice, content);
    partition.add_ghosts_to_owners(content);
    for_nodes(blocks, [&](const int slot, const int n) {
      const double sum = content.get(SurfaceContent::tension, slot, n);
      content.set(SurfaceContent::tension, slot, n, sum / largest_tension);
    });
    partition.update_ghosts(content);
    return content;
  }

  template <int dim>
  void
  SurfaceTension<dim>::mirror_at_bodies(const BlockPartition<dim> &partition,
                                        const std::vector<RigidBody<dim>> &rigid_bodies,
                                        SurfaceFields<dim> &fields) const
  {
    const BlockSet<dim> &blocks = partition.blocks();
    BodyImages<dim> mirrors(rigid_bodies, blocks, lattice);
    partition.update_ghosts(mirrors.share);
    fields.images = mirrors.images(blocks);
    // In front of a body B-splines see only what is in front.
    for_nodes_and_ghosts(blocks, [&](const int slot, const int n) {
      if (!mirrors.is_in_front({slot, n}))
        return;
      const double outside = 1. - mirrors.share.get(SingleScalar::value, slot, n);
      for (const auto quantity : {SurfaceContent::volume, SurfaceContent::tension})
        fields.content.set(quantity, slot, n, fields.content.get(quantity, slot, n) / outside);
    });
    fields.images.fill(fields.content);
    partition.update_ghosts(fields.content);
    fields.rigid_share = std::move(mirrors.share);
    if (!mirrors.are_wetted())
      return;
    partition.update_ghosts(mirrors.wetting);
    fields.rigid_wetting = std::move(mirrors.wetting);
  }

  template <int dim>
  NodeField<dim, SingleScalar>
  SurfaceTension<dim>::taking_masses(const BlockPartition<dim> &partition,
                                     const NodeField<dim> &momentum) const
  {
    const BlockSet<dim> &blocks = partition.blocks();
    constexpr auto mass         = SingleScalar::value;
    NodeField<dim, SingleScalar> masses(blocks.size());
    for_nodes(blocks, [&](const int slot, const int n) {
      masses.set(mass, slot, n, momentum.get(NodeMotion::mass, slot, n));
    });
    partition.update_ghosts(masses);
    for (int face = 0; face < 2 * dim; ++face)
      if (walls.mirrors.is_mirror[face])
        for_wall_columns<dim>(
          blocks, blocks.size(), lattice.n_cells, face, [&](const WallColumn &column) {
            const LatticeNode front = column.in_front(1), behind = column.behind(1);
            masses.add(
              mass, front.slot, front.number, masses.get(mass, behind.slot, behind.number));
            masses.set(mass, behind.slot, behind.number, 0.);
          });
    const double least = least_share * largest_density * std::pow(lattice.spacing, dim);
    for_nodes(blocks, [&](const int slot, const int n) {
      if (masses.get(mass, slot, n) < least)
        masses.set(mass, slot, n, 0.);
    });
    partition.update_ghosts(masses);
    return masses;
  }

  template <int dim>
  bool
  SurfaceTension<dim>::fluids_touch(const BlockSet<dim> &blocks,
                                    const NodeField<dim, SurfaceContent> &content) const
  {
    if (tensions.size() < 2)
      return false;
    double least_difference = largest_tension;
    for (std::size_t i = 1; i < tensions.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        least_difference = std::min(least_difference, std::abs(tensions[i] - tensions[j]));
    // A tenth of one in the other has this variance; B-splines reach that far where both fill their cells.
    const double least_variance = 0.09 * least_difference * least_difference;
    constexpr double least_fill = 0.5;
    bool touch                  = false;
    for_nodes(blocks, [&](const int slot, const int n) {
      const double fluid = content.get(SurfaceContent::fluid, slot, n);
      if (fluid < least_fill)
        return;
      const double mean = largest_tension * content.get(SurfaceContent::tension, slot, n) / fluid;
      const double variance = content.get(SurfaceContent::square, slot, n) / fluid - mean * mean;
      touch                 = touch || variance > least_variance;
    });
    return touch;
  }

  template <int dim>
  void
  SurfaceTension<dim>::limit_step(StepConditions &conditions) const
  {
    conditions.capillary_rate = record.capillary_rate;
  }

  template <int dim>
  void
  SurfaceTension<dim>::reduce(parallel::Reduction &reduction)
  {
    if (largest_tension == 0.)
      return;
    reduction.sum(record.energy);
    reduction.sum(record.dropped);
    reduction.max(record.touches);
  }

  template <int dim>
  void
  SurfaceTension<dim>::take_reduced()
  {
    if (!record.touches)
      return;
    throw RunError(
      "Fluids of different surface tension touch (" + fluids +
      "). What their common surface does is not known: this scheme is for free surfaces. "
      "Give all of them the same 'Surface tension', or none.");
  }

  template <int dim>
  void
  SurfaceTension<dim>::add_columns(ColumnTable &table) const
  {
    table.add("surface energy", ColumnUnits<dim>::energy, [this] { return record.energy; });
    table.add("dropped surface force", ColumnUnits<dim>::force, [this] {
      return norm(record.dropped);
    });
  }

  template <int dim>
  SectionTitle
  SurfaceTension<dim>::title() const
  {
    return {"surface tension", 1};
  }

  template <int dim>
  std::string
  SurfaceTension<dim>::save() const
  {
    return pack(record);
  }

  template <int dim>
  void
  SurfaceTension<dim>::load(const std::string &bytes)
  {
    unpack(bytes, record);
  }

  template class SurfaceTension<2>;
  template class SurfaceTension<3>;
} // namespace magmpm
