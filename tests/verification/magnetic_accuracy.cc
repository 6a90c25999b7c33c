#include "catch.h"

#include <verification/magnetostatics/accuracy_limits.h>
#include <verification/magnetostatics/ellipsoid_errors.h>
#include <verification/magnetostatics/pair_errors.h>
#include <verification/magnetostatics/sphere_errors.h>

#include <cmath>
#include <functional>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /**
   * Checks the errors at R/dx = 8, rms over two places on the lattice, against the limits of the
   * benchmark.
   *
   * @return how many limits there were.
   */
  int
  check_limits(const int dim,
               const std::string &group,
               const std::function<Errors(const AccuracyCase &)> &measure)
  {
    AccuracyCase accuracy_case;
    const Errors first   = measure(accuracy_case);
    accuracy_case.offset = 1;
    const Errors second  = measure(accuracy_case);
    int n_limits         = 0;
    for (std::size_t m = 0; m < first.size(); ++m)
      {
        const auto limit = accuracy_limit(dim, group, "", accuracy_case.resolution, first[m].name);
        if (!limit)
          continue;
        ++n_limits;
        CAPTURE(dim, group, first[m].name);
        CHECK(std::hypot(first[m].value, second[m].value) / std::sqrt(2.) <= *limit);
      }
    return n_limits;
  }
} // namespace

// Moment, inner field, surface traction (deviator of the virial), force near a dipole and net force
// of a sphere of radius 8 dx, chi_0 = 0.91. Their exact values are known; the limits are those
// of the benchmark magnetic_accuracy.
TEMPLATE_TEST_CASE_SIG("A magnetized sphere is as accurate as promised",
                       "[verification][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  CHECK(check_limits(dim, "sphere", sphere_errors<dim>) == 5);
}

// Two spheres a gap of R/2 apart: the sum of their forces is zero, and each is the exact one,
// known from multipoles of all degrees.
TEMPLATE_TEST_CASE_SIG("Forces between two bodies are as accurate as promised",
                       "[verification][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  CHECK(check_limits(dim, "pair", pair_errors<dim>) == (dim == 3 ? 2 : 1));
}

// The torque on a spheroid at 45 degrees to the field is mu_0 V M x H_0. A transposed stress would
// give none of it, or its opposite.
TEST_CASE("The torque on a spheroid is as accurate as promised", "[verification][mpi]")
{
  CHECK(check_limits(3, "torque", torque_errors<3>) == 1);
}
