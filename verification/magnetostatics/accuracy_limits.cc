#include <verification/magnetostatics/accuracy_limits.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double any = 0.; ///< resolution

    struct Limit
    {
      int dim;
      const char *group;
      const char *variant;
      double resolution;
      const char *measure;
      double value;
    };

    constexpr Limit limits[] = {
      {3, "sphere", "", 8., "dipole moment", 6e-3},
      {3, "sphere", "", 16., "dipole moment", 3.5e-3},
      {3, "sphere", "", 8., "rms H inside 0.7 R", 5e-3},
      {3, "sphere", "", 16., "rms H inside 0.7 R", 2.5e-3},
      {3, "sphere", "", 8., "virial deviator", 1.2e-2},
      {3, "sphere", "", 16., "virial deviator", 6e-3},
      {3, "sphere", "", 8., "virial deviator, particles", 1e-2},
      {3, "sphere", "", 16., "virial deviator, particles", 6e-3},
      {3, "sphere", "", 8., "dipole force", 2e-2},
      {3, "sphere", "", 16., "dipole force", 6e-3},
      {3, "sphere", "", 8., "net force", 2e-4},
      {3, "sphere", "", 16., "net force", 6e-5},
      {3, "torque", "", 8., "torque", 2e-2},
      {3, "torque", "", 16., "torque", 1e-2},
      {3, "pair", "", 8., "third law", 2e-3},
      {3, "pair", "", 16., "third law", 1e-3},
      {3, "pair", "", 8., "pair force", 4e-2},
      {3, "pair", "", 16., "pair force", 1e-2},
      {3, "box", "", any, "dipole moment, box", 5e-4},
      {3, "box", "", any, "dipole force, box", 5e-4},
      {3, "langevin", "a = 3", 8., "dipole moment", 2e-3},
      {3, "langevin", "a = 30", 8., "dipole moment", 2e-3},
      {3, "permeable", "chi_0 = 1", 8., "dipole moment", 2e-3},
      {3, "permeable", "chi_0 = 1", 16., "dipole moment", 1.5e-3},
      {3, "permeable", "chi_0 = 1", 8., "virial deviator", 6e-3},
      {3, "permeable", "chi_0 = 10", 4., "dipole moment", 8e-3},
      {3, "permeable", "chi_0 = 10", 8., "dipole moment", 4e-3},
      {3, "permeable", "chi_0 = 10", 16., "dipole moment", 3e-3},
      {3, "permeable", "chi_0 = 10", 8., "virial deviator", 8e-3},
      {3, "permeable", "chi_0 = 10", 8., "dipole force", 1.5e-2},
      {3, "permeable", "chi_0 = 100", 8., "dipole moment", 2.5e-2},
      {3, "permeable", "chi_0 = 100", 16., "dipole moment", 1.3e-2},
      {3, "permeable", "chi_0 = 10, cells dx", 8., "dipole moment", 5e-3},
      {3, "permeable", "chi_0 = 10, cells dx", 8., "dipole force", 2.5e-2},
      {3, "gap", "chi_0 = 1", 8., "pair force", 2.5e-2},
      {3, "gap", "chi_0 = 1", 16., "pair force", 1e-2},
      {3, "gap", "chi_0 = 10", 8., "pair force", 6e-2},
      {3, "gap", "chi_0 = 10", 16., "pair force", 2e-2},
      {3, "block", "plate 32 x 32 x 4, chi_0 = 1", any, "moment", 1e-2},
      {3, "block", "plate 32 x 32 x 4, chi_0 = 10", any, "moment", 2e-2},
      {3, "block", "plate 32 x 32 x 2, chi_0 = 1", any, "moment", 1.5e-2},
      {3, "block", "plate 32 x 32 x 2, chi_0 = 10", any, "moment", 4e-2},
      {3, "block", "sheet 16 x 16 x 1, chi_0 = 1", any, "moment", 8e-2},
      {3, "block", "disc 24 x 6, chi_0 = 1", any, "moment", 1e-2},
      {3, "block", "disc 24 x 6, chi_0 = 10", any, "moment", 2.5e-2},
      {3, "block", "cube 8, chi_0 = 1", any, "moment", 9e-3},
      {3, "block", "cube 8, chi_0 = 10", any, "moment", 4e-2},
      {3, "block", "cube 16, chi_0 = 1", any, "moment", 5e-3},
      {3, "block", "cube 16, chi_0 = 10", any, "moment", 1.8e-2},
      {3, "drops", "particle", any, "moment along H_0", 0.12},
      {3, "drops", "", any, "moment along H_0", 0.12},
      {3, "translation", "", 8., "force noise", 4e-3},
      {3, "translation", "", 8., "work", 1e-2},
      {3, "magnet", "", 8., "force", 3e-2},
      {3, "magnet", "", 8., "force in contact", 3e-2},
      {2, "sphere", "", 8., "dipole moment", 9e-3},
      {2, "sphere", "", 16., "dipole moment", 6e-3},
      {2, "sphere", "", 8., "rms H inside 0.7 R", 1.2e-2},
      {2, "sphere", "", 16., "rms H inside 0.7 R", 7e-3},
      {2, "sphere", "", 8., "virial deviator", 1.4e-2},
      {2, "sphere", "", 16., "virial deviator", 6e-3},
      {2, "sphere", "", 8., "virial deviator, particles", 1e-2},
      {2, "sphere", "", 16., "virial deviator, particles", 6e-3},
      {2, "sphere", "", 8., "dipole force", 4e-2},
      {2, "sphere", "", 16., "dipole force", 1.5e-2},
      {2, "sphere", "", 8., "net force", 1e-3},
      {2, "sphere", "", 16., "net force", 3e-4},
      {2, "pair", "", 8., "third law", 3e-3},
      {2, "pair", "", 16., "third law", 1e-3},
      {2, "box", "", any, "dipole moment, box", 5e-4},
      {2, "box", "", any, "dipole force, box", 5e-4},
      {2, "drops", "particle", any, "moment along H_0", 0.12},
      {2, "drops", "", any, "moment along H_0", 0.12},
      {2, "translation", "", 8., "force noise", 4e-3},
      {2, "translation", "", 8., "work", 1e-2},
      {2, "magnet", "", 8., "force", 3e-2},
    };
  } // namespace

  std::optional<double>
  accuracy_limit(const int dim,
                 const std::string &group,
                 const std::string &variant,
                 const double resolution,
                 const std::string &measure)
  {
    for (const Limit &limit : limits)
      if (limit.dim == dim && limit.group == group && limit.variant == variant &&
          (limit.resolution == any || std::abs(limit.resolution - resolution) < 1e-9) &&
          limit.measure == measure)
        return limit.value;
    return {};
  }
} // namespace magmpm::verification
