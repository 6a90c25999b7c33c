#include <magmpm/base/constants.h>
#include <magmpm/particles/cell_places.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    struct LinePlace
    {
      double position; ///< from -1/2 to 1/2
      double weight;
    };

    /** The place of Gauss' rule next to @p start on (-1, 1): a zero of the Legendre polynomial P_n. */
    LinePlace
    gauss_place(const int n, const double start)
    {
      double x = start, derivative = 1.;
      for (int step = 0; step < 20; ++step)
        {
          double value = x, before = 1.; // P_1, P_0
          for (int k = 2; k <= n; ++k)
            {
              const double next = ((2. * k - 1.) * x * value - (k - 1.) * before) / k;
              before            = value;
              value             = next;
            }
          derivative = n * (before - x * value) / (1. - x * x);
          x -= value / derivative;
        }
      return {0.5 * x, 1. / ((1. - x * x) * derivative * derivative)};
    }

    std::vector<LinePlace>
    line_places(const PlaceRule rule, const int n)
    {
      std::vector<LinePlace> places(n, {0., 1. / n});
      for (int i = 0; i < n && rule == PlaceRule::centres; ++i)
        places[i].position = (i + 0.5) / n - 0.5;
      // Both halves from one, so that they are symmetric to the last bit.
      for (int i = 0; i < n && rule == PlaceRule::gauss; ++i)
        {
          const int from_end = std::min(i, n - 1 - i);
          if (2 * from_end + 1 == n)
            places[i] = {0., gauss_place(n, 0.).weight};
          else
            {
              places[i] = gauss_place(n, -std::cos(constants::pi * (from_end + 0.75) / (n + 0.5)));
              places[i].position *= (i == from_end ? 1. : -1.);
            }
        }
      return places;
    }
  } // namespace

  template <int dim>
  std::vector<CellPlace<dim>>
  cell_places(const PlaceRule rule, const int n, const Arrangement arrangement, const int parity)
  {
    const std::vector<LinePlace> line = line_places(rule, n);
    std::vector<CellPlace<dim>> places;
    double sum = 0.;
    for (int number = 0; number < power(n, dim); ++number)
      {
        CellPlace<dim> place = {number, {}, 1.};
        int sum_of_places    = parity;
        for (int d = 0, rest = number; d < dim; rest /= n, ++d)
          {
            place.position[d] = line[rest % n].position;
            place.weight *= line[rest % n].weight;
            sum_of_places += rest % n;
          }
        if (arrangement == Arrangement::face_centred && sum_of_places % 2 != 0)
          continue;
        sum += place.weight;
        places.push_back(place);
      }
    for (CellPlace<dim> &place : places)
      place.weight /= sum;
    return places;
  }

  template std::vector<CellPlace<2>>
  cell_places(PlaceRule, int, Arrangement, int);
  template std::vector<CellPlace<3>>
  cell_places(PlaceRule, int, Arrangement, int);
} // namespace magmpm
