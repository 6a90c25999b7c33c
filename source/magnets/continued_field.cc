#include <magmpm/magnets/continued_field.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    template <int dim>
    bool
    contains(const MagneticSource<dim> &source, const Vector<dim> &point)
    {
      return source.shape()->contains(source.pose().to_own(point));
    }

    /** Whether a point is less than @p distance from a box. */
    template <int dim>
    bool
    is_in_box(const BoundingBox<dim> &box, const Vector<dim> &point, const double distance)
    {
      for (int d = 0; d < dim; ++d)
        if (point[d] < box.lower[d] - distance || point[d] > box.upper[d] + distance)
          return false;
      return true;
    }
  } // namespace

  template <int dim>
  ContinuedField<dim>::ContinuedField(const ExternalField<dim> &sources)
    : sources(sources)
  {
  }

  template <int dim>
  LocalField<dim>
  ContinuedField<dim>::at(const Vector<dim> &point, const double edge) const
  {
    return local_field(sources, point, edge);
  }

  template <int dim>
  LocalField<dim>
  ContinuedField<dim>::of(const MagneticSource<dim> &source,
                          const Vector<dim> &point,
                          const double edge) const
  {
    return local_field(source, point, edge);
  }

  template <int dim>
  template <typename Field>
  LocalField<dim>
  ContinuedField<dim>::local_field(const Field &field,
                                   const Vector<dim> &point,
                                   const double edge) const
  {
    const MagneticSource<dim> *solid = solid_around(point);
    LocalField<dim> local            = {};
    local.field                      = (solid ? mean_field(field, point) : field.field(point));

    const bool is_near = std::any_of(
      sources.solid_sources().begin(), sources.solid_sources().end(), [&](const auto *source) {
        return is_in_box(source->shape()->bounding_box(), source->pose().to_own(point), edge);
      });
    // How much of the cube is inside, and the middle of what is.
    constexpr int n_1d = 4, n_all = (dim == 2 ? 16 : 64);
    int n_inside = 0;
    Vector<dim> sum;
    for (int n = 0; n < n_all && is_near; ++n)
      {
        Vector<dim> place;
        for (int d = 0, rest = n; d < dim; ++d, rest /= n_1d)
          place[d] = ((rest % n_1d + 0.5) / n_1d - 0.5) * edge;
        if (!solid_around(point + place))
          continue;
        ++n_inside;
        sum += place;
      }
    if (n_inside == 0 || n_inside == n_all)
      local.gradient = gradient(field, solid, point);
    else
      {
        const Vector<dim> inside  = point + (1. / n_inside) * sum;
        const Vector<dim> outside = point - (1. / (n_all - n_inside)) * sum;
        const double part         = static_cast<double>(n_inside) / n_all;
        local.gradient            = part * gradient(field, solid_around(inside), inside) +
                         (1. - part) * gradient(field, solid_around(outside), outside);
      }
    return local;
  }

  template <int dim>
  const MagneticSource<dim> *
  ContinuedField<dim>::solid_around(const Vector<dim> &point) const
  {
    for (const MagneticSource<dim> *solid : sources.solid_sources())
      if (contains(*solid, point))
        return solid;
    return nullptr;
  }

  template <int dim>
  std::vector<WayOut<dim>>
  ContinuedField<dim>::places(const Vector<dim> &point) const
  {
    std::vector<WayOut<dim>> all = {{point, 1.}};
    // Twice: the way out of one may lead into another that was asked before.
    for (int pass = 0; pass < 2; ++pass)
      for (const MagneticSource<dim> *solid : sources.solid_sources())
        {
          std::vector<WayOut<dim>> outside;
          for (const WayOut<dim> &way : all)
            if (contains(*solid, way.place))
              for (const WayOut<dim> &out :
                   solid->shape()->ways_out(solid->pose().to_own(way.place)))
                outside.push_back({solid->pose().to_world(out.place), way.weight * out.weight});
            else
              outside.push_back(way);
          all = outside;
        }
    return all;
  }

  template <int dim>
  template <typename Field>
  Vector<dim>
  ContinuedField<dim>::mean_field(const Field &field, const Vector<dim> &point) const
  {
    Vector<dim> sum;
    for (const WayOut<dim> &way : places(point))
      sum += way.weight * field.field(way.place);
    return sum;
  }

  template <int dim>
  template <typename Field>
  Matrix<dim>
  ContinuedField<dim>::gradient(const Field &field,
                                const MagneticSource<dim> *solid,
                                const Vector<dim> &point) const
  {
    if (solid == nullptr)
      return field.field_gradient(point);
    const BoundingBox<dim> box = solid->shape()->bounding_box();
    const double step          = 1e-6 * norm(box.upper - box.lower);
    Matrix<dim> gradient;
    for (int i = 0; i < dim; ++i)
      {
        Vector<dim> way;
        way[i]                     = step;
        const Vector<dim> increase = mean_field(field, point + way) -
                                     mean_field(field, point - way);
        for (int j = 0; j < dim; ++j)
          gradient(i, j) = increase[j] / (2. * step);
      }
    return gradient;
  }

  template class ContinuedField<2>;
  template class ContinuedField<3>;
} // namespace magmpm
