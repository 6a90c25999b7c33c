#include <magmpm/geometry/common_moments.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace magmpm
{
  namespace
  {
    /** What is less than this part of a box is nothing: rounding. */
    constexpr double nothing = 1e-14;

    /** An estimate holds if those of the parts of the box differ from it by less than this part of a cell. */
    constexpr double agreement = 1e-4;

    /** Moments of the common part where the two lie along different axes of the box. */
    template <int dim>
    RegionMoments<dim>
    product(const RegionMoments<dim> &a,
            const RegionMoments<dim> &b,
            const RegionMoments<dim> &full)
    {
      const double part_a = a.volume / full.volume, part_b = b.volume / full.volume;
      const Matrix<dim> mixed    = (1. / full.volume) * outer(a.first, b.first);
      RegionMoments<dim> moments = part_b * a + part_a * b - (part_a * part_b) * full;
      moments.volume             = part_a * part_b * full.volume;
      moments.second += mixed + transpose(mixed);
      return moments;
    }
  } // namespace

  template <int dim>
  PartsOfBox<dim>::PartsOfBox(const Shape<dim> &first,
                              const Shape<dim> &second,
                              const BoundingBox<dim> &box,
                              const int depth)
    : of_first(first.moments_within(box, depth))
    , of_second(second.moments_within(box, depth))
    , first(first)
    , second(second)
    , box(box)
    , depth(depth)
  {
  }

  template <int dim>
  bool
  PartsOfBox<dim>::both_cross() const
  {
    const double full = volume_of(box);
    const auto cross  = [&](const double volume) {
      return volume > nothing * full && volume < (1. - nothing) * full;
    };
    return cross(of_first.volume) && cross(of_second.volume);
  }

  template <int dim>
  RegionMoments<dim>
  PartsOfBox<dim>::estimate() const
  {
    const RegionMoments<dim> full = moments_of(box);
    if (!both_cross())
      {
        if (std::min(of_first.volume, of_second.volume) <= nothing * full.volume)
          return {};
        return of_first.volume < of_second.volume ? of_first : of_second;
      }
    const double lengths = norm(of_first.first) * norm(of_second.first);
    const double cosine  = lengths > 0. ? dot(of_first.first, of_second.first) / lengths : 0.;
    // One holds the other if they lie in the same direction; if opposite, they share what is too much.
    RegionMoments<dim> extreme;
    if (cosine > 0.)
      extreme = of_first.volume < of_second.volume ? of_first : of_second;
    else if (of_first.volume + of_second.volume > full.volume)
      extreme = of_first + of_second - full;
    const double weight = std::min(1., std::abs(cosine));
    return weight * extreme + (1. - weight) * product(of_first, of_second, full);
  }

  template <int dim>
  RegionMoments<dim>
  PartsOfBox<dim>::common() const
  {
    const RegionMoments<dim> of_whole = estimate();
    if (depth == 0 || !both_cross())
      return of_whole;
    std::vector<PartsOfBox<dim>> parts;
    RegionMoments<dim> sum;
    const auto add = [&](const RegionMoments<dim> &moments, const PartsOfBox<dim> &part) {
      sum += moved_to(moments, middle_of(box) - middle_of(part.box));
    };
    for (int i = 0; i < (1 << dim); ++i)
      {
        parts.emplace_back(first, second, octant_of(box, i), depth - 1);
        add(parts.back().estimate(), parts.back());
      }
    const double cell = volume_of(box) * std::pow(2., dim * (cell_depth<dim> - depth));
    if (std::abs(sum.volume - of_whole.volume) < agreement * cell)
      return sum;
    sum = {};
    for (const PartsOfBox<dim> &part : parts)
      add(part.common(), part);
    return sum;
  }

  template struct PartsOfBox<2>;
  template struct PartsOfBox<3>;
} // namespace magmpm
