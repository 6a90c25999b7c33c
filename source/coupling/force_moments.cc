#include <magmpm/coupling/force_moments.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/particle_state.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  Matrix<dim>
  ForceMoments<dim>::virial() const
  {
    return mass > 0. ? moment + outer((-1. / mass) * force, mass_times_position) : moment;
  }

  template <int dim>
  ForceMoments<dim>
  force_moments(const std::vector<Body<dim>> &bodies,
                const Lattice<dim> &lattice,
                const MPI_Comm communicator)
  {
    const double second_moment = 0.25 * lattice.spacing * lattice.spacing; // of a B-spline
    ForceMoments<dim> sum;
    for (const Body<dim> &body : bodies)
      {
        if (!body.magnetic.is_magnetic())
          continue;
        const auto particles = body.particles.arrays();
        for (std::size_t p = 0; p < body.particles.size(); ++p)
          {
            const double m      = particles.mass[p];
            const Vector<dim> x = body.particles.position(p);
            const Vector<dim> f = m * load_vector<dim>(particles.magnetic_acceleration, p);
            sum.mass += m;
            sum.mass_times_position += m * x;
            sum.force += f;
            sum.size += norm(f);
            sum.moment += outer(f, x);
            sum.moment += (second_moment * m) *
                          load_matrix<dim>(particles.magnetic_acceleration_gradient, p);
          }
      }
    return parallel::sum(sum, communicator);
  }

  template <int dim>
  double
  relative_difference(const ForceMoments<dim> &carried, const ForceMoments<dim> &exact)
  {
    const auto ratio = [](const double difference, const double size) {
      return size > 0. ? difference / size : 0.;
    };
    const Matrix<dim> virial = exact.virial();
    return std::max(
      ratio(norm(carried.force - exact.force), std::max(norm(exact.force), 0.1 * exact.size)),
      ratio(frobenius_norm(carried.virial() + (-1.) * virial), frobenius_norm(virial)));
  }

#define INSTANTIATE(dim)                                                   \
  template struct ForceMoments<dim>;                                       \
  template ForceMoments<dim> force_moments(                                \
    const std::vector<Body<dim>> &, const Lattice<dim> &, const MPI_Comm); \
  template double relative_difference(const ForceMoments<dim> &, const ForceMoments<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
