#include <magmpm/geometry/clipped_surface.h>
#include <magmpm/geometry/combined_shape.h>
#include <magmpm/geometry/common_moments.h>
#include <magmpm/geometry/surface_side.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Of the box around a shape, that part in which points are the same. */
    constexpr double tolerance = 1e-9;

    template <int dim>
    double
    size_of(const Shape<dim> &shape)
    {
      const BoundingBox<dim> box = shape.bounding_box();
      return norm(box.upper - box.lower);
    }

    template <int dim>
    SurfaceDistance<dim>
    turned_over(const SurfaceDistance<dim> &found)
    {
      return {-found.distance, -1. * found.normal};
    }

    /** Sums moments over boxes of equal edges, of which there are some hundred along the longest edge. */
    template <int dim>
    VolumeMoments<dim>
    summed_moments(const Shape<dim> &shape)
    {
      constexpr int n_along        = (dim == 2 ? 128 : 32);
      const BoundingBox<dim> reach = shape.bounding_box();
      const Vector<dim> edges      = reach.upper - reach.lower;
      const double longest         = *std::max_element(edges.values, edges.values + dim);
      if (!(longest > 0.))
        return {0., middle_of(reach), {}};
      int n[dim], n_boxes = 1;
      for (int d = 0; d < dim; ++d)
        {
          n[d] = std::max(1, static_cast<int>(std::ceil(n_along * edges[d] / longest - tolerance)));
          n_boxes *= n[d];
        }
      RegionMoments<dim> sum;
      for (int i = 0; i < n_boxes; ++i)
        {
          BoundingBox<dim> box;
          for (int d = 0, rest = i; d < dim; rest /= n[d], ++d)
            {
              box.lower[d] = reach.lower[d] + edges[d] * (rest % n[d]) / n[d];
              box.upper[d] = reach.lower[d] + edges[d] * (rest % n[d] + 1) / n[d];
            }
          if (volume_of(box) > 0.)
            sum += moved_to(shape.moments_within(box), middle_of(reach) - middle_of(box));
        }
      const bool is_empty = !(sum.volume > tolerance * volume_of(reach));
      return is_empty ? VolumeMoments<dim>{0., middle_of(reach), {}}
                      : about_centroid(sum, middle_of(reach));
    }
  } // namespace

  template <int dim>
  CombinedShape<dim>::CombinedShape(const Combination combination,
                                    std::unique_ptr<const Shape<dim>> first,
                                    std::unique_ptr<const Shape<dim>> second,
                                    const std::optional<VolumeMoments<dim>> &exact_moments)
    : combination(combination)
    , first(std::move(first))
    , second(std::move(second))
    , all_moments(exact_moments ? *exact_moments : summed_moments(*this))
  {
  }

  template <int dim>
  bool
  CombinedShape<dim>::contains(const Vector<dim> &point) const
  {
    switch (combination)
      {
        case Combination::union_of:
          return first->contains(point) || second->contains(point);
        case Combination::difference:
          return first->contains(point) && !second->contains(point);
        default:
          return first->contains(point) && second->contains(point);
      }
  }

  template <int dim>
  SurfaceDistance<dim>
  CombinedShape<dim>::surface_distance(const Vector<dim> &point) const
  {
    const SurfaceDistance<dim> of_first = first->surface_distance(point);
    SurfaceDistance<dim> of_second      = second->surface_distance(point);
    if (combination == Combination::difference)
      of_second = turned_over(of_second);
    const bool first_is_larger = of_first.distance > of_second.distance;
    return first_is_larger == (combination != Combination::union_of) ? of_first : of_second;
  }

  template <int dim>
  BoundingBox<dim>
  CombinedShape<dim>::bounding_box() const
  {
    BoundingBox<dim> box         = first->bounding_box();
    const BoundingBox<dim> other = second->bounding_box();
    for (int d = 0; d < dim; ++d)
      if (combination == Combination::union_of)
        {
          box.lower[d] = std::min(box.lower[d], other.lower[d]);
          box.upper[d] = std::max(box.upper[d], other.upper[d]);
        }
      else if (combination == Combination::intersection)
        {
          box.lower[d] = std::max(box.lower[d], other.lower[d]);
          box.upper[d] = std::max(box.lower[d], std::min(box.upper[d], other.upper[d]));
        }
    return box;
  }

  template <int dim>
  VolumeMoments<dim>
  CombinedShape<dim>::volume_moments() const
  {
    return all_moments;
  }

  template <int dim>
  RegionMoments<dim>
  CombinedShape<dim>::moments_within(const BoundingBox<dim> &box, const int depth) const
  {
    const PartsOfBox<dim> parts(*first, *second, box, depth);
    switch (combination)
      {
        case Combination::union_of:
          return parts.of_first + parts.of_second - parts.common();
        case Combination::difference:
          return parts.of_first - parts.common();
        default:
          return parts.common();
      }
  }

  template <int dim>
  std::vector<Vector<dim>>
  CombinedShape<dim>::points_on_both(const std::vector<Vector<dim>> &points,
                                     const double spacing) const
  {
    constexpr int n_steps = 60;
    const double near     = tolerance * size_of(*first);
    std::vector<Vector<dim>> result;
    for (const Vector<dim> &start : points)
      {
        if (std::abs(second->surface_distance(start).distance) > spacing)
          continue;
        // From one surface to the other in turn.
        Vector<dim> point = start;
        for (int i = 0;
             i < n_steps && std::abs(second->surface_distance(point).distance) > 0.1 * near;
             ++i)
          for (const Shape<dim> *shape : {second.get(), first.get()})
            {
              const SurfaceDistance<dim> found = shape->surface_distance(point);
              point -= found.distance * found.normal;
            }
        // Not so where distances come from samples of a mesh.
        if (norm(point - start) < 2. * spacing &&
            side_of(*first, point, near) == SurfaceSide::surface &&
            side_of(*second, point, near) == SurfaceSide::surface)
          result.push_back(point);
      }
    return result;
  }

  template <int dim>
  std::vector<Vector<dim>>
  CombinedShape<dim>::surface_points(const double spacing) const
  {
    const std::vector<Vector<dim>> of_first = first->surface_points(spacing);
    std::vector<Vector<dim>> points         = points_on_both(of_first, spacing);
    // Where the surfaces coincide the points of the first stand for both, unless nothing is left there.
    const double margin_of_first  = tolerance * size_of(*first);
    const double margin_of_second = tolerance * size_of(*second);
    for (const Vector<dim> &point : of_first)
      {
        const SurfaceSide side = side_of(*second, point, margin_of_second);
        if (combination == Combination::difference ? side == SurfaceSide::outside
            : combination == Combination::union_of ? side != SurfaceSide::inside
                                                   : side != SurfaceSide::outside)
          points.push_back(point);
      }
    const SurfaceSide kept = combination == Combination::union_of ? SurfaceSide::outside
                                                                  : SurfaceSide::inside;
    for (const Vector<dim> &point : second->surface_points(spacing))
      if (side_of(*first, point, margin_of_first) == kept)
        points.push_back(point);
    return points;
  }

  template <int dim>
  SurfaceMesh<dim>
  CombinedShape<dim>::surface_mesh(const double spacing) const
  {
    const bool is_union               = (combination == Combination::union_of);
    const bool keeps_inside_of_second = (combination == Combination::intersection);
    SurfaceMesh<dim> mesh =
      clipped_surface(first->surface_mesh(spacing), *second, keeps_inside_of_second, spacing);
    SurfaceMesh<dim> other =
      clipped_surface(second->surface_mesh(spacing), *first, !is_union, spacing);
    const int n = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (std::array<int, dim> facet : other.facets)
      {
        for (int &corner : facet)
          corner += n;
        if (combination == Combination::difference) // it faces into what was taken away
          std::swap(facet[0], facet[1]);
        mesh.facets.push_back(facet);
      }
    return mesh;
  }

  template class CombinedShape<2>;
  template class CombinedShape<3>;
} // namespace magmpm
