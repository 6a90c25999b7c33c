
#include <verification/mechanics/elastica.h>
#include <verification/mechanics/free_beam.h>
#include <verification/mechanics/free_solid.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi          = 3.14159265358979323846;
    constexpr double half_length = 0.02; // m
    constexpr double thickness   = 1e-3; // m

    FreeSolidParameters<2>
    parameters_of(const FreeBeam &beam)
    {
      FreeSolidParameters<2> parameters;
      parameters.spacing        = thickness / beam.cells;
      parameters.poisson_ratio  = beam.poisson_ratio;
      parameters.transfer       = beam.transfer;
      parameters.elastic_factor = beam.elastic_factor;
      const double x            = 2. * half_length;
      const double y            = x + beam.offset * parameters.spacing;
      parameters.lower_corner   = {{x - half_length, y}};
      parameters.upper_corner   = {{x + half_length, y + thickness}};
      return parameters;
    }

    /** Bending stiffness per metre of depth [N m]. */
    double
    stiffness_of(const FreeSolidParameters<2> &parameters)
    {
      const double nu = parameters.poisson_ratio;
      return parameters.youngs_modulus / (1. - nu * nu) * std::pow(thickness, 3) / 12.;
    }

    /** omega = factor/L^2 sqrt(E I/(rho A)), L the half length [1/s]. */
    double
    frequency(const FreeSolidParameters<2> &parameters, const double factor)
    {
      return factor / (half_length * half_length) *
             std::sqrt(stiffness_of(parameters) / (parameters.density * thickness));
    }

    /** A cross section of one half of the beam. */
    struct Section
    {
      double start;     ///< from the middle
      Vector<2> place;  ///< from the middle, where that was
      double curvature; ///< by F
      double volume = 0.;
    };

    std::vector<Section>
    sections(const std::vector<FreeSolid<2>::Point> &points,
             const Vector<2> &middle,
             const int side)
    {
      std::map<long, std::vector<const FreeSolid<2>::Point *>> columns;
      for (const auto &point : points)
        if ((point.start[0] - middle[0]) * side > 0.)
          columns[std::lround(1e9 * side * (point.start[0] - middle[0]))].push_back(&point);
      std::vector<Section> result;
      for (const auto &column : columns)
        {
          Section section = {1e-9 * column.first, {}, 0., 0.};
          double moment = 0., inertia = 0., height = 0.;
          for (const auto *point : column.second)
            {
              section.volume += point->volume;
              section.place += point->volume * (point->position - middle);
              height += point->volume * (point->start[1] - middle[1]);
            }
          height /= section.volume;
          for (const auto *point : column.second)
            {
              const double y = point->start[1] - middle[1] - height;
              moment -= point->volume * y *
                        std::hypot(point->deformation(0, 0), point->deformation(1, 0));
              inertia += point->volume * y * y;
            }
          section.place *= 1. / section.volume;
          section.place[0] *= side;
          section.curvature = moment / inertia;
          result.push_back(section);
        }
      return result;
    }

    /** The end of a half beam from its middle, and its angle by shape and by F. */
    struct End
    {
      Vector<2> place;
      double angle_of_shape, angle_of_deformation;
    };

    End
    end_of(const std::vector<Section> &half, const int per_cell)
    {
      const std::size_t last = half.size() - 1;
      const Section &a = half[last - 1], &b = half[last];
      const double beyond = (half_length - b.start) / (b.start - a.start);
      End end;
      end.place = b.place + beyond * (b.place - a.place);
      // The middle: y = y_0 + k x^2 through the first four sections.
      double sx = 0., sy = 0., sxx = 0., sxy = 0.;
      for (int k = 0; k < 4; ++k)
        {
          const double x = half[k].start * half[k].start;
          sx += x;
          sy += half[k].place[1];
          sxx += x * x;
          sxy += x * half[k].place[1];
        }
      const double slope = (4. * sxy - sx * sy) / (4. * sxx - sx * sx);
      end.place[1] -= (sy - slope * sx) / 4.;
      const Section &inner     = half[last - 3 * per_cell];
      const Vector<2> way      = b.place - inner.place;
      end.angle_of_shape       = std::atan2(way[1], way[0]);
      end.angle_of_deformation = 0.;
      for (std::size_t i = 0; i <= last; ++i)
        {
          const double from = (i > 0 ? 0.5 * (half[i - 1].start + half[i].start) : 0.);
          const double to   = (i < last ? 0.5 * (half[i + 1].start + half[i].start) : half_length);
          end.angle_of_deformation += half[i].curvature * (to - from);
        }
      return end;
    }

    /** The first mode of a free beam of length 2, the ends at +-1, where it is 1. */
    struct BendingMode
    {
      static constexpr double wave_number = 4.73004 / 2.;
      double value, slope, curvature;

      explicit BendingMode(const double x)
      {
        const double sigma = (std::cosh(4.73004) - std::cos(4.73004)) /
                             (std::sinh(4.73004) - std::sin(4.73004));
        const double z = wave_number * (x + 1.);
        value          = 0.5 * (std::cosh(z) + std::cos(z) - sigma * (std::sinh(z) + std::sin(z)));
        slope          = 0.5 * wave_number *
                (std::sinh(z) - std::sin(z) - sigma * (std::cosh(z) + std::cos(z)));
        curvature = 0.5 * wave_number * wave_number *
                    (std::cosh(z) - std::cos(z) - sigma * (std::sinh(z) - std::sin(z)));
      }
    };
  } // namespace

  VBeamErrors
  v_beam_errors(const FreeBeam &beam,
                const double load,
                const double damping,
                const double periods,
                const double way)
  {
    FreeSolidParameters<2> parameters = parameters_of(beam);
    const double omega                = frequency(parameters, 3.516);
    const double end_time             = periods * 2. * pi / omega;
    parameters.damping_rate           = damping * omega;
    parameters.frame_velocity         = {{0., way * half_length / end_time}};
    const Vector<2> middle            = 0.5 * (parameters.lower_corner + parameters.upper_corner);
    const double couple = load * stiffness_of(parameters) / (half_length * half_length * thickness);

    FreeSolid<2> solid(parameters);
    solid.set_stress([&](const Vector<2> &start, const Matrix<2> &f) {
      const double side     = (start[0] > middle[0] ? 1. : -1.);
      const Vector<2> along = {{f(0, 0), f(1, 0)}};
      return (-side * couple) * outer(Vector<2>{{0., 1.}}, along);
    });
    while (solid.time() < end_time)
      solid.step();

    const Elastica exact = elastica(load, BeamLoad::couple);
    VBeamErrors errors   = {-1., -1., 0.};
    for (const int side : {-1, 1})
      {
        const End end = end_of(sections(solid.points(), middle, side), 2);
        errors.height += 0.5 * end.place[1] / half_length / exact.height;
        errors.reach += 0.5 * end.place[0] / half_length / exact.reach;
        errors.angle_of_ends += 0.5 * (end.angle_of_shape - end.angle_of_deformation) / exact.angle;
      }
    return errors;
  }

  EnergyLeft
  energy_of_swinging_beam(const FreeBeam &beam)
  {
    const FreeSolidParameters<2> parameters = parameters_of(beam);
    const double omega                      = frequency(parameters, 5.5933);
    const Vector<2> middle = 0.5 * (parameters.lower_corner + parameters.upper_corner);
    const double speed     = 0.3 * half_length * omega;
    FreeSolid<2> solid(parameters);
    solid.set_velocity(
      [&](const Vector<2> &x) {
        const BendingMode mode((x[0] - middle[0]) / half_length);
        return speed * Vector<2>{{-(x[1] - middle[1]) / half_length * mode.slope, mode.value}};
      },
      [&](const Vector<2> &x) {
        const BendingMode mode((x[0] - middle[0]) / half_length);
        const double rate = speed / half_length;
        return Matrix<2>{
          {{-rate * (x[1] - middle[1]) / half_length * mode.curvature, -rate * mode.slope},
           {rate * mode.slope, 0.}}};
      });
    const double start = solid.energy();
    EnergyLeft left    = {1., 1.};
    while (solid.time() < 4. * 2. * pi / omega)
      {
        solid.step();
        left.at_end  = solid.energy() / start;
        left.largest = std::max(left.largest, left.at_end);
      }
    return left;
  }

  double
  loss_of_bar(const Transfer transfer, const double elastic_factor)
  {
    FreeSolidParameters<2> parameters;
    parameters.spacing        = 1. / 16.;
    parameters.lower_corner   = {{1., 1.}};
    parameters.upper_corner   = {{2., 1.25}};
    parameters.transfer       = transfer;
    parameters.elastic_factor = elastic_factor;
    FreeSolid<2> solid(parameters);
    const double speed = 0.01 * solid.wave_speed();
    solid.set_velocity(
      [&](const Vector<2> &x) {
        return Vector<2>{{speed * std::cos(pi * (x[0] - 1.)), 0.}};
      },
      [&](const Vector<2> &x) {
        return Matrix<2>{{{-speed * pi * std::sin(pi * (x[0] - 1.)), 0.}, {0., 0.}}};
      });
    constexpr int n_periods = 10;
    const double start      = solid.energy();
    while (solid.time() < n_periods * 2. / solid.wave_speed())
      solid.step();
    return 1. - std::pow(solid.energy() / start, 1. / n_periods);
  }

  template <int dim>
  double
  change_of_angular_momentum(const Transfer transfer)
  {
    FreeSolidParameters<dim> parameters;
    parameters.spacing       = 1. / 8.;
    parameters.poisson_ratio = 0.3;
    parameters.transfer      = transfer;
    for (int d = 0; d < dim; ++d)
      {
        parameters.lower_corner[d] = 1. + 0.31 * d / 8.;
        parameters.upper_corner[d] = 2. + 0.31 * d / 8.;
      }
    FreeSolid<dim> solid(parameters);
    const double omega       = 0.1 * solid.wave_speed();
    const Vector<dim> centre = 0.5 * (parameters.lower_corner + parameters.upper_corner);
    Matrix<dim> gradient;
    gradient(0, 1) = -omega;
    gradient(1, 0) = omega;
    solid.set_velocity([&](const Vector<dim> &x) { return gradient * (x - centre); },
                       [&](const Vector<dim> &) { return gradient; });
    const auto start = solid.angular_momentum();
    while (solid.time() < 10. * 2. * pi / omega)
      solid.step();
    return norm(solid.angular_momentum() - start) / norm(start);
  }

  template double change_of_angular_momentum<2>(Transfer);
  template double change_of_angular_momentum<3>(Transfer);
} // namespace magmpm::verification
