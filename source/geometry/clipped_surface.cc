#include <magmpm/geometry/clipped_surface.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    template <int dim>
    class Clipping
    {
    public:
      using Facet = std::array<Vector<dim>, dim>;

      Clipping(const Shape<dim> &shape, const bool keeps_inside, const double spacing)
        : shape(shape)
        , sign(keeps_inside ? 1. : -1.)
        , spacing(spacing)
      {
      }

      /** Adds what is left of a facet to the result. */
      void
      add(const Facet &facet)
      {
        int longest = 0;
        for (int i = 1; i < n_edges; ++i)
          if (edge(facet, i) > edge(facet, longest))
            longest = i;
        const double length = edge(facet, longest);
        if (length > spacing && std::abs(shape.surface_distance(facet[0]).distance) <= length)
          {
            const int next           = (longest + 1) % dim;
            const Vector<dim> middle = 0.5 * (facet[longest] + facet[next]);
            Facet half               = facet;
            half[longest]            = middle;
            add(half);
            half       = facet;
            half[next] = middle;
            add(half);
          }
        else
          clip(facet);
      }

      SurfaceMesh<dim> result;

    private:
      static constexpr int n_edges = (dim == 2 ? 1 : 3);

      const Shape<dim> &shape;
      const double sign;
      const double spacing;

      static double
      edge(const Facet &facet, const int i)
      {
        return norm(facet[(i + 1) % dim] - facet[i]);
      }

      void
      clip(const Facet &facet)
      {
        std::array<double, dim> distance;
        for (int i = 0; i < dim; ++i)
          distance[i] = sign * shape.surface_distance(facet[i]).distance;
        std::vector<Vector<dim>> kept;
        for (int i = 0; i < dim; ++i)
          {
            if (distance[i] <= 0.)
              kept.push_back(facet[i]);
            const int next = (i + 1) % dim;
            if (i < n_edges && (distance[i] <= 0.) != (distance[next] <= 0.))
              kept.push_back(facet[i] + (distance[i] / (distance[i] - distance[next])) *
                                          (facet[next] - facet[i]));
          }
        const int first = static_cast<int>(result.points.size());
        const int n     = static_cast<int>(kept.size());
        if (n < dim)
          return;
        result.points.insert(result.points.end(), kept.begin(), kept.end());
        if constexpr (dim == 2)
          result.facets.push_back({{first, first + 1}});
        else
          for (int i = 1; i + 1 < n; ++i)
            result.facets.push_back({{first, first + i, first + i + 1}});
      }
    };
  } // namespace

  template <int dim>
  SurfaceMesh<dim>
  clipped_surface(const SurfaceMesh<dim> &surface,
                  const Shape<dim> &shape,
                  const bool keeps_inside,
                  const double spacing)
  {
    Clipping<dim> clipping(shape, keeps_inside, spacing);
    for (const std::array<int, dim> &facet : surface.facets)
      {
        std::array<Vector<dim>, dim> corners;
        for (int i = 0; i < dim; ++i)
          corners[i] = surface.points[facet[i]];
        clipping.add(corners);
      }
    return clipping.result;
  }

  template SurfaceMesh<2>
  clipped_surface(const SurfaceMesh<2> &, const Shape<2> &, bool, double);
  template SurfaceMesh<3>
  clipped_surface(const SurfaceMesh<3> &, const Shape<3> &, bool, double);
} // namespace magmpm
