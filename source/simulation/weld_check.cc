#include <magmpm/base/number_text.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/parallel/gather.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/simulation/weld_check.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <variant>

namespace magmpm
{
  namespace
  {
    template <int dim>
    bool
    is_within(const BoundingBox<dim> &box, const Vector<dim> &position)
    {
      for (int d = 0; d < dim; ++d)
        if (position[d] < box.lower[d] || position[d] > box.upper[d])
          return false;
      return true;
    }

    template <int dim>
    bool
    is_empty(const BoundingBox<dim> &box)
    {
      for (int d = 0; d < dim; ++d)
        if (box.lower[d] > box.upper[d])
          return true;
      return false;
    }

    template <int dim>
    double
    radius_of_particle(const ParticleSet<dim> &particles, const std::size_t p)
    {
      return 0.5 * std::pow(particles.component(ParticleProperty::volume, 0)[p], 1. / dim);
    }

    template <int dim>
    std::string
    describe(const Body<dim> &a, const Body<dim> &b, const double time)
    {
      const std::string group = std::to_string(a.contact_group);
      return "the bodies '" + a.name + "' and '" + b.name +
             "' have come within a cell of one another by t = " + to_text(time) +
             " s. Both are in contact group " + group +
             ", so they stick together from now on. If they are to touch and part, set 'Contact "
             "group' in Bodies/" +
             b.name + " to another number than " + group + ".";
    }
  } // namespace

  template <int dim>
  WeldCheck<dim>::WeldCheck(const Lattice<dim> &lattice, const MPI_Comm communicator)
    : lattice(lattice)
    , communicator(communicator)
  {
  }

  template <int dim>
  std::vector<std::string>
  WeldCheck<dim>::find_welds(const std::vector<Body<dim>> &bodies, const double time)
  {
    if (is_first)
      watch(bodies);
    std::vector<std::string> welds;
    if (watched.empty())
      {
        is_first = false;
        return welds;
      }
    const std::vector<BoundingBox<dim>> boxes = find_boxes(bodies);
    const auto meets                          = [&](const Pair &pair) {
      const BoundingBox<dim> box = common_box(boxes[pair.first], boxes[pair.second]);
      if (is_empty(box) || !are_near(gather_places(bodies, pair, box), pair))
        return false;
      if (!is_first)
        welds.push_back(describe(bodies[pair.first], bodies[pair.second], time));
      return true;
    };
    watched.erase(std::remove_if(watched.begin(), watched.end(), meets), watched.end());
    is_first = false;
    return welds;
  }

  template <int dim>
  void
  WeldCheck<dim>::watch(const std::vector<Body<dim>> &bodies)
  {
    const auto is_solid = [](const Body<dim> &body) {
      return std::holds_alternative<NeoHookean<dim>>(body.material);
    };
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (is_solid(bodies[a]) && is_solid(bodies[b]) &&
            bodies[a].contact_group == bodies[b].contact_group)
          watched.push_back({a, b});
  }

  template <int dim>
  std::vector<BoundingBox<dim>>
  WeldCheck<dim>::find_boxes(const std::vector<Body<dim>> &bodies) const
  {
    std::vector<BoundingBox<dim>> boxes(bodies.size());
    parallel::Reduction reduction;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        for (int d = 0; d < dim; ++d)
          {
            boxes[b].lower[d] = std::numeric_limits<double>::max();
            boxes[b].upper[d] = std::numeric_limits<double>::lowest();
          }
        for (std::size_t p = 0; p < bodies[b].particles.size(); ++p)
          for (int d = 0; d < dim; ++d)
            {
              const double x    = bodies[b].particles.position(p)[d];
              boxes[b].lower[d] = std::min(boxes[b].lower[d], x);
              boxes[b].upper[d] = std::max(boxes[b].upper[d], x);
            }
        reduction.min(boxes[b].lower);
        reduction.max(boxes[b].upper);
      }
    reduction.carry_out(communicator);
    return boxes;
  }

  template <int dim>
  BoundingBox<dim>
  WeldCheck<dim>::common_box(const BoundingBox<dim> &a, const BoundingBox<dim> &b) const
  {
    const double reach = 2. * lattice.spacing; // dx and the radii of two particles
    BoundingBox<dim> box;
    for (int d = 0; d < dim; ++d)
      {
        box.lower[d] = std::max(a.lower[d], b.lower[d]) - reach;
        box.upper[d] = std::min(a.upper[d], b.upper[d]) + reach;
      }
    return box;
  }

  template <int dim>
  auto
  WeldCheck<dim>::gather_places(const std::vector<Body<dim>> &bodies,
                                const Pair &pair,
                                const BoundingBox<dim> &box) const -> std::vector<SurfacePlace>
  {
    std::vector<SurfacePlace> own, all;
    for (const std::size_t b : {pair.first, pair.second})
      {
        const ParticleSet<dim> &particles = bodies[b].particles;
        for (std::size_t p = 0; p < particles.size(); ++p)
          if (particles.component(ParticleProperty::exposed_faces, 0)[p] != 0. &&
              is_within(box, particles.position(p)))
            own.push_back({b, particles.position(p), radius_of_particle(particles, p)});
      }
    for (const auto &of_rank : parallel::all_gather(own, communicator))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    return all;
  }

  template <int dim>
  bool
  WeldCheck<dim>::are_near(const std::vector<SurfacePlace> &places, const Pair &pair) const
  {
    double largest_radius = 0.;
    for (const SurfacePlace &place : places)
      largest_radius = std::max(largest_radius, place.radius);
    const double edge  = lattice.spacing + 2. * largest_radius;
    const auto cell_of = [&](const Vector<dim> &position) {
      Index<dim> cell;
      for (int d = 0; d < dim; ++d)
        cell[d] = static_cast<int>(std::floor((position[d] - lattice.lower_corner[d]) / edge));
      return cell;
    };
    std::map<Index<dim>, std::vector<const SurfacePlace *>> first;
    for (const SurfacePlace &place : places)
      if (place.body == pair.first)
        first[cell_of(place.position)].push_back(&place);
    for (const SurfacePlace &place : places)
      for (int i = 0; i < power(3, dim) && place.body == pair.second; ++i)
        {
          const auto found = first.find(neighbour_block<dim>(cell_of(place.position), i));
          if (found == first.end())
            continue;
          for (const SurfacePlace *other : found->second)
            if (norm(place.position - other->position) <
                lattice.spacing + place.radius + other->radius)
              return true;
        }
    return false;
  }

  template class WeldCheck<2>;
  template class WeldCheck<3>;
} // namespace magmpm
