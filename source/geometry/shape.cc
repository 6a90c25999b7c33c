#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/combined_shape.h>
#include <magmpm/geometry/cylinder_shape.h>
#include <magmpm/geometry/mesh_file.h>
#include <magmpm/geometry/mesh_shape.h>
#include <magmpm/geometry/point_cloud_shape.h>
#include <magmpm/geometry/ring_shape.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/motion/pose.h>

#include <algorithm>
#include <utility>

namespace magmpm
{
  namespace
  {
    /** Moments of what is left of a shape without another in it that has the same centroid. */
    template <int dim>
    VolumeMoments<dim>
    hollow(const Shape<dim> &outer, const Shape<dim> &hole)
    {
      const VolumeMoments<dim> all = outer.volume_moments(), missing = hole.volume_moments();
      return {all.volume - missing.volume, all.centroid, all.second + -1. * missing.second};
    }

    template <int dim>
    std::unique_ptr<Shape<dim>>
    make_ring(const ShapeParameters<dim> &parameters)
    {
      if constexpr (dim == 3)
        return std::make_unique<RingShape>(
          parameters.centre, parameters.axis, parameters.radius, parameters.inner_radius);
      else
        {
          auto disc = std::make_unique<SphereShape<2>>(parameters.centre, parameters.radius);
          auto hole = std::make_unique<SphereShape<2>>(parameters.centre, parameters.inner_radius);
          const VolumeMoments<2> moments = hollow<2>(*disc, *hole);
          return std::make_unique<CombinedShape<2>>(
            Combination::difference, std::move(disc), std::move(hole), moments);
        }
    }

    std::unique_ptr<Shape<3>>
    make_tube(const ShapeParameters<3> &parameters)
    {
      const auto cylinder = [&](const double radius, const double length) {
        return std::make_unique<CylinderShape>(parameters.centre, parameters.axis, radius, length);
      };
      const VolumeMoments<3> moments =
        hollow<3>(*cylinder(parameters.radius, parameters.length),
                  *cylinder(parameters.inner_radius, parameters.length));
      // The hole goes beyond the ends, farther than distances there are asked for.
      const double length = 3. * parameters.length + 2. * parameters.radius;
      return std::make_unique<CombinedShape<3>>(Combination::difference,
                                                cylinder(parameters.radius, parameters.length),
                                                cylinder(parameters.inner_radius, length),
                                                moments);
    }

    /** What there is in 3D only. */
    std::unique_ptr<Shape<3>>
    make_solid(const ShapeParameters<3> &parameters)
    {
      if (parameters.type == ShapeType::cylinder)
        return std::make_unique<CylinderShape>(
          parameters.centre, parameters.axis, parameters.radius, parameters.length);
      if (parameters.type == ShapeType::tube)
        return make_tube(parameters);
      TriangleMesh mesh = read_closed_mesh(parameters.file);
      transform(
        parameters.scale, rotation_by<3>(parameters.rotation), parameters.translation, mesh);
      return std::make_unique<MeshShape>(mesh, parameters.sample_spacing);
    }

    template <int dim>
    std::unique_ptr<Shape<dim>>
    make_combination(const ShapeParameters<dim> &parameters)
    {
      const Combination combination = parameters.type == ShapeType::union_of ? Combination::union_of
                                      : parameters.type == ShapeType::difference
                                        ? Combination::difference
                                        : Combination::intersection;
      std::unique_ptr<Shape<dim>> result = make_shape(parameters.parts[0]);
      for (std::size_t i = 1; i < parameters.parts.size(); ++i)
        result = std::make_unique<CombinedShape<dim>>(
          combination, std::move(result), make_shape(parameters.parts[i]));
      if (!(result->volume_moments().volume > 0.))
        throw InputError("nothing is left of it; move its parts.");
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<WayOut<dim>>
  ways_by_faces(const std::vector<Vector<dim>> &places,
                const std::vector<double> &depths,
                const double least_depth)
  {
    std::vector<WayOut<dim>> ways;
    double sum = 0.;
    for (std::size_t k = 0; k < places.size(); ++k)
      {
        const double depth = std::max(depths[k], least_depth);
        ways.push_back({places[k], 1. / (depth * depth)});
        sum += ways.back().weight;
      }
    for (WayOut<dim> &way : ways)
      way.weight /= sum;
    return ways;
  }

  template <int dim>
  std::vector<WayOut<dim>>
  Shape<dim>::ways_out(const Vector<dim> &point) const
  {
    const BoundingBox<dim> box         = bounding_box();
    const SurfaceDistance<dim> nearest = surface_distance(point);
    double beyond                      = 1e-9 * norm(box.upper - box.lower);
    Vector<dim> place                  = point + (beyond - nearest.distance) * nearest.normal;
    // The distance of a mesh is a sampled one.
    for (; contains(place) && beyond < norm(box.upper - box.lower); beyond *= 4.)
      place = point + (beyond - nearest.distance) * nearest.normal;
    return {{place, 1.}};
  }

  template <int dim>
  std::unique_ptr<Shape<dim>>
  make_shape(const ShapeParameters<dim> &parameters)
  {
    switch (parameters.type)
      {
        case ShapeType::box:
          return std::make_unique<BoxShape<dim>>(parameters.lower_corner, parameters.upper_corner);
        case ShapeType::sphere:
          return std::make_unique<SphereShape<dim>>(parameters.centre, parameters.radius);
        case ShapeType::ring:
          return make_ring(parameters);
        case ShapeType::points:
          return std::make_unique<PointCloudShape<dim>>(read_point_cloud(parameters));
        case ShapeType::union_of:
        case ShapeType::difference:
        case ShapeType::intersection:
          return make_combination(parameters);
        default:
          if constexpr (dim == 3)
            return make_solid(parameters);
          else
            throw InputError("A cylinder, a tube and a mesh need three dimensions.");
      }
  }

  template std::unique_ptr<Shape<2>>
  make_shape(const ShapeParameters<2> &);
  template std::unique_ptr<Shape<3>>
  make_shape(const ShapeParameters<3> &);
  template std::vector<WayOut<2>>
  ways_by_faces(const std::vector<Vector<2>> &, const std::vector<double> &, double);
  template std::vector<WayOut<3>>
  ways_by_faces(const std::vector<Vector<3>> &, const std::vector<double> &, double);

  template std::vector<WayOut<2>>
  Shape<2>::ways_out(const Vector<2> &) const;
  template std::vector<WayOut<3>>
  Shape<3>::ways_out(const Vector<3> &) const;
} // namespace magmpm
