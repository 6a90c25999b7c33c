#include <magmpm/particles/undeformed_moments.h>

namespace magmpm
{
  template <int dim>
  RegionMoments<dim>
  undeformed_moments(const ParticleSet<dim> &particles, const Vector<dim> &origin)
  {
    const double *volumes = particles.component(ParticleProperty::volume, 0);
    RegionMoments<dim> sum;
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        const Vector<dim> r = particles.position(p) - origin;
        sum += {volumes[p], volumes[p] * r, volumes[p] * outer(r, r)};
      }
    return sum;
  }

  template RegionMoments<2>
  undeformed_moments(const ParticleSet<2> &, const Vector<2> &);
  template RegionMoments<3>
  undeformed_moments(const ParticleSet<3> &, const Vector<3> &);
} // namespace magmpm
