#include <magmpm/base/number_text.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/simulation/seeding_report.h>

namespace magmpm
{
  namespace
  {
    /** Undeformed volume of all ranks' particles and its moments. */
    template <int dim>
    VolumeMoments<dim>
    moments_of_particles(const ParticleSet<dim> &particles, const MPI_Comm communicator)
    {
      const double *volumes = particles.component(ParticleProperty::volume, 0);
      const auto add_up     = [&](const Vector<dim> &origin) {
        RegionMoments<dim> sum;
        for (std::size_t p = 0; p < particles.size(); ++p)
          {
            const Vector<dim> r = particles.position(p) - origin;
            sum += {volumes[p], volumes[p] * r, volumes[p] * outer(r, r)};
          }
        parallel::Reduction reduction;
        reduction.sum(sum.volume);
        reduction.sum(sum.first);
        reduction.sum(sum.second);
        reduction.carry_out(communicator);
        return sum;
      };
      // Twice, so that little cancels far from the origin.
      const Vector<dim> about = about_centroid(add_up({}), Vector<dim>()).centroid;
      return about_centroid(add_up(about), about);
    }

    /** About the axes; in 2D about the one across the plane. */
    template <int dim>
    Vector<n_axial_components<dim>>
    moments_of_inertia(const VolumeMoments<dim> &moments, const double density)
    {
      if constexpr (dim == 2)
        return {{density * trace(moments.second)}};
      else
        {
          Vector<3> inertia;
          for (int d = 0; d < 3; ++d)
            inertia[d] = density * (trace(moments.second) - moments.second(d, d));
          return inertia;
        }
    }

    template <int dim>
    std::string
    line_on(const std::string &what, const VolumeMoments<dim> &moments, const double density)
    {
      const std::string mass = (dim == 2 ? " kg/m" : " kg");
      return what + ": volume " + to_text(moments.volume) + (dim == 2 ? " m^2" : " m^3") +
             ", mass " + to_text(density * moments.volume) + mass + ", centroid " +
             components(moments.centroid) + " m, inertia " +
             components(moments_of_inertia(moments, density)) + (dim == 2 ? " kg m" : " kg m^2");
    }
  } // namespace

  template <int dim>
  std::string
  seeding_report(const BodyParameters<dim> &parameters,
                 const ParticleSet<dim> &particles,
                 const MPI_Comm communicator)
  {
    const VolumeMoments<dim> seeded = moments_of_particles(particles, communicator);
    const std::string report =
      line_on<dim>(parameters.name + " as seeded", seeded, parameters.density);
    if (parameters.shape.type == ShapeType::points)
      return report;
    const std::string indent(parameters.name.size() + 2, ' ');
    return report + "\n" + indent +
           line_on<dim>(
             "of its shape", make_shape(parameters.shape)->volume_moments(), parameters.density);
  }

#define INSTANTIATE(dim)               \
  template std::string seeding_report( \
    const BodyParameters<dim> &, const ParticleSet<dim> &, MPI_Comm);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
