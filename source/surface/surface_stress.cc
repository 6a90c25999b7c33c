// Kernels, as lattice/block_quadrature.cc.

#include <magmpm/surface/sharp_profile.h>
#include <magmpm/surface/surface_stress.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  template <int dim>
  void
  SurfaceStress<dim>::weigh_by_tension(const Nodes &nodes,
                                       const int plane,
                                       PlaneValues &slopes) const
  {
    PlaneValues tension, content;
    rule.interpolate(nodes.tension, plane, tension);
    rule.interpolate(nodes.content, plane, content);
    for (int q = 0; q < rule.plane; ++q)
      slopes[q] *= content[q] > 0. ? tension[q] / content[q] : 0.;
  }

  template <int dim>
  void
  SurfaceStress<dim>::cut_at_bodies(const Nodes &nodes, const int plane, PlaneValues &slopes) const
  {
    constexpr double width = 0.3; // of the cut, in the share: half a dx
    PlaneValues share;
    rule.interpolate(nodes.rigid, plane, share);
    for (int q = 0; q < rule.plane; ++q)
      slopes[q] *= std::min(std::max(0.5 + (0.5 - share[q]) / width, 0.), 1.);
  }

  template <int dim>
  bool
  SurfaceStress<dim>::find_slopes(const Nodes &nodes, const int plane, PlaneValues &slopes) const
  {
    PlaneValues volume, full;
    rule.interpolate(nodes.volume, plane, volume);
    rule.interpolate(nodes.full, plane, full);
    double sum = 0.;
    for (int q = 0; q < rule.plane; ++q)
      {
        slopes[q] = sharp_slope(volume[q], full[q]);
        sum += slopes[q];
      }
    if (!(sum > 0.))
      return false;
    const auto &weights = rule.weights_1d();
    for (int y = 0; y < rule.points_1d; ++y)
      for (int x = 0; x < rule.points_1d; ++x)
        slopes[y * rule.points_1d + x] *= weights[x] * weights[y] *
                                          (dim == 3 ? weights[plane] : 1.);
    if (!nodes.is_uniform)
      weigh_by_tension(nodes, plane, slopes);
    if (nodes.has_bodies)
      cut_at_bodies(nodes, plane, slopes);
    return true;
  }

  template <int dim>
  double
  SurfaceStress<dim>::add_force(const Nodes &nodes, std::array<NodeValues, dim> &force) const
  {
    constexpr double smallest = 1e-100; // of |grad v|^2: no 0/0 where all is level
    double area               = 0.;
    PlaneValues slopes, volume, inverse;
    typename BlockQuadrature<dim>::PlaneGradients gradients, flux;
    for (int plane = 0; plane < rule.n_planes; ++plane)
      {
        if (!find_slopes(nodes, plane, slopes))
          continue;
        rule.interpolate(nodes.volume, plane, volume, gradients);
        for (int q = 0; q < rule.plane; ++q)
          {
            double square = smallest;
            for (int d = 0; d < dim; ++d)
              square += gradients[d][q] * gradients[d][q];
            const double length = std::sqrt(square);
            inverse[q]          = slopes[q] / length;
            slopes[q] *= length;
            area += slopes[q];
          }
        for (int a = 0; a < dim; ++a)
          {
            for (int b = 0; b < dim; ++b)
              for (int q = 0; q < rule.plane; ++q)
                flux[b][q] = inverse[q] * gradients[a][q] * gradients[b][q] -
                             (a == b ? slopes[q] : 0.);
            rule.add_tested_by_gradient(flux, plane, force[a]);
          }
      }
    return area;
  }

  template class SurfaceStress<2>;
  template class SurfaceStress<3>;
} // namespace magmpm
