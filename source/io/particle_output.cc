#include <magmpm/base/exceptions.h>
#include <magmpm/io/output_patches.h>
#include <magmpm/io/particle_output.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>

namespace magmpm
{
  namespace
  {
    const std::string subfolder = "particles";

    std::string
    written_name(const ParticleQuantity &quantity)
    {
      return quantity.name + " [" + quantity.unit + "]";
    }

    /** The particles in the form deal.II writes: patches of dimension 0, one vertex each. */
    template <int dim>
    class ParticlePatches : public OutputPatches<0, dim>
    {
    public:
      ParticlePatches(const std::vector<Vector<dim>> &positions,
                      const std::vector<ParticleQuantity> &quantities);

    };

    template <int dim>
    ParticlePatches<dim>::ParticlePatches(const std::vector<Vector<dim>> &positions,
                                          const std::vector<ParticleQuantity> &quantities)
    {
      this->patches.resize(positions.size());
      for (const ParticleQuantity &quantity : quantities)
        {
          Assert(quantity.n_components == 1 || quantity.n_components == dim,
                 dealii::ExcMessage("A quantity is a scalar or a vector of the space."));
          AssertDimension(quantity.values.size(), quantity.n_components * positions.size());

          this->add_quantity(quantity.name, quantity.unit, quantity.n_components);
        }

      for (std::size_t p = 0; p < positions.size(); ++p)
        {
          auto &patch       = this->patches[p];
          patch.patch_index = p;
          for (int d = 0; d < dim; ++d)
            patch.vertices[0][d] = positions[p][d];

          patch.data.reinit(this->n_components(), 1);
          unsigned int component = 0;
          for (const ParticleQuantity &quantity : quantities)
            for (int c = 0; c < quantity.n_components; ++c)
              patch.data(component++,
                         0) = static_cast<float>(quantity.values[p * quantity.n_components + c]);
        }
    }
    /**
     * Writes the file of a frame without particles. deal.II (9.4) leaves the points out of it, and
     * VTK, thus ParaView, reports an error when it reads such a file.
     */
    void
    write_empty_vtu(const std::string &path, const std::vector<ParticleQuantity> &quantities)
    {
      const auto empty_array = [](const std::string &type, const std::string &attributes) {
        return "<DataArray type=\"" + type + "\" " + attributes + " format=\"ascii\"/>\n";
      };
      std::ofstream file(path);
      file << "<?xml version=\"1.0\"?>\n"
           << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
           << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\">\n"
           << "<Points>\n"
           << empty_array("Float32", "NumberOfComponents=\"3\"") << "</Points>\n<Cells>\n"
           << empty_array("Int32", "Name=\"connectivity\"")
           << empty_array("Int32", "Name=\"offsets\"") << empty_array("UInt8", "Name=\"types\"")
           << "</Cells>\n<PointData>\n";
      for (const ParticleQuantity &quantity : quantities)
        file << empty_array("Float32",
                            "Name=\"" + written_name(quantity) + "\" NumberOfComponents=\"" +
                              (quantity.n_components > 1 ? "3" : "1") + '"');
      file << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
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
    ParticlePatches<dim> output(positions, quantities);

    // best_compression, deal.II's default, takes several times as long for a few percent of space.
    dealii::DataOutBase::VtkFlags flags;
    flags.time                = time;
    flags.cycle               = frame;
    flags.print_date_and_time = false; // equal runs, equal files
    flags.compression_level   = dealii::DataOutBase::VtkFlags::best_speed;
    output.set_flags(flags);

    const unsigned int n_digits = 4;
    const unsigned int n_groups = 1; // one file a frame, whatever the number of ranks
    const std::string folder    = directory + "/" + subfolder + "/";
    const std::string pvtu =
      output.write_vtu_with_pvtu_record(folder, subfolder, frame, communicator, n_digits, n_groups);

    const auto n_particles = dealii::Utilities::MPI::sum(positions.size(), communicator);
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        if (n_particles == 0)
          write_empty_vtu(folder + std::filesystem::path(pvtu).stem().string() + ".0.vtu",
                          quantities);
        record.add(time, subfolder + "/" + pvtu);
      }
  }

  template class ParticleOutput<2>;
  template class ParticleOutput<3>;
} // namespace magmpm
