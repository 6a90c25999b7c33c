#pragma once

#include <magmpm/geometry/shape.h>

#include <functional>

namespace magmpm
{
  /**
   * Distance from a surface and its normal, sampled on a grid and interpolated linearly along each
   * axis.
   *
   * The samples are exact. Between them the distance errs by about h^2/(8 R) where the surface is
   * curved with radius R, and by up to 0.3 h at sharp edges and in the middle between two walls; the
   * normal turns over an edge within h. Beyond the grid the nearest point of its boundary names a
   * surface point, and the distance is the one from that: never shorter than the true one, and longer
   * by less than the margin around the surface over the distance.
   */
  class DistanceSamples
  {
  public:
    /**
     * @param box       around the surface [m].
     * @param spacing   of the samples, h [m].
     * @param distance  at a point, asked once for each sample.
     */
    DistanceSamples(const BoundingBox<3> &box,
                    const double spacing,
                    const std::function<SurfaceDistance<3>(const Vector<3> &)> &distance);

    SurfaceDistance<3>
    at(const Vector<3> &point) const;

    double
    spacing() const
    {
      return h;
    }

    std::size_t
    size() const
    {
      return samples.size();
    }

  private:
    /** A distance [m] and a normal: four numbers, which fill a register. */
    using Sample = Vector<4, float>;

    double h;
    Vector<3> lower; ///< corner of the grid
    int n[3];        ///< samples along each axis
    std::vector<Sample> samples;

    SurfaceDistance<3>
    inside(const Vector<3> &point) const;
  };
} // namespace magmpm
