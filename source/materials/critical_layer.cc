#include <magmpm/base/constants.h>
#include <magmpm/materials/critical_layer.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** mu_0 M^2 less what tension and weight hold, at a field H > 0 [Pa]. */
    double
    excess(const FerrofluidProperties &fluid, const MagnetizationModel &model, const double field)
    {
      const auto response = magnetic_response<2>(model, fluid.content, Vector<2>{{field, 0.}});
      const double magnetization = response.magnetization[0];
      const double ratio = std::sqrt((1. + magnetization / field) * (1. + response.tangent(0, 0)));
      return constants::vacuum_permeability * magnetization * magnetization -
             2. * (1. + 1. / ratio) *
               std::sqrt(fluid.density * fluid.gravity * fluid.surface_tension);
    }
  } // namespace

  double
  capillary_length(const FerrofluidProperties &fluid)
  {
    return std::sqrt(fluid.surface_tension / (fluid.density * fluid.gravity));
  }

  std::optional<CriticalLayer>
  critical_layer(const FerrofluidProperties &fluid, const MagnetizationModel &model)
  {
    constexpr double largest_field = 1e9; // [A/m], where all is saturated
    double below = 0., above = 1.;
    while (above < largest_field && excess(fluid, model, above) < 0.)
      {
        below = above;
        above *= 2.;
      }
    if (above >= largest_field)
      return std::nullopt;
    constexpr int n_halvings = 60;
    for (int i = 0; i < n_halvings; ++i)
      {
        const double middle                                 = 0.5 * (below + above);
        (excess(fluid, model, middle) < 0. ? below : above) = middle;
      }
    const double magnetization =
      magnetic_response<2>(model, fluid.content, Vector<2>{{above, 0.}}).magnetization[0];
    return CriticalLayer{
      magnetization, above, constants::vacuum_permeability * (above + magnetization)};
  }
} // namespace magmpm
