#include <magmpm/surface/sharp_profile.h>
#include <magmpm/surface/wetted_bodies.h>

#include <cmath>

namespace magmpm
{
  template <int dim>
  void
  WettedBodies<dim>::find_strength(const Nodes &nodes,
                                   const NodeValues &wetting,
                                   const int plane,
                                   const PlaneValues &share,
                                   PlaneValues &strength) const
  {
    constexpr double least = 1e-6; // of s: there is no |grad s| to speak of
    const auto &weights    = rule.weights_1d();
    PlaneValues wetted, volume, full, tension, content;
    rule.interpolate(wetting, plane, wetted);
    rule.interpolate(nodes.volume, plane, volume);
    rule.interpolate(nodes.full, plane, full);
    if (!nodes.is_uniform)
      {
        rule.interpolate(nodes.tension, plane, tension);
        rule.interpolate(nodes.content, plane, content);
      }
    for (int q = 0; q < rule.plane; ++q)
      {
        strength[q] = 0.;
        if (!(share[q] > least))
          continue;
        strength[q] = wetted[q] / share[q] * sharp_fraction(volume[q], full[q]) *
                      weights[q % rule.points_1d] * weights[q / rule.points_1d] *
                      (dim == 3 ? weights[plane] : 1.);
        if (!nodes.is_uniform)
          strength[q] *= content[q] > 0. ? tension[q] / content[q] : 0.;
      }
  }

  template <int dim>
  double
  WettedBodies<dim>::add_force(const Nodes &nodes,
                               const NodeValues &wetting,
                               std::array<NodeValues, dim> &force) const
  {
    PlaneValues share, strength;
    typename BlockQuadrature<dim>::PlaneGradients gradients, flux;
    double energy = 0.;
    for (int plane = 0; plane < rule.n_planes; ++plane)
      {
        rule.interpolate(nodes.rigid, plane, share, gradients);
        find_strength(nodes, wetting, plane, share, strength);
        for (int q = 0; q < rule.plane; ++q)
          {
            double square = 1e-100;
            for (int d = 0; d < dim; ++d)
              square += gradients[d][q] * gradients[d][q];
            const double length = std::sqrt(square);
            energy -= strength[q] * length;
            for (int d = 0; d < dim; ++d)
              gradients[d][q] /= length;
            strength[q] *= length;
          }
        for (int a = 0; a < dim; ++a)
          {
            for (int b = 0; b < dim; ++b)
              for (int q = 0; q < rule.plane; ++q)
                flux[b][q] = strength[q] * ((a == b ? 1. : 0.) - gradients[a][q] * gradients[b][q]);
            rule.add_tested_by_gradient(flux, plane, force[a]);
          }
      }
    return energy;
  }

  template class WettedBodies<2>;
  template class WettedBodies<3>;
} // namespace magmpm
