#include <magmpm/magnets/external_field.h>
#include <magmpm/magnets/uniform_field.h>

#include <algorithm>
#include <limits>

namespace magmpm
{
  template <int dim>
  ExternalField<dim>::ExternalField(const std::vector<SourceParameters<dim>> &parameters)
  {
    for (const SourceParameters<dim> &source : parameters)
      switch (source.type)
        {
          case SourceType::uniform_field:
            all_sources.push_back(std::make_unique<UniformField<dim>>(source));
            break;
          case SourceType::magnetized_sphere:
            {
              auto sphere = std::make_unique<MagnetizedSphere<dim>>(source);
              if (sphere->contact() != ContactCondition::none)
                solids.push_back(sphere.get());
              all_sources.push_back(std::move(sphere));
              break;
            }
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
  bool
  ExternalField<dim>::is_solid(const Vector<dim> &point) const
  {
    return std::any_of(solids.begin(), solids.end(), [&](const MagnetizedSphere<dim> *sphere) {
      return norm_square(point - sphere->centre()) < sphere->radius() * sphere->radius();
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
    remembered.clear();
    for (const auto &source : all_sources)
      remembered.push_back({source->strength(), source->centre()});
    has_remembered = true;
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
        const Vector<dim> now = all_sources[s]->strength();
        const double scale    = std::max(norm(now), norm(remembered[s].strength));
        // A source that is off now and then did not change, wherever it went meanwhile.
        if (scale == 0.)
          continue;
        change.relative_strength = std::max(change.relative_strength,
                                            norm(now - remembered[s].strength) / scale);
        change.displacement      = std::max(change.displacement,
                                       norm(all_sources[s]->centre() - remembered[s].centre));
      }
    return change;
  }

  template class ExternalField<2>;
  template class ExternalField<3>;
} // namespace magmpm
