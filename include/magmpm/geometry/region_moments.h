#pragma once

#include <magmpm/base/tensor.h>

namespace magmpm
{
  /** The smallest box around something [m]. */
  template <int dim>
  struct BoundingBox
  {
    Vector<dim> lower, upper;
  };

  template <int dim>
  inline Vector<dim>
  middle_of(const BoundingBox<dim> &box)
  {
    return 0.5 * (box.lower + box.upper);
  }

  /** [m^3], in 2D [m^2]. */
  template <int dim>
  inline double
  volume_of(const BoundingBox<dim> &box)
  {
    double volume = 1.;
    for (int d = 0; d < dim; ++d)
      volume *= box.upper[d] - box.lower[d];
    return volume;
  }

  /** One of the 2^dim equal parts of a box: the upper half along axis d if bit d of @p number is set. */
  template <int dim>
  inline BoundingBox<dim>
  octant_of(const BoundingBox<dim> &box, const int number)
  {
    BoundingBox<dim> octant  = box;
    const Vector<dim> middle = middle_of(box);
    for (int d = 0; d < dim; ++d)
      (((number >> d) & 1) != 0 ? octant.lower : octant.upper)[d] = middle[d];
    return octant;
  }

  /** Volume and its moments, of a shape filled with density 1; in 2D per metre of depth. */
  template <int dim>
  struct VolumeMoments
  {
    double volume; ///< [m^3], in 2D [m^2]
    Vector<dim> centroid;
    Matrix<dim> second; ///< integral of r r^T about the centroid [m^5], in 2D [m^4]
  };

  /** Moments of a region about a point that whoever holds them knows: those of parts add up. */
  template <int dim>
  struct RegionMoments
  {
    double volume = 0.; ///< [m^3], in 2D [m^2]
    Vector<dim> first;  ///< integral of r [m^4], in 2D [m^3]
    Matrix<dim> second; ///< integral of r r^T [m^5], in 2D [m^4]

    RegionMoments &
    operator+=(const RegionMoments &other)
    {
      volume += other.volume;
      first += other.first;
      second += other.second;
      return *this;
    }
  };

  template <int dim>
  inline RegionMoments<dim>
  operator*(const double factor, const RegionMoments<dim> &moments)
  {
    return {factor * moments.volume, factor * moments.first, factor * moments.second};
  }

  template <int dim>
  inline RegionMoments<dim>
  operator+(RegionMoments<dim> a, const RegionMoments<dim> &b)
  {
    return a += b;
  }

  template <int dim>
  inline RegionMoments<dim>
  operator-(RegionMoments<dim> a, const RegionMoments<dim> &b)
  {
    return a += -1. * b;
  }

  /** The same moments about another point, which lies at @p point seen from the one so far [m]. */
  template <int dim>
  inline RegionMoments<dim>
  moved_to(const RegionMoments<dim> &moments, const Vector<dim> &point)
  {
    const Matrix<dim> mixed = outer(moments.first, point);
    return {moments.volume,
            moments.first - moments.volume * point,
            moments.second + -1. * (mixed + transpose(mixed)) +
              moments.volume * outer(point, point)};
  }

  /** Moments about @p origin [m] of a region whose volume is not 0. */
  template <int dim>
  inline VolumeMoments<dim>
  about_centroid(const RegionMoments<dim> &moments, const Vector<dim> &origin)
  {
    const Vector<dim> centroid = (1. / moments.volume) * moments.first;
    return {moments.volume, origin + centroid, moved_to(moments, centroid).second};
  }

  /** The same as moments about @p origin [m]. */
  template <int dim>
  inline RegionMoments<dim>
  about_point(const VolumeMoments<dim> &moments, const Vector<dim> &origin)
  {
    return moved_to<dim>({moments.volume, {}, moments.second}, origin - moments.centroid);
  }

  /** Of a box about its middle. */
  template <int dim>
  inline RegionMoments<dim>
  moments_of(const BoundingBox<dim> &box)
  {
    RegionMoments<dim> moments;
    moments.volume = volume_of(box);
    for (int d = 0; d < dim; ++d)
      {
        const double edge    = box.upper[d] - box.lower[d];
        moments.second(d, d) = moments.volume * edge * edge / 12.;
      }
    return moments;
  }
} // namespace magmpm
