#include <verification/magnetostatics/block_errors.h>
#include <verification/magnetostatics/block_reference.h>
#include <verification/magnetostatics/sources.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double outer_field = 1e5; ///< [A/m]; errors do not depend on it

    template <int dim>
    Region<dim>
    block_region(const BlockShape<dim> &shape, const Vector<dim> &centre, const double unit)
    {
      double half_width = 0.;
      for (int d = 0; d < dim; ++d)
        half_width = std::max(half_width, 0.5 * unit * shape.edges[d]);
      const auto contains = [=](const Vector<dim> &x) {
        double square = 0.;
        for (int d = 0; d < dim; ++d)
          {
            const double place = std::abs(x[d] - centre[d]) / (0.5 * unit * shape.edges[d]);
            if (place > 1.)
              return false;
            square += (d < dim - 1 ? place * place : 0.);
          }
        return !shape.is_round || square <= 1.;
      };
      return {contains, centre, half_width};
    }

    template <int dim>
    double
    block_volume(const BlockShape<dim> &shape, const double unit)
    {
      double volume = shape.is_round ? 0.25 * M_PI : 1.;
      for (int d = 0; d < dim; ++d)
        volume *= unit * shape.edges[d];
      return volume;
    }

    /** Moves points to where a scene seeds them: in the middle of equal parts of the block. */
    template <int dim>
    std::vector<Vector<dim>>
    seeded_points(const BlockShape<dim> &shape, const Vector<dim> &centre, const double unit)
    {
      constexpr int per_edge = (dim == 3 ? 2 : 3);
      std::array<int, dim> n;
      long total = 1;
      for (int d = 0; d < dim; ++d)
        {
          n[d] = static_cast<int>(std::lround(per_edge * unit * shape.edges[d] / case_spacing));
          total *= n[d];
        }
      std::vector<Vector<dim>> points;
      for (long i = 0; i < total; ++i)
        {
          points.push_back(centre);
          long rest = i;
          for (int d = 0; d < dim; ++d)
            {
              const double place = (static_cast<double>(rest % n[d]) + 0.5) / n[d] - 0.5;
              points.back()[d] += unit * shape.edges[d] * place;
              rest /= n[d];
            }
        }
      return points;
    }
  } // namespace

  template <int dim>
  BlockErrors<dim>::BlockErrors(const BlockShape<dim> &shape)
    : shape(shape)
  {
  }

  template <int dim>
  double
  BlockErrors<dim>::exact_magnetization(const double susceptibility) const
  {
    if (shape.is_round)
      return magnetization_of_block<2>(
        {{0.5 * shape.edges[0], 0.5 * shape.edges[dim - 1]}}, susceptibility, true);
    return magnetization_of_block<dim>(0.5 * shape.edges, susceptibility);
  }

  template <int dim>
  Errors
  BlockErrors<dim>::operator()(const AccuracyCase &accuracy_case)
  {
    if (susceptibility_of_reference != accuracy_case.susceptibility)
      reference = exact_magnetization(accuracy_case.susceptibility);
    susceptibility_of_reference = accuracy_case.susceptibility;

    const double unit    = accuracy_case.resolution * case_spacing; // the length of the last edge
    const double longest = accuracy_case.resolution *
                           *std::max_element(shape.edges.values, shape.edges.values + dim);
    CaseSetup<dim> setup(accuracy_case, std::max(2. * longest, 32.));
    PointBody<dim> body = setup.body(block_region(shape, setup.centre, unit),
                                     block_volume(shape, unit));
    if (!shape.is_round)
      body.points = seeded_points(shape, setup.centre, unit);
    Vector<dim> field;
    field[dim - 1] = outer_field;
    setup.magnetics.set_bodies({body});
    setup.magnetics.solve(ExternalField<dim>({uniform_source(field)}));
    const double found = setup.magnetics.moment()[dim - 1] / (body.volume * outer_field);
    return {{"moment", found / reference - 1.}};
  }

  template class BlockErrors<2>;
  template class BlockErrors<3>;
} // namespace magmpm::verification
