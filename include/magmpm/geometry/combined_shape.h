#pragma once

#include <magmpm/geometry/shape.h>

#include <memory>
#include <optional>

namespace magmpm
{
  enum class Combination
  {
    union_of,
    difference, ///< what is in the first shape and not in the second
    intersection
  };

  /**
   * A shape made of two others. Its surface is that of the one where the other lets it be.
   *
   * Distances are the larger or smaller of those of the two: right in sign, exact next to faces, and too
   * short beyond edges that the two make together (and deep inside of a union). Where faces of the
   * two coincide and a difference takes the material away from both of their sides, a sheet of
   * distance 0 is left: let the second shape reach beyond the first there.
   */
  template <int dim>
  class CombinedShape : public Shape<dim>
  {
  public:
    /** @param exact_moments  if they are known; otherwise they are summed over a grid of boxes. */
    CombinedShape(const Combination combination,
                  std::unique_ptr<const Shape<dim>> first,
                  std::unique_ptr<const Shape<dim>> second,
                  const std::optional<VolumeMoments<dim>> &exact_moments = {});

    bool
    contains(const Vector<dim> &point) const override;

    SurfaceDistance<dim>
    surface_distance(const Vector<dim> &point) const override;

    /** Holds the shape; of intersections and differences it may be larger than needed. */
    BoundingBox<dim>
    bounding_box() const override;

    /** The volume is 0 if nothing is left. */
    VolumeMoments<dim>
    volume_moments() const override;

    /**
     * From the moments of the two, as exact as these where not both of their surfaces cross the box.
     * Where they do it is halved at most @p depth times; then what they have in common is estimated from
     * the directions in which their parts lie, exactly if these are the same, opposite, or along two
     * axes.
     */
    RegionMoments<dim>
    moments_within(const BoundingBox<dim> &box, const int depth = cell_depth<dim>) const override;

    /** Those of the two, and on edges that they make together; not on those of a mesh with another shape. */
    std::vector<Vector<dim>>
    surface_points(const double spacing) const override;

    SurfaceMesh<dim>
    surface_mesh(const double spacing) const override;

  private:
    const Combination combination;
    const std::unique_ptr<const Shape<dim>> first, second;
    VolumeMoments<dim> all_moments;

    /** Points on both surfaces, within about @p spacing [m] of @p points of the first. */
    std::vector<Vector<dim>>
    points_on_both(const std::vector<Vector<dim>> &points, const double spacing) const;
  };
} // namespace magmpm
