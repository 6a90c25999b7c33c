#include <magmpm/base/constants.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/magnets/cuboid.h>
#include <magmpm/magnets/gauss_points.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    using constants::pi;

    template <int dim>
    double
    longest(const Vector<dim> &size)
    {
      return *std::max_element(size.values, size.values + dim);
    }

    template <int dim>
    double
    shortest(const Vector<dim> &size)
    {
      return *std::min_element(size.values, size.values + dim);
    }

    /** From the faces at -h and h of an axis, and whether a corner counts with + (0) or - (1). */
    struct FaceDistances
    {
      double from[2];

      double
      operator[](const int i) const
      {
        return from[i];
      }
    };

    /** The same, off a face by at least the tolerance, on the outer side. */
    FaceDistances
    off_faces(FaceDistances u, const double tolerance)
    {
      if (std::abs(u[0]) < tolerance)
        u.from[0] = -tolerance;
      if (std::abs(u[1]) < tolerance)
        u.from[1] = tolerance;
      return u;
    }

    double
    sign(const int i)
    {
      return i % 2 == 0 ? 1. : -1.;
    }

    /**
     * The ratio (v0 + R0)/(v1 + R1) for the ends of an edge at the distance sqrt(rho2); its logarithm
     * is the integral of 1/R along the edge. Written without differences of what may be equal.
     */
    double
    edge_ratio(const FaceDistances &v, const double R0, const double R1, const double rho2)
    {
      if (v[1] > 0.)
        return (v[0] + R0) / (v[1] + R1);
      if (v[0] < 0.)
        return (R1 - v[1]) / (R0 - v[0]);
      return (v[0] + R0) * (R1 - v[1]) / rho2;
    }

    /**
     * The solid angle of the rectangle with the corners (u_i, v_j) seen from the height w, with its sign.
     * The tangents of the four angles at the corners are added as complex numbers w R + i u v, each
     * divided by its size.
     */
    double
    solid_angle(const FaceDistances &u,
                const FaceDistances &v,
                const double w,
                const double (&R)[2][2],
                const double near)
    {
      double real = 1., imaginary = 0.;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          {
            const double scale = 1. / (R[i][j] * R[i][j]);
            const double x     = std::abs(w) * R[i][j] * scale;
            const double y     = sign(i + j) * u[i] * v[j] * scale;
            const double old   = real;
            real               = old * x - imaginary * y;
            imaginary          = old * y + imaginary * x;
          }
      double angle = std::atan2(imaginary, real);
      // Half a space and more is seen from close above the rectangle only.
      if (angle < 0. && u[0] > 0. && u[1] < 0. && v[0] > 0. && v[1] < 0. && std::abs(w) < near)
        angle += 2. * pi;
      return w < 0. ? -angle : angle;
    }

    struct Corners
    {
      FaceDistances u[3];
      double R[2][2][2];

      Corners(const Vector<3> &point, const Vector<3> &half_size, const double least_R2)
      {
        for (int d = 0; d < 3; ++d)
          u[d] = {{point[d] + half_size[d], point[d] - half_size[d]}};
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            for (int k = 0; k < 2; ++k)
              R[i][j][k] = std::sqrt(
                std::max(u[0][i] * u[0][i] + u[1][j] * u[1][j] + u[2][k] * u[2][k], least_R2));
      }

      /** R of the corner with the side i of axis d, j of the next one, k of the one after it. */
      double
      distance(const int d, const int i, const int j, const int k) const
      {
        return d == 0 ? R[i][j][k] : d == 1 ? R[k][i][j] : R[j][k][i];
      }
    };

    Vector<3>
    cuboid_field(const Vector<3> &half_size,
                 const double tolerance,
                 const double least_rho2,
                 const Vector<3> &m,
                 const Vector<3> &point)
    {
      const Corners corners(point, half_size, least_rho2);
      const double near = half_size[0] + half_size[1] + half_size[2];
      Vector<3> field;
      for (int d = 0; d < 3; ++d)
        {
          const int e = (d + 1) % 3, f = (d + 2) % 3;
          const FaceDistances &v = corners.u[e], &w = corners.u[f];

          // The faces across axis d: the one at the upper end has the charge M_d.
          const FaceDistances off = off_faces(corners.u[d], tolerance);
          double angles           = 0.;
          for (int i = 0; i < 2; ++i)
            {
              double R[2][2];
              for (int j = 0; j < 2; ++j)
                for (int k = 0; k < 2; ++k)
                  R[j][k] = corners.distance(d, i, j, k);
              angles -= sign(i) * solid_angle(v, w, off[i], R, near);
            }
          field[d] += m[d] / (4. * pi) * angles;

          // The edges along axis d: they make H_e from M_f and H_f from M_e.
          double ratio[2] = {1., 1.};
          for (int j = 0; j < 2; ++j)
            for (int k = 0; k < 2; ++k)
              ratio[(j + k) % 2] *= edge_ratio(corners.u[d],
                                               corners.distance(d, 0, j, k),
                                               corners.distance(d, 1, j, k),
                                               std::max(v[j] * v[j] + w[k] * w[k], least_rho2));
          const double logarithm = std::log(ratio[0] / ratio[1]) / (4. * pi);
          field[e] += logarithm * m[f];
          field[f] += logarithm * m[e];
        }
      return field;
    }

    Matrix<3>
    cuboid_gradient(const Vector<3> &half_size,
                    const double least_rho2,
                    const Vector<3> &m,
                    const Vector<3> &point)
    {
      const Corners corners(point, half_size, least_rho2);
      // The derivatives T_ijk = dN_ij/dx_k do not change with the order of their indices.
      double different   = 0.; // T_012
      double twice[3][3] = {}; // [i][j]: T_iij
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          for (int k = 0; k < 2; ++k)
            {
              const double u[3] = {corners.u[0][i], corners.u[1][j], corners.u[2][k]};
              const double s    = sign(i + j + k) / corners.R[i][j][k];
              different -= s;
              for (int d = 0; d < 3; ++d)
                {
                  const int e = (d + 1) % 3, f = (d + 2) % 3;
                  // From the edge along d.
                  const double edge = s * u[d] / std::max(u[e] * u[e] + u[f] * u[f], least_rho2);
                  twice[e][f] += edge * u[e];
                  twice[f][e] += edge * u[f];
                }
            }
      Matrix<3> gradient;
      for (int d = 0; d < 3; ++d)
        {
          const int e = (d + 1) % 3, f = (d + 2) % 3;
          const double thrice = -twice[e][d] - twice[f][d]; // T_ddd, since traces do not change
          gradient(d, d)      = -(thrice * m[d] + twice[d][e] * m[e] + twice[d][f] * m[f]);
          gradient(d, e)      = -(twice[d][e] * m[d] + twice[e][d] * m[e] + different * m[f]);
          gradient(e, d)      = gradient(d, e);
        }
      return (1. / (4. * pi)) * gradient;
    }

    Vector<2>
    rectangle_field(const Vector<2> &half_size,
                    const double tolerance,
                    const double least_rho2,
                    const Vector<2> &m,
                    const Vector<2> &point)
    {
      FaceDistances u[2];
      for (int d = 0; d < 2; ++d)
        u[d] = {{point[d] + half_size[d], point[d] - half_size[d]}};
      Vector<2> field;
      for (int d = 0; d < 2; ++d)
        {
          const FaceDistances &v  = u[1 - d];
          const FaceDistances off = off_faces(u[d], tolerance);
          double angles           = 0.;
          for (int i = 0; i < 2; ++i)
            angles -= sign(i) *
                      std::atan2(2. * half_size[1 - d] * off[i], off[i] * off[i] + v[0] * v[1]);
          field[d] += m[d] / (2. * pi) * angles;
        }
      double rho2[2][2];
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          rho2[i][j] = std::max(u[0][i] * u[0][i] + u[1][j] * u[1][j], least_rho2);
      const double logarithm = std::log(rho2[0][1] * rho2[1][0] / (rho2[0][0] * rho2[1][1])) /
                               (4. * pi);
      field[0] += logarithm * m[1];
      field[1] += logarithm * m[0];
      return field;
    }

    Matrix<2>
    rectangle_gradient(const Vector<2> &half_size,
                       const double least_rho2,
                       const Vector<2> &m,
                       const Vector<2> &point)
    {
      double xxx = 0., xxy = 0.; // derivatives of N
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          {
            const double u = point[0] + sign(i) * half_size[0];
            const double v = point[1] + sign(j) * half_size[1];
            const double s = sign(i + j) / (2. * pi * std::max(u * u + v * v, least_rho2));
            xxx -= s * v;
            xxy += s * u;
          }
      Matrix<2> gradient;
      gradient(0, 0) = -(xxx * m[0] + xxy * m[1]);
      gradient(0, 1) = gradient(1, 0) = -(xxy * m[0] - xxx * m[1]);
      gradient(1, 1)                  = -gradient(0, 0);
      return gradient;
    }
  } // namespace

  template <int dim>
  Cuboid<dim>::Cuboid(const Vector<dim> &size)
    : half_size(0.5 * size)
    , surface_tolerance(1e-9 * longest(size))
    , least_edge_distance2(1e-8 * std::pow(shortest(size), 2))
  {
    const std::vector<GaussPoint> line = gauss_points();
    for (const GaussPoint &x : line)
      for (const GaussPoint &y : line)
        if constexpr (dim == 2)
          elements.push_back(
            {{{x.position * size[0] - half_size[0], y.position * size[1] - half_size[1]}},
             x.weight * y.weight * size[0] * size[1]});
        else
          for (const GaussPoint &z : line)
            elements.push_back({{{x.position * size[0] - half_size[0],
                                  y.position * size[1] - half_size[1],
                                  z.position * size[2] - half_size[2]}},
                                x.weight * y.weight * z.weight * size[0] * size[1] * size[2]});
  }

  template <int dim>
  Vector<dim>
  Cuboid<dim>::field(const Vector<dim> &magnetization, const Vector<dim> &point) const
  {
    if constexpr (dim == 3)
      return cuboid_field(half_size, surface_tolerance, least_edge_distance2, magnetization, point);
    else
      return rectangle_field(
        half_size, surface_tolerance, least_edge_distance2, magnetization, point);
  }

  template <int dim>
  Matrix<dim>
  Cuboid<dim>::field_gradient(const Vector<dim> &magnetization, const Vector<dim> &point) const
  {
    if constexpr (dim == 3)
      return cuboid_gradient(half_size, least_edge_distance2, magnetization, point);
    else
      return rectangle_gradient(half_size, least_edge_distance2, magnetization, point);
  }

  template <int dim>
  bool
  Cuboid<dim>::is_inside(const Vector<dim> &point) const
  {
    bool inside = true;
    for (int d = 0; d < dim; ++d)
      inside = inside && std::abs(point[d]) <= half_size[d] - surface_tolerance;
    return inside;
  }

  template <int dim>
  Vector<dim>
  Cuboid<dim>::strength(const Vector<dim> &magnetization) const
  {
    return magnetization;
  }

  template <int dim>
  bool
  Cuboid<dim>::is_axisymmetric(const Vector<dim> & /*magnetization*/) const
  {
    return false;
  }

  template <int dim>
  double
  Cuboid<dim>::reach() const
  {
    return norm(half_size);
  }

  template <int dim>
  std::optional<ForceAndTorque<dim>>
  Cuboid<dim>::force_and_torque(const Vector<dim> &magnetization,
                                const ActingField<dim> &acting) const
  {
    return act_on(elements, magnetization, acting);
  }

  template <int dim>
  SourceParts<dim>
  make_parts(const CuboidParameters<dim> &parameters, const std::string &name)
  {
    for (int d = 0; d < dim; ++d)
      check_positive(parameters.size[d], "size of the cuboid", name);
    SourceParts<dim> parts;
    parts.field     = std::make_unique<Cuboid<dim>>(parameters.size);
    parts.amplitude = parameters.magnetization;
    parts.shape = std::make_unique<BoxShape<dim>>(-0.5 * parameters.size, 0.5 * parameters.size);
    return parts;
  }

  template class Cuboid<2>;
  template class Cuboid<3>;
  template SourceParts<2>
  make_parts(const CuboidParameters<2> &, const std::string &);
  template SourceParts<3>
  make_parts(const CuboidParameters<3> &, const std::string &);
} // namespace magmpm
