#include <magmpm/geometry/box_shape.h>

#include <cmath>
#include <limits>

namespace magmpm
{
  template <int dim>
  BoxShape<dim>::BoxShape(const Vector<dim> &lower_corner, const Vector<dim> &upper_corner)
    : box{lower_corner, upper_corner}
  {
  }

  template <int dim>
  bool
  BoxShape<dim>::contains(const Vector<dim> &point) const
  {
    for (int d = 0; d < dim; ++d)
      if (point[d] < box.lower[d] || point[d] > box.upper[d])
        return false;
    return true;
  }

  template <int dim>
  SurfaceDistance<dim>
  BoxShape<dim>::surface_distance(const Vector<dim> &point) const
  {
    // How far beyond the nearer face along each axis; negative between the faces.
    Vector<dim> outside;
    double largest = -std::numeric_limits<double>::infinity();
    int nearest    = 0;
    double side    = 1.;
    for (int d = 0; d < dim; ++d)
      {
        const double below = box.lower[d] - point[d], above = point[d] - box.upper[d];
        const double beyond = std::max(below, above);
        outside[d]          = beyond <= 0. ? 0. : (above > below ? beyond : -beyond);
        if (beyond > largest)
          {
            largest = beyond;
            nearest = d;
            side    = above > below ? 1. : -1.;
          }
      }
    if (largest > 0.)
      {
        const double distance = norm(outside);
        return {distance, (1. / distance) * outside};
      }
    Vector<dim> normal;
    normal[nearest] = side;
    return {largest, normal};
  }

  template <int dim>
  std::vector<WayOut<dim>>
  BoxShape<dim>::ways_out(const Vector<dim> &point) const
  {
    const double beyond = 1e-9 * norm(box.upper - box.lower);
    std::vector<Vector<dim>> places;
    std::vector<double> depths;
    for (int d = 0; d < dim; ++d)
      for (const bool is_upper : {false, true})
        {
          const double face = (is_upper ? box.upper : box.lower)[d];
          places.push_back(point);
          places.back()[d] = face + (is_upper ? beyond : -beyond);
          depths.push_back(std::abs(face - point[d]));
        }
    return ways_by_faces(places, depths, beyond);
  }

  template <int dim>
  BoundingBox<dim>
  BoxShape<dim>::bounding_box() const
  {
    return box;
  }

  template <int dim>
  VolumeMoments<dim>
  BoxShape<dim>::volume_moments() const
  {
    const RegionMoments<dim> moments = moments_of(box);
    return {moments.volume, middle_of(box), moments.second};
  }

  template <int dim>
  RegionMoments<dim>
  BoxShape<dim>::moments_within(const BoundingBox<dim> &cell, const int /*depth*/) const
  {
    BoundingBox<dim> part;
    for (int d = 0; d < dim; ++d)
      {
        part.lower[d] = std::max(box.lower[d], cell.lower[d]);
        part.upper[d] = std::min(box.upper[d], cell.upper[d]);
        if (!(part.upper[d] > part.lower[d]))
          return {};
      }
    return moved_to(moments_of(part), middle_of(cell) - middle_of(part));
  }

  template <int dim>
  std::vector<Vector<dim>>
  BoxShape<dim>::surface_points(const double spacing) const
  {
    int n[dim]; // intervals along each edge
    for (int d = 0; d < dim; ++d)
      n[d] = static_cast<int>(std::ceil((box.upper[d] - box.lower[d]) / spacing));

    std::vector<Vector<dim>> points;
    int i[dim] = {};
    while (i[dim - 1] <= n[dim - 1])
      {
        Vector<dim> point;
        bool at_end = false; // along another axis than the first
        for (int d = 0; d < dim; ++d)
          {
            const double part = static_cast<double>(i[d]) / n[d];
            point[d]          = (1. - part) * box.lower[d] + part * box.upper[d];
            at_end            = at_end || (d > 0 && (i[d] == 0 || i[d] == n[d]));
          }
        points.push_back(point);
        i[0] += at_end ? 1 : n[0];
        for (int d = 0; d + 1 < dim && i[d] > n[d]; ++d)
          {
            i[d] = 0;
            ++i[d + 1];
          }
      }
    return points;
  }

  template <int dim>
  SurfaceMesh<dim>
  BoxShape<dim>::surface_mesh(const double /*spacing*/) const
  {
    SurfaceMesh<dim> mesh;
    for (int corner = 0; corner < (1 << dim); ++corner)
      {
        Vector<dim> point;
        for (int d = 0; d < dim; ++d)
          point[d] = ((corner >> d) & 1) ? box.upper[d] : box.lower[d];
        mesh.points.push_back(point);
      }
    if constexpr (dim == 2)
      mesh.facets = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
    else
      mesh.facets = {{0, 2, 3},
                     {0, 3, 1},
                     {4, 5, 7},
                     {4, 7, 6},
                     {0, 1, 5},
                     {0, 5, 4},
                     {2, 6, 7},
                     {2, 7, 3},
                     {0, 4, 6},
                     {0, 6, 2},
                     {1, 3, 7},
                     {1, 7, 5}};
    return mesh;
  }

  template class BoxShape<2>;
  template class BoxShape<3>;
} // namespace magmpm
