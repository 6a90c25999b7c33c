#include <magmpm/base/exceptions.h>
#include <magmpm/results/particle_output.h>
#include <magmpm/results/vtu_file.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <numeric>

namespace magmpm
{
  namespace
  {
    const std::string subfolder = "particles";

    /** The particles as vertices, in single precision; vectors get a third component in 2D. */
    template <int dim>
    VtuPiece
    vertices(const std::vector<Vector<dim>> &positions,
             const std::vector<ParticleQuantity> &quantities)
    {
      VtuPiece piece;
      piece.points.assign(3 * positions.size(), 0.f);
      for (std::size_t p = 0; p < positions.size(); ++p)
        for (int d = 0; d < dim; ++d)
          piece.points[3 * p + d] = static_cast<float>(positions[p][d]);
      piece.cells.resize(positions.size());
      std::iota(piece.cells.begin(), piece.cells.end(), 0);

      for (const ParticleQuantity &quantity : quantities)
        {
          const int n = quantity.n_components;
          Assert(n == 1 || n == dim,
                 dealii::ExcMessage("A quantity is a scalar or a vector of the space."));
          AssertDimension(quantity.values.size(), n * positions.size());
          VtuQuantity written = {quantity.name + " [" + quantity.unit + "]", n == 1 ? 1 : 3, {}};
          written.values.assign(written.n_components * positions.size(), 0.f);
          for (std::size_t p = 0; p < positions.size(); ++p)
            for (int c = 0; c < n; ++c)
              written.values[p * written.n_components + c] =
                static_cast<float>(quantity.values[p * n + c]);
          piece.quantities.push_back(std::move(written));
        }
      return piece;
    }
  } // namespace

  template <int dim>
  ParticleOutput<dim>::ParticleOutput(const MPI_Comm communicator, const std::string &directory)
    : communicator(communicator)
    , directory(directory)
    , record(directory + "/" + subfolder + ".pvd")
  {
    const std::filesystem::path folder = std::filesystem::path(directory) / subfolder;

    // All ranks learn of a failure: one that threw alone would leave the others waiting.
    int is_made = 1;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        is_made = !error;
      }
    if (dealii::Utilities::MPI::min(is_made, communicator) == 0)
      throw RunError("The folder '" + folder.string() +
                     "' for the particles cannot be made. Are you allowed to write there?");
  }

  template <int dim>
  void
  ParticleOutput<dim>::write_frame(const unsigned int frame,
                                   const double time,
                                   const std::vector<Vector<dim>> &positions,
                                   const std::vector<ParticleQuantity> &quantities)
  {
    const std::string file = write_vtu(communicator,
                                       directory + "/" + subfolder,
                                       subfolder,
                                       {frame, time},
                                       vertices(positions, quantities));
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      record.add(time, subfolder + "/" + file);
  }

  template class ParticleOutput<2>;
  template class ParticleOutput<3>;
} // namespace magmpm
