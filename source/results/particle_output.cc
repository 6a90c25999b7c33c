#include <magmpm/results/particle_output.h>
#include <magmpm/results/written_values.h>

#include <numeric>

namespace magmpm
{
  namespace
  {
    /** The particles as vertices. */
    template <int dim>
    VtuPiece
    vertices(const std::vector<Body<dim>> &bodies,
             const std::vector<ParticleQuantity<dim>> &quantities,
             const MagnetizationModel &law)
    {
      const auto for_each_particle = [&](const auto &action) {
        for (std::size_t b = 0; b < bodies.size(); ++b)
          for (std::size_t p = 0; p < bodies[b].particles.size(); ++p)
            action(WrittenParticle<dim>{bodies[b], b, law, p});
      };
      std::size_t n = 0;
      for (const Body<dim> &body : bodies)
        n += body.particles.size();
      VtuPiece piece;
      piece.points.reserve(3 * n);
      for_each_particle([&](const WrittenParticle<dim> &at) {
        const Vector<dim> position = at.body.particles.position(at.p);
        for (int d = 0; d < 3; ++d)
          piece.points.push_back(d < dim ? static_cast<float>(position[d]) : 0.f);
      });
      piece.cells.resize(n);
      std::iota(piece.cells.begin(), piece.cells.end(), 0);
      for (const ParticleQuantity<dim> &quantity : quantities)
        piece.quantities.push_back(written_values(quantity, n, for_each_particle));
      return piece;
    }
  } // namespace

  template <int dim>
  ParticleOutput<dim>::ParticleOutput(const MPI_Comm communicator,
                                      const std::string &directory,
                                      const std::vector<std::string> &quantities,
                                      const MagnetizationModel &law)
    : communicator(communicator)
    , quantities(chosen_quantities(particle_quantities<dim>(), quantities, "particle"))
    , law(law)
    , series(communicator, directory, particle_frames)
  {
    series.make_folder();
  }

  template <int dim>
  void
  ParticleOutput<dim>::write_frame(const unsigned int frame,
                                   const double time,
                                   const std::vector<Body<dim>> &bodies)
  {
    const std::string file = write_vtu(communicator,
                                       series.folder(),
                                       series.name(),
                                       {frame, time},
                                       vertices(bodies, quantities, law));
    series.add(time, file);
  }

  template class ParticleOutput<2>;
  template class ParticleOutput<3>;
} // namespace magmpm
