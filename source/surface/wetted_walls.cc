#include <magmpm/lattice/bspline.h>
#include <magmpm/surface/sharp_profile.h>
#include <magmpm/surface/wetted_walls.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** B-splines along an axis at a point of a block, given from its lower corner in dx. */
    struct AxisWeights
    {
      int first = 0; ///< node of the window, which begins at -1
      double value[stencil_width];
      double derivative[stencil_width];

      explicit AxisWeights(const double point = 0.5)
      {
        const int base = static_cast<int>(std::floor(point - 0.5));
        first          = base + 1;
        quadratic_bspline(point - base, value);
        quadratic_bspline_derivative(point - base, derivative);
      }
    };

    /** The 3^dim B-splines around a point on a wall. */
    template <int dim>
    class PointStencil
    {
    public:
      explicit PointStencil(const Vector<dim> &point)
      {
        for (int d = 0; d < dim; ++d)
          axes[d] = AxisWeights(point[d]);
      }

      /** Calls f(place in the window, N, grad N). */
      template <typename Function>
      void
      for_each(const Function &f) const
      {
        using Window = typename BlockQuadrature<dim>::Window;
        for (int i = 0; i < power(stencil_width, dim); ++i)
          {
            int place    = 0;
            double value = 1.;
            Vector<dim> gradient;
            for (int d = 0; d < dim; ++d)
              gradient[d] = 1.;
            for (int d = 0, rest = i; d < dim; ++d, rest /= stencil_width)
              {
                const int k = rest % stencil_width;
                place += (axes[d].first + k) * Window::stride(d);
                value *= axes[d].value[k];
                for (int e = 0; e < dim; ++e)
                  gradient[e] *= (e == d ? axes[d].derivative[k] : axes[d].value[k]);
              }
            f(place, value, gradient);
          }
      }

    private:
      std::array<AxisWeights, dim> axes;
    };

    /** f at a point, times the tension there over the largest one. */
    template <int dim>
    double
    wetted_tension(const typename SurfaceStress<dim>::Nodes &nodes,
                   const PointStencil<dim> &stencil)
    {
      double volume = 0., full = 0., tension = 0., content = 0.;
      stencil.for_each([&](const int i, const double value, const Vector<dim> &) {
        volume += value * nodes.volume[i];
        full += value * nodes.full[i];
        if (nodes.is_uniform)
          return;
        tension += value * nodes.tension[i];
        content += value * nodes.content[i];
      });
      const double fraction = sharp_fraction(volume, full);
      if (nodes.is_uniform)
        return fraction;
      return content > 0. ? fraction * tension / content : 0.;
    }

    /** Calls f(point [dx from the lower corner of the block], weight [dx^(dim-1)]) on one of its faces. */
    template <int dim, typename Function>
    void
    for_face_points(const int face, const Function &f)
    {
      static const BlockQuadrature<dim> rule;
      for (int q = 0; q < power(rule.points_1d, dim - 1); ++q)
        {
          Vector<dim> point;
          double weight = 1.;
          for (int d = 0, rest = q; d < dim; ++d)
            if (d == face / 2)
              point[d] = block_edge * (face % 2);
            else
              {
                point[d] = rule.coordinates()[rest % rule.points_1d];
                weight *= rule.weights_1d()[rest % rule.points_1d];
                rest /= rule.points_1d;
              }
          f(point, weight);
        }
    }
  } // namespace

  template <int dim>
  double
  add_wall_tension(const WettedWalls<dim> &walls,
                   const Index<dim> &block,
                   const typename SurfaceStress<dim>::Nodes &nodes,
                   std::array<typename SurfaceStress<dim>::NodeValues, dim> &force)
  {
    double energy = 0.;
    for (int face = 0; face < 2 * dim; ++face)
      if (walls.wets(face, block))
        for_face_points<dim>(face, [&](const Vector<dim> &point, const double weight) {
          const PointStencil<dim> stencil(point);
          const double tension = weight * walls.cosine[face] * wetted_tension<dim>(nodes, stencil);
          if (tension == 0.)
            return;
          energy -= tension;
          stencil.for_each([&](const int i, const double, const Vector<dim> &gradient) {
            for (int d = 0; d < dim; ++d)
              if (d != face / 2)
                force[d][i] += tension * gradient[d];
          });
        });
    return energy;
  }

#define INSTANTIATE(dim)                                                   \
  template double add_wall_tension<dim>(const WettedWalls<dim> &,          \
                                        const Index<dim> &,                \
                                        const SurfaceStress<dim>::Nodes &, \
                                        std::array<SurfaceStress<dim>::NodeValues, dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
