#include <deal.II/base/symmetric_tensor.h>

#include <magmpm/boundary/mass_properties.h>

namespace magmpm
{
  template <>
  MassProperties<2>
  mass_properties(const VolumeMoments<2> &volume, const double mass)
  {
    return {mass, {{mass / volume.volume * trace(volume.second)}}, identity<2>()};
  }

  template <>
  MassProperties<3>
  mass_properties(const VolumeMoments<3> &volume, const double mass)
  {
    dealii::SymmetricTensor<2, 3> second;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        second[i][j] = volume.second(i, j);
    const auto eigenpairs = dealii::eigenvectors(second);

    MassProperties<3> result;
    result.mass = mass;
    for (int k = 0; k < 3; ++k)
      {
        // Around an axis turns what lies across it.
        result.moments[k] = mass / volume.volume *
                            (eigenpairs[(k + 1) % 3].first + eigenpairs[(k + 2) % 3].first);
        for (int i = 0; i < 3; ++i)
          result.axes(i, k) = eigenpairs[k].second[i];
      }
    if (determinant(result.axes) < 0.)
      for (int i = 0; i < 3; ++i)
        result.axes(i, 2) *= -1.;
    return result;
  }
} // namespace magmpm
