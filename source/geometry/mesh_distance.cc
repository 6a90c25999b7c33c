#include <magmpm/geometry/mesh_distance.h>

#include <vtkCellArray.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace magmpm
{
  struct MeshDistance::Implementation
  {
    vtkNew<vtkImplicitPolyDataDistance> distance;
  };

  MeshDistance::MeshDistance(const TriangleMesh &mesh)
    : implementation(std::make_unique<Implementation>())
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vector<3> &point : mesh.points)
      points->InsertNextPoint(point.values);
    vtkNew<vtkCellArray> triangles;
    for (const std::array<int, 3> &triangle : mesh.triangles)
      {
        triangles->InsertNextCell(3);
        for (const int point : triangle)
          triangles->InsertCellPoint(point);
      }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(triangles);
    implementation->distance->SetInput(data);
  }

  MeshDistance::~MeshDistance() = default;

  SurfaceDistance<3>
  MeshDistance::at(const Vector<3> &point) const
  {
    Vector<3> x = point, nearest;
    const double distance =
      implementation->distance->EvaluateFunctionAndGetClosestPoint(x.values, nearest.values);
    // Away from the surface the direction of the nearest point is the more exact normal.
    const Vector<3> from_nearest = point - nearest;
    const double length          = norm(from_nearest);
    if (length > 0.)
      return {distance, ((distance < 0. ? -1. : 1.) / length) * from_nearest};
    Vector<3> normal;
    implementation->distance->EvaluateGradient(x.values, normal.values);
    return {0., (1. / norm(normal)) * normal};
  }
} // namespace magmpm
