#include <magmpm/io/body_geometry.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Lengths that differ by less than this part of themselves are the same. */
    constexpr double tolerance = 1e-9;

    template <int dim>
    bool
    boxes_overlap(const BodyParameters<dim> &a, const BodyParameters<dim> &b)
    {
      for (int d = 0; d < dim; ++d)
        {
          const double shared = std::min(a.upper_corner[d], b.upper_corner[d]) -
                                std::max(a.lower_corner[d], b.lower_corner[d]);
          if (shared <= tolerance * (a.upper_corner[d] - a.lower_corner[d]))
            return false;
        }
      return true;
    }
  } // namespace

  template <int dim>
  Extent<dim>
  extent(const BodyParameters<dim> &body)
  {
    if (body.shape == ShapeType::box)
      return {body.lower_corner, body.upper_corner};

    Extent<dim> result = {body.centre, body.centre};
    for (int d = 0; d < dim; ++d)
      {
        double reach = body.radius;
        if (body.shape == ShapeType::cylinder)
          {
            // The caps are discs: along d they reach R times the sine of their axis' angle to it.
            const double cosine = std::abs(body.axis[d]) / norm(body.axis);
            reach               = 0.5 * body.length * cosine +
                    body.radius * std::sqrt(std::max(0., 1. - cosine * cosine));
          }
        result.lower[d] -= reach;
        result.upper[d] += reach;
      }
    return result;
  }

  template <int dim>
  double
  distance(const BodyParameters<dim> &body, const Vector<dim> &point)
  {
    if (body.shape == ShapeType::box)
      {
        Vector<dim> outside;
        for (int d = 0; d < dim; ++d)
          outside[d] =
            std::max({0., body.lower_corner[d] - point[d], point[d] - body.upper_corner[d]});
        return norm(outside);
      }

    const Vector<dim> from_centre = point - body.centre;
    if (body.shape == ShapeType::sphere)
      return std::max(0., norm(from_centre) - body.radius);

    const double along  = dot(from_centre, body.axis) / norm(body.axis);
    const double across = std::sqrt(std::max(0., norm_square(from_centre) - along * along));
    return std::hypot(std::max(0., std::abs(along) - 0.5 * body.length),
                      std::max(0., across - body.radius));
  }

  template <int dim>
  bool
  overlap(const BodyParameters<dim> &a, const BodyParameters<dim> &b)
  {
    if (a.shape == ShapeType::sphere)
      return distance(b, a.centre) < (1. - tolerance) * a.radius;
    if (b.shape == ShapeType::sphere)
      return overlap(b, a);
    return a.shape == ShapeType::box && b.shape == ShapeType::box && boxes_overlap(a, b);
  }

  template Extent<2>
  extent(const BodyParameters<2> &);
  template Extent<3>
  extent(const BodyParameters<3> &);
  template double
  distance(const BodyParameters<2> &, const Vector<2> &);
  template double
  distance(const BodyParameters<3> &, const Vector<3> &);
  template bool
  overlap(const BodyParameters<2> &, const BodyParameters<2> &);
  template bool
  overlap(const BodyParameters<3> &, const BodyParameters<3> &);
} // namespace magmpm
