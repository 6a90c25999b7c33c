#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/exchange.h>
#include <magmpm/parallel/gather.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/parallel/together.h>
#include <magmpm/results/frame_series.h>
#include <magmpm/results/vtu_file.h>

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /** The data of a rank behind the XML, and the part of the XML that says where each array begins. */
    class AppendedPiece
    {
    public:
      /** @param piece  of this rank, which may be empty. */
      explicit AppendedPiece(const VtuPiece &piece);

      const std::vector<unsigned char> &
      data() const
      {
        return bytes;
      }

      /** @param begin  of data() behind the XML. */
      std::string
      xml(const std::uint64_t begin) const;

    private:
      struct Array
      {
        std::string section, attributes;
        std::size_t begin;
      };

      std::size_t n_points, n_cells;
      std::vector<Array> arrays;
      std::vector<unsigned char> bytes;

      template <typename Number>
      void
      append(const std::string &section,
             const std::string &name,
             const int n_components,
             const std::string &type,
             const std::vector<Number> &values);
    };

    AppendedPiece::AppendedPiece(const VtuPiece &piece)
      : n_points(piece.points.size() / 3)
      , n_cells(piece.cells.size() / piece.points_per_cell)
    {
      std::vector<std::int32_t> ends(n_cells);
      for (std::size_t c = 0; c < n_cells; ++c)
        ends[c] = piece.points_per_cell * (c + 1);
      const std::vector<std::uint8_t> types(n_cells, piece.cell_type);

      append("Points", "Points", 3, "Float32", piece.points);
      append("Cells", "connectivity", 1, "Int32", piece.cells);
      append("Cells", "offsets", 1, "Int32", ends);
      append("Cells", "types", 1, "UInt8", types);
      for (const VtuQuantity &quantity : piece.quantities)
        append("PointData", quantity.name, quantity.n_components, "Float32", quantity.values);
    }

    template <typename Number>
    void
    AppendedPiece::append(const std::string &section,
                          const std::string &name,
                          const int n_components,
                          const std::string &type,
                          const std::vector<Number> &values)
    {
      arrays.push_back({section,
                        "type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                          std::to_string(n_components) + '"',
                        bytes.size()});

      const std::uint64_t n_bytes = values.size() * sizeof(Number);
      const auto add              = [this](const void *from, const std::size_t size) {
        const auto *first = static_cast<const unsigned char *>(from);
        bytes.insert(bytes.end(), first, first + size);
      };
      add(&n_bytes, sizeof(n_bytes)); // before the values: so VTK wants it
      add(values.data(), n_bytes);
    }

    std::string
    AppendedPiece::xml(const std::uint64_t begin) const
    {
      std::ostringstream text;
      text << "<Piece NumberOfPoints=\"" << n_points << "\" NumberOfCells=\"" << n_cells << "\">\n";
      std::string section;
      for (const Array &array : arrays)
        {
          if (array.section != section)
            text << (section.empty() ? "" : "</" + section + ">\n") << '<' << array.section
                 << ">\n";
          section = array.section;
          text << "<DataArray " << array.attributes << " format=\"appended\" offset=\""
               << begin + array.begin << "\"/>\n";
        }
      text << "</" << section << ">\n</Piece>\n";
      return text.str();
    }

    /** The XML before the data of all ranks, whose pieces are given. */
    std::string
    file_start(const VtuFrame &frame, const std::vector<std::string> &pieces)
    {
      const auto field = [](const std::string &name, const auto value) {
        std::ostringstream text;
        text.precision(12);
        text << "<DataArray type=\"Float64\" Name=\"" << name
             << "\" NumberOfTuples=\"1\" format=\"ascii\">" << value << "</DataArray>\n";
        return text.str();
      };
      return "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" header_type=\"UInt64\" "
             "byte_order=\"LittleEndian\">\n"
             "<UnstructuredGrid>\n<FieldData>\n" +
             field("CYCLE", frame.number) + field("TIME", frame.time) + "</FieldData>\n" +
             std::accumulate(pieces.begin(), pieces.end(), std::string()) +
             "</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    }

    const std::string file_end = "\n</AppendedData>\n</VTKFile>\n";

    /** A file that all ranks write to; remembers errors until finish(). */
    class SharedFile
    {
    public:
      SharedFile(const MPI_Comm communicator, const std::string &path)
        : communicator(communicator)
        , path(path)
      {
        is_open = succeeded(MPI_File_open(
          communicator, path.c_str(), MPI_MODE_CREATE | MPI_MODE_WRONLY, MPI_INFO_NULL, &file));
        if (is_open)
          succeeded(MPI_File_set_size(file, 0)); // what an earlier run left
      }

      void
      write(const std::uint64_t begin, const void *data, const std::size_t n_bytes)
      {
        if (!is_open || n_bytes == 0)
          return;
        // In pieces, since MPI counts in int.
        for (std::size_t done = 0; done < n_bytes; done += parallel::largest_message)
          succeeded(
            MPI_File_write_at(file,
                              static_cast<MPI_Offset>(begin + done),
                              static_cast<const char *>(data) + done,
                              static_cast<int>(std::min(parallel::largest_message, n_bytes - done)),
                              MPI_BYTE,
                              MPI_STATUS_IGNORE));
      }

      /** Collective. */
      void
      finish()
      {
        if (is_open)
          succeeded(MPI_File_close(&file));
        if (parallel::any(has_failed, communicator))
          throw RunError("The file '" + path +
                         "' cannot be written. Is the disk full, or the output directory gone?");
      }

    private:
      const MPI_Comm communicator;
      const std::string path;
      MPI_File file;
      bool is_open    = false;
      bool has_failed = false;

      bool
      succeeded(const int error)
      {
        has_failed = has_failed || error != MPI_SUCCESS;
        return error == MPI_SUCCESS;
      }
    };

    /** The list of the one file, with its quantities. Rank 0 only. */
    bool
    write_pvtu(const std::string &path, const std::string &file, const VtuPiece &piece)
    {
      std::ofstream output(path);
      output << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
                "byte_order=\"LittleEndian\">\n<PUnstructuredGrid GhostLevel=\"0\">\n"
                "<PPoints>\n<PDataArray type=\"Float32\" NumberOfComponents=\"3\"/>\n</PPoints>\n"
                "<PPointData>\n";
      for (const VtuQuantity &quantity : piece.quantities)
        output << "<PDataArray type=\"Float32\" Name=\"" << quantity.name
               << "\" NumberOfComponents=\"" << quantity.n_components << "\"/>\n";
      output << "</PPointData>\n<Piece Source=\"" << file
             << "\"/>\n</PUnstructuredGrid>\n</VTKFile>\n";
      output.close();
      return static_cast<bool>(output);
    }
  } // namespace

  std::string
  write_vtu(const MPI_Comm communicator,
            const std::string &folder,
            const std::string &series,
            const VtuFrame &frame,
            const VtuPiece &piece)
  {
    const std::string stem  = frame_name(series, frame.number);
    const std::string name  = stem + ".0.vtu";
    const unsigned int rank = parallel::rank(communicator);

    const AppendedPiece appended(piece);
    const std::uint64_t n_bytes        = appended.data().size();
    const std::uint64_t n_bytes_of_all = parallel::sum(n_bytes, communicator);
    std::uint64_t begin                = 0; // stays what it is on rank 0
    MPI_Exscan(&n_bytes, &begin, 1, MPI_UINT64_T, MPI_SUM, communicator);
    const std::vector<std::string> pieces = parallel::gather(appended.xml(begin), communicator);
    const std::string start               = (rank == 0 ? file_start(frame, pieces) : "");
    const std::uint64_t start_size        = parallel::broadcast(start.size(), communicator);

    SharedFile file(communicator, folder + '/' + name);
    file.write(start_size + begin, appended.data().data(), n_bytes);
    if (rank == 0)
      {
        file.write(0, start.data(), start.size());
        file.write(start_size + n_bytes_of_all, file_end.data(), file_end.size());
      }
    file.finish();

    const std::string record = stem + ".pvtu";
    parallel::on_first_rank(communicator, [&]() {
      if (!write_pvtu(folder + '/' + record, name, piece))
        throw RunError("The file '" + folder + '/' + record +
                       "' cannot be written. Is the disk full?");
    });
    return record;
  }
} // namespace magmpm
