#include <magmpm/coupling/carried_reaction.h>
#include <magmpm/coupling/magnet_forces.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  template <int dim>
  MagnetForces<dim>::MagnetForces(const ExternalField<dim> &sources)
    : sources(sources)
  {
  }

  template <int dim>
  std::vector<ForceAndTorque<dim>>
  MagnetForces<dim>::total(const CarriedReactions<dim> &reactions)
  {
    const auto &all = sources.sources();
    if (!is_known())
      {
        by_sources.assign(all.size(), {});
        for (std::size_t s = 0; s < all.size() && all.size() > 1; ++s)
          by_sources[s] = sources.force_and_torque(*all[s]).value_or(ForceAndTorque<dim>());
      }
    std::vector<ForceAndTorque<dim>> result = by_sources;
    for (std::size_t s = 0; s < all.size(); ++s)
      {
        const ForceAndTorque<dim> by_material = reactions.on(s);
        result[s].force += by_material.force;
        result[s].torque += by_material.torque;
      }
    return result;
  }

  template <int dim>
  double
  MagnetForces<dim>::swing_rate(const std::size_t source, const double inertia) const
  {
    const MagneticSource<dim> &magnet = *sources.sources()[source];
    Vector<dim> field;
    for (const auto &other : sources.sources())
      if (other != &magnet)
        field += other->field(magnet.pose().position);
    // A uniform field along each axis in turn finds the moment, whatever the magnet is.
    double square = 0.;
    for (int d = 0; d < dim; ++d)
      {
        LocalField<dim> uniform = {};
        uniform.field[d]        = norm(field);
        const auto result = magnet.force_and_torque([&](const Vector<dim> &) { return uniform; });
        if (result)
          square += norm_square(result->torque);
      }
    return std::sqrt(std::sqrt(square) / inertia);
  }

  template <int dim>
  bool
  MagnetForces<dim>::is_known()
  {
    std::vector<unsigned long> revisions;
    for (const auto &source : sources.sources())
      revisions.push_back(source->revision());
    if (revisions == known_revisions)
      return true;
    known_revisions = revisions;
    return false;
  }

  template class MagnetForces<2>;
  template class MagnetForces<3>;
} // namespace magmpm
