#pragma once

#include <algorithm>

namespace magmpm
{
  /** Where a volume counts as full, it does so at least as much as this: w of SharpFraction. */
  inline constexpr double smallest_full_volume = 1e-3;

  /** How wide the transition from 0 to 1 is, in v/w. */
  inline constexpr double sharp_transition = 0.8;

  /** How far v/w is through the transition: t = clip(1/2 + (v/w - 1/2)/0.8); w as interpolated. */
  inline double
  through_transition(const double volume, const double full)
  {
    // Nodes that are not active count as zero.
    const double w = std::max(full, smallest_full_volume);
    return std::min(std::max(0.5 + (volume / w - 0.5) / sharp_transition, 0.), 1.);
  }

  /** f = w smoothstep(t), the fraction of material at a point with these interpolated v and w. */
  inline double
  sharp_fraction(const double volume, const double full)
  {
    if (!(volume > 0.))
      return 0.;
    const double t = through_transition(volume, full);
    return std::max(full, smallest_full_volume) * t * t * (3. - 2. * t);
  }

  /** df/dv at fixed w: |grad f| = df/dv |grad v|. */
  inline double
  sharp_slope(const double volume, const double full)
  {
    const double t = through_transition(volume, full);
    return 6. / sharp_transition * t * (1. - t);
  }
} // namespace magmpm
