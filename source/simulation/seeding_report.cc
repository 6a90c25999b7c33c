#include <magmpm/base/number_text.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/undeformed_moments.h>
#include <magmpm/simulation/seeding_report.h>

#include <algorithm>
#include <variant>

namespace magmpm
{
  namespace
  {
    /** Undeformed volume of all ranks' particles and its moments. */
    template <int dim>
    VolumeMoments<dim>
    moments_of_particles(const ParticleSet<dim> &particles, const MPI_Comm communicator)
    {
      const auto add_up = [&](const Vector<dim> &origin) {
        RegionMoments<dim> sum = undeformed_moments(particles, origin);
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

    /** What all ranks' particles of a body fill: the sum of J V_0. */
    template <int dim>
    double
    filled_volume(const Body<dim> &body, const MPI_Comm communicator)
    {
      const ParticleSet<dim> &particles = body.particles;
      const bool stores_ratio = std::holds_alternative<ViscoelasticFluid<dim>>(body.material);
      double volume           = 0.;
      for (std::size_t p = 0; p < particles.size(); ++p)
        volume += particles.component(ParticleProperty::volume, 0)[p] *
                  (stores_ratio ? particles.component(ParticleProperty::deformation, 0)[p] : 1.);
      return parallel::sum(volume, communicator);
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

    using Row = std::vector<std::string>;

    /** @param filled  volume that is filled. @param moments  of the undeformed one. */
    template <int dim>
    Row
    row_of(const std::string &name,
           const double filled,
           const VolumeMoments<dim> &moments,
           const double density)
    {
      return {name,
              to_text(filled),
              to_text(density * moments.volume),
              components(moments.centroid),
              components(moments_of_inertia(moments, density))};
    }

    /** Rows below each other, their columns at the same places. */
    std::string
    aligned(const std::vector<Row> &rows)
    {
      std::vector<std::size_t> widths(rows[0].size(), 0);
      for (const Row &row : rows)
        for (std::size_t c = 0; c < row.size(); ++c)
          widths[c] = std::max(widths[c], row[c].size());
      std::string text;
      for (const Row &row : rows)
        {
          text += text.empty() ? "" : "\n  ";
          for (std::size_t c = 0; c < row.size(); ++c)
            text += row[c] +
                    (c + 1 < row.size() ? std::string(widths[c] + 2 - row[c].size(), ' ') : "");
        }
      return text;
    }
  } // namespace

  template <int dim>
  std::string
  seeding_report(const std::vector<BodyParameters<dim>> &parameters,
                 const std::vector<Body<dim>> &bodies,
                 const MPI_Comm communicator)
  {
    std::vector<Row> rows = {{"body",
                              dim == 2 ? "volume [m^2]" : "volume [m^3]",
                              dim == 2 ? "mass [kg/m]" : "mass [kg]",
                              "centroid [m]",
                              dim == 2 ? "inertia [kg m]" : "inertia [kg m^2]"}};
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        const BodyParameters<dim> &body = parameters[b];
        rows.push_back(row_of(body.name + ", seeded",
                              filled_volume(bodies[b], communicator),
                              moments_of_particles(bodies[b].particles, communicator),
                              body.density));
        if (body.shape.type == ShapeType::points)
          continue;
        const VolumeMoments<dim> moments = make_shape(body.shape)->volume_moments();
        const bool is_compressed         = body.initial_state == InitialState::hydrostatic;
        rows.push_back(row_of(body.name + ", its shape" + (is_compressed ? ", undeformed" : ""),
                              moments.volume,
                              moments,
                              body.density));
      }
    return aligned(rows);
  }

#define INSTANTIATE(dim)               \
  template std::string seeding_report( \
    const std::vector<BodyParameters<dim>> &, const std::vector<Body<dim>> &, MPI_Comm);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
