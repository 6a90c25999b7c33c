#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/mesh_file.h>
#include <magmpm/geometry/mesh_parts.h>

#include <vtkAbstractPolyDataReader.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace magmpm
{
  namespace
  {
    const char *const repair =
      "Repair it, for instance in MeshLab (Filters > Cleaning and Repairing) or Blender (3D-Print "
      "Toolbox > Make Manifold).";

    /** VTK tells of errors on the terminal, once from every rank: here they become one message. */
    class QuietVtk
    {
    public:
      QuietVtk()
      {
        vtkObject::GlobalWarningDisplayOff();
      }

      ~QuietVtk()
      {
        vtkObject::SetGlobalWarningDisplay(was_on);
      }

      QuietVtk(const QuietVtk &) = delete;

    private:
      const int was_on = vtkObject::GetGlobalWarningDisplay();
    };

    vtkSmartPointer<vtkAbstractPolyDataReader>
    reader_for(const std::string &file)
    {
      std::string ending = std::filesystem::path(file).extension().string();
      std::transform(ending.begin(), ending.end(), ending.begin(), [](const unsigned char c) {
        return std::tolower(c);
      });
      if (ending == ".stl")
        return vtkSmartPointer<vtkSTLReader>::New();
      if (ending == ".obj")
        return vtkSmartPointer<vtkOBJReader>::New();
      if (ending == ".ply")
        return vtkSmartPointer<vtkPLYReader>::New();
      throw InputError(file + ": cannot tell the format of a mesh from '" + ending +
                       "'; files that end in .stl, .obj and .ply can be read.");
    }

    /** Triangles with a corner of their own each place, as the file has them. */
    vtkSmartPointer<vtkPolyData>
    read_triangles(const std::string &file)
    {
      const auto reader = reader_for(file);
      errno             = 0;
      std::ifstream stream(file);
      if (!stream || std::filesystem::is_directory(file))
        throw InputError(file + ": cannot read the mesh: " +
                         std::strerror(stream ? EISDIR : (errno == 0 ? EIO : errno)) + ".");

      reader->SetFileName(file.c_str());
      vtkNew<vtkTriangleFilter> triangles;
      triangles->PassVertsOff();
      triangles->PassLinesOff();
      triangles->SetInputConnection(reader->GetOutputPort());
      vtkNew<vtkCleanPolyData> merged;
      merged->SetTolerance(1e-7); // of the diagonal of the bounding box: digits that a text lost
      merged->SetInputConnection(triangles->GetOutputPort());
      vtkNew<vtkTriangleFilter> whole; // without those that merging made lines
      whole->PassVertsOff();
      whole->PassLinesOff();
      whole->SetInputConnection(merged->GetOutputPort());
      whole->Update();
      vtkSmartPointer<vtkPolyData> result = whole->GetOutput();
      if (result->GetNumberOfPolys() == 0)
        throw InputError(file +
                         ": there is no triangle in this mesh. Is it whole, and really in the "
                         "format that its name says?");
      result->GetPointData()->Initialize();
      result->GetCellData()->Initialize();
      return result;
    }

    /** The number of edges of a kind, and where the first one is. */
    std::pair<vtkIdType, std::string>
    edges(vtkPolyData *mesh, const bool boundary)
    {
      vtkNew<vtkFeatureEdges> filter;
      filter->SetInputData(mesh);
      filter->SetBoundaryEdges(boundary);
      filter->SetNonManifoldEdges(!boundary);
      filter->FeatureEdgesOff();
      filter->ManifoldEdgesOff();
      filter->ColoringOff();
      filter->Update();
      vtkPolyData *found = filter->GetOutput();
      if (found->GetNumberOfLines() == 0)
        return {0, ""};
      double x[3];
      found->GetPoint(found->GetCell(0)->GetPointId(0), x);
      std::ostringstream place;
      place << '(' << x[0] << ", " << x[1] << ", " << x[2] << ')';
      return {found->GetNumberOfLines(), place.str()};
    }

    void
    check_closed(const std::string &file, vtkPolyData *mesh)
    {
      const auto [n_open, open_place]         = edges(mesh, true);
      const auto [n_manifold, manifold_place] = edges(mesh, false);
      if (n_open == 0 && n_manifold == 0)
        return;
      std::ostringstream message;
      message << file << ": the mesh is not closed. Of its " << mesh->GetNumberOfPolys()
              << " triangles, ";
      if (n_open > 0)
        message << n_open << (n_open == 1 ? " edge belongs" : " edges belong")
                << " to one triangle only (a hole or a slit; one is at " << open_place << ')';
      if (n_manifold > 0)
        message << (n_open > 0 ? ", and " : "") << n_manifold
                << (n_manifold == 1 ? " edge belongs" : " edges belong")
                << " to more than two (faces that are there twice or cross; one is at "
                << manifold_place << ')';
      message << ". " << repair;
      throw InputError(message.str());
    }

    TriangleMesh
    to_triangle_mesh(vtkPolyData *data)
    {
      TriangleMesh mesh;
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
        {
          Vector<3> point;
          data->GetPoint(i, point.values);
          mesh.points.push_back(point);
        }
      vtkIdType n;
      const vtkIdType *corners;
      data->GetPolys()->InitTraversal();
      while (data->GetPolys()->GetNextCell(n, corners))
        mesh.triangles.push_back({static_cast<int>(corners[0]),
                                  static_cast<int>(corners[1]),
                                  static_cast<int>(corners[2])});
      return mesh;
    }
  } // namespace

  TriangleMesh
  read_closed_mesh(const std::string &file)
  {
    const QuietVtk quiet;
    const auto triangles = read_triangles(file);
    check_closed(file, triangles);
    TriangleMesh mesh = to_triangle_mesh(triangles);
    try
      {
        turn_outward(mesh);
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what());
      }
    return mesh;
  }
} // namespace magmpm
