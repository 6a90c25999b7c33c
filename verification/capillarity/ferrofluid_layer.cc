#include <magmpm/base/constants.h>

#include <verification/capillarity/ferrofluid_layer.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double mu0 = constants::vacuum_permeability;

    /** The field in which @p quantity, which rises with the field, has a value; by bisection. */
    template <typename Quantity>
    LayerField
    field_where(const FerrofluidLayer &layer, const double value, const Quantity &quantity)
    {
      double below = 0., above = 1.;
      while (quantity(layer_field(layer, above)) < value)
        above *= 2.;
      for (int i = 0; i < 100; ++i)
        {
          const double middle                                            = 0.5 * (below + above);
          (quantity(layer_field(layer, middle)) < value ? below : above) = middle;
        }
      return layer_field(layer, 0.5 * (below + above));
    }
  } // namespace

  double
  FerrofluidLayer::capillary_wave_number() const
  {
    return std::sqrt(density * gravity / surface_tension);
  }

  double
  LayerField::induction() const
  {
    return mu0 * (field + magnetization);
  }

  LayerField
  layer_field(const FerrofluidLayer &layer, const double field)
  {
    const Vector<2> along = {{field, 0.}};
    const auto response   = magnetic_response(layer.law, layer.medium, along);
    return {field, response.magnetization[0], response.tangent(0, 0)};
  }

  LayerField
  field_of_magnetization(const FerrofluidLayer &layer, const double magnetization)
  {
    return field_where(layer, magnetization, [](const LayerField &state) {
      return state.magnetization;
    });
  }

  LayerField
  field_of_induction(const FerrofluidLayer &layer, const double induction)
  {
    return field_where(layer, induction, [](const LayerField &state) { return state.induction(); });
  }
} // namespace magmpm::verification
