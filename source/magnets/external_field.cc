#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/magnets/make_source.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace magmpm
{
  template <int dim>
  ExternalField<dim>::ExternalField(const std::vector<SourceParameters<dim>> &parameters)
  {
    for (const SourceParameters<dim> &source : parameters)
      {
        all_sources.push_back(make_source(source));
        views.push_back(all_sources.back().get());
        if (all_sources.back()->is_solid())
          solids.push_back(all_sources.back().get());
        if (all_sources.back()->refuses_material())
          refusing.push_back(all_sources.back().get());
      }
  }

  template <int dim>
  void
  ExternalField<dim>::set_time(const double time)
  {
    for (const auto &source : all_sources)
      source->set_time(time);
  }

  template <int dim>
  void
  ExternalField<dim>::set_pose(const std::size_t source, const Pose<dim> &pose)
  {
    all_sources[source]->set_pose(pose);
  }

  template <int dim>
  Vector<dim>
  ExternalField<dim>::field(const Vector<dim> &point) const
  {
    Vector<dim> sum;
    for (const auto &source : all_sources)
      sum += source->field(point);
    return sum;
  }

  template <int dim>
  Matrix<dim>
  ExternalField<dim>::field_gradient(const Vector<dim> &point) const
  {
    Matrix<dim> sum;
    for (const auto &source : all_sources)
      sum += source->field_gradient(point);
    return sum;
  }

  template <int dim>
  Vector<dim>
  ExternalField<dim>::magnetization(const Vector<dim> &point) const
  {
    Vector<dim> sum;
    for (const auto &source : all_sources)
      sum += source->magnetization(point);
    return sum;
  }

  template <int dim>
  bool
  ExternalField<dim>::is_solid(const Vector<dim> &point) const
  {
    return std::any_of(solids.begin(), solids.end(), [&](const MagneticSource<dim> *source) {
      return source->shape()->contains(source->pose().to_own(point));
    });
  }

  template <int dim>
  void
  ExternalField<dim>::check_material_at(const Vector<dim> &point) const
  {
    for (const MagneticSource<dim> *source : refusing)
      if (source->shape()->contains(source->pose().to_own(point)))
        {
          std::ostringstream place;
          for (int d = 0; d < dim; ++d)
            place << (d == 0 ? "" : ", ") << point[d];
          throw RunError("Magnetic material came to " + place.str() +
                         " m, inside of the core of the point dipole '" + source->name() +
                         "', where its field has no meaning. Keep them apart, make its Radius "
                         "smaller, or take a magnetized sphere, which may be solid (Contact).");
        }
  }

  template <int dim>
  std::optional<ForceAndTorque<dim>>
  ExternalField<dim>::force_and_torque(const MagneticSource<dim> &source) const
  {
    return source.force_and_torque([&](const Vector<dim> &point) {
      LocalField<dim> sum;
      for (const auto &other : all_sources)
        if (other.get() != &source)
          {
            sum.field += other->field(point);
            sum.gradient += other->field_gradient(point);
          }
      return sum;
    });
  }

  template <int dim>
  bool
  ExternalField<dim>::is_absent() const
  {
    return std::all_of(all_sources.begin(), all_sources.end(), [](const auto &source) {
      return source->is_constant() && norm(source->strength()) == 0.;
    });
  }

  template <int dim>
  bool
  ExternalField<dim>::is_constant() const
  {
    return std::all_of(all_sources.begin(), all_sources.end(), [](const auto &source) {
      return source->is_constant();
    });
  }

  template <int dim>
  void
  ExternalField<dim>::remember()
  {
    kept.clear();
    for (const auto &source : all_sources)
      kept.push_back({source->strength(), source->pose()});
    has_remembered = true;
  }

  template <int dim>
  void
  ExternalField<dim>::remember(const std::vector<SourceSnapshot<dim>> &snapshots)
  {
    kept           = snapshots;
    has_remembered = (kept.size() == all_sources.size());
  }

  template <int dim>
  typename ExternalField<dim>::Change
  ExternalField<dim>::change_since_remembered() const
  {
    if (!has_remembered)
      return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

    Change change = {0., 0.};
    for (std::size_t s = 0; s < all_sources.size(); ++s)
      {
        const MagneticSource<dim> &source = *all_sources[s];
        const Vector<dim> now = source.strength(), then = kept[s].strength;
        const double scale = std::max(norm(now), norm(then));
        // A source that is off now and then did not change, wherever it went meanwhile.
        if (scale == 0.)
          continue;
        // 2 sin(a/2) for a rotation by the angle a, of the whole source or of its axis.
        const double turn =
          source.is_axisymmetric()
            ? (norm(now) > 0. && norm(then) > 0.
                 ? norm((1. / norm(now)) * now - (1. / norm(then)) * then)
                 : 0.)
            : frobenius_norm(source.pose().rotation + (-1.) * kept[s].pose.rotation) /
                std::sqrt(2.);
        change.relative_strength = std::max(change.relative_strength, norm(now - then) / scale);
        if (!source.is_axisymmetric())
          change.relative_strength = std::max(change.relative_strength, turn);
        change.displacement =
          std::max(change.displacement,
                   norm(source.pose().position - kept[s].pose.position) + turn * source.reach());
      }
    return change;
  }

  template class ExternalField<2>;
  template class ExternalField<3>;
} // namespace magmpm
