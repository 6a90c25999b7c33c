// The inside of a mesh against the shape that it is a mesh of.

#include "../catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/mesh_shape.h>
#include <magmpm/motion/pose.h>

#include <vtkCellArray.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "../test_folder.h"
#include "shape_checks.h"
#include "test_meshes.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  /** VTK's own signed distance, some tens of microseconds per point. */
  class VtkDistance
  {
  public:
    explicit VtkDistance(const TriangleMesh &mesh)
    {
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      for (const Vector<3> &point : mesh.points)
        points->InsertNextPoint(point.values);
      vtkNew<vtkCellArray> triangles;
      for (const auto &[a, b, c] : mesh.triangles)
        {
          triangles->InsertNextCell(3);
          for (const int i : {a, b, c})
            triangles->InsertCellPoint(i);
        }
      vtkNew<vtkPolyData> data;
      data->SetPoints(points);
      data->SetPolys(triangles);
      distance->SetInput(data);
    }

    double
    at(Vector<3> point)
    {
      return distance->EvaluateFunction(point.values);
    }

  private:
    vtkNew<vtkImplicitPolyDataDistance> distance;
  };

  BoundingBox<3>
  grown(BoundingBox<3> box, const double margin)
  {
    for (int d = 0; d < 3; ++d)
      {
        box.lower[d] -= margin;
        box.upper[d] += margin;
      }
    return box;
  }
} // namespace

TEST_CASE("A cube of triangles is a box", "[geometry]")
{
  // Volume, centroid, second moments and box of a turned and scaled cube, by the divergence theorem
  // against the formulas for a cube (volume a^3, moments a^5/12 whichever way it is turned), and what
  // it contains against a box in the cube's own frame, on lattice planes through sides and corners of
  // the triangles too.
  ShapeParameters<3> parameters;
  parameters.type  = ShapeType::mesh;
  parameters.file  = fresh_folder("mesh_shape-cube") + "/cube.stl";
  parameters.scale = 0.5;
  write_stl(parameters.file, unit_cube());
  parameters.rotation                   = {{0.3, -0.2, 1.1}};
  parameters.translation                = {{0.4, 0.5, 0.6}};
  const std::unique_ptr<Shape<3>> shape = make_shape(parameters);

  const Pose<3> pose             = {parameters.translation, rotation_by<3>(parameters.rotation)};
  const Vector<3> middle         = pose.to_world({{0.25, 0.25, 0.25}});
  const VolumeMoments<3> moments = shape->volume_moments();
  CHECK(moments.volume == Approx(0.125));
  CHECK(norm(moments.centroid - middle) < 1e-12);
  CHECK(frobenius_norm(moments.second + (-std::pow(0.5, 5) / 12.) * identity<3>()) < 1e-12);
  CHECK(norm(0.5 * (shape->bounding_box().lower + shape->bounding_box().upper) - middle) < 1e-12);

  const BoxShape<3> box({{0., 0., 0.}}, {{0.5, 0.5, 0.5}});
  std::mt19937 engine(1);
  int n_wrong = 0, n_inside = 0;
  for (int i = 0; i < 20000; ++i)
    {
      const Vector<3> x = random_point(engine, grown(box.bounding_box(), 0.2));
      n_inside += box.contains(x);
      n_wrong += shape->contains(pose.to_world(x)) != box.contains(x);
    }
  CHECK(n_wrong == 0);
  CHECK(n_inside > 1000);

  const MeshShape upright(unit_cube());
  for (int i = -2; i < 11; ++i)
    for (int j = -2; j < 11; ++j)
      for (int k = -2; k < 11; ++k)
        {
          const Vector<3> x = {{(i + 0.5) / 9., j / 8., k / 8.}};
          // On a face itself either answer is right.
          if (j > 0 && j < 8 && k > 0 && k < 8)
            n_wrong += upright.contains(x) != (x[0] > 0. && x[0] < 1.);
          else if (j < 0 || j > 8 || k < 0 || k > 8)
            n_wrong += upright.contains(x);
        }
  CHECK(n_wrong == 0);
}

TEST_CASE("A mesh of a sphere has the moments of a sphere", "[geometry]")
{
  // Corners on the sphere: the volume falls short in proportion to the square of the edges, by 0.9 %
  // in 1,280 triangles and a quarter of that in four times as many.
  const double exact   = 4. / 3. * constants::pi;
  const auto shortfall = [&](const int n) {
    return 1. - volume_moments(unit_sphere(n)).volume / exact;
  };
  CHECK(shortfall(3) == Approx(0.0086).epsilon(0.02));
  CHECK(shortfall(4) == Approx(0.25 * shortfall(3)).epsilon(0.02));
  check_moments_by_points(MeshShape(moved(unit_sphere(3), 0.7, {{0.3, -1., 2.}})), 0.02, 0.01);
  const VolumeMoments<3> moments = volume_moments(moved(unit_sphere(4), 1., {{5., -7., 3.}}));
  CHECK(frobenius_norm(moments.second + (-exact / 5.) * identity<3>()) < 0.01);
}

TEST_CASE("Sampled distances and normals of a sphere err by the square of the spacing",
          "[geometry]")
{
  // Against |x| - 1 and x/|x| of the unit sphere, from a third of its radius in to a tenth out. The
  // mesh itself (20,480 triangles) is within 3e-4 of the sphere; interpolation along three axes of a
  // field whose curvature is 1/R across errs by up to 2 h^2/(8 R) at R = 2/3: half as much spacing, a
  // quarter of the error.
  double error_before = 0.;
  for (const double h : {0.16, 0.08})
    {
      const MeshShape sphere(unit_sphere(5), h);
      std::mt19937 engine(1);
      double error = 0., turned = 0., turned_near = 0.;
      for (int i = 0; i < 20000; ++i)
        {
          const Vector<3> x = random_point<3>(engine, {{{-1.1, -1.1, -1.1}}, {{1.1, 1.1, 1.1}}});
          const double r    = norm(x);
          if (r < 2. / 3. || r > 1.1)
            continue;
          const SurfaceDistance<3> found = sphere.surface_distance(x);
          error                          = std::max(error, std::abs(found.distance - (r - 1.)));
          const double here              = norm(found.normal - (1. / r) * x);
          turned                         = std::max(turned, here);
          if (std::abs(r - 1.) < h)
            turned_near = std::max(turned_near, here);
          CHECK(norm(found.normal) == Approx(1.));
        }
      INFO("h = " << h << ": distance " << error << ", normal " << turned << ", near the surface "
                  << turned_near);
      CHECK(error < 2. * h * h / (8. * 2. / 3.) + 3e-4);
      CHECK(turned_near < 0.06);
      CHECK(turned < 0.2);
      if (error_before > 0.)
        CHECK(error < 0.35 * error_before);
      error_before = error;
    }
}

TEST_CASE("Beyond its samples a distance is never too short and not much too long", "[geometry]")
{
  // Points at 1.2, 2 and 10 radii from the middle of a unit sphere whose samples end at some 1.1.
  const MeshShape sphere(unit_sphere(5), 0.04);
  std::mt19937 engine(1);
  for (const auto &[r, margin] : {std::pair(1.2, 0.01), std::pair(2., 0.06), std::pair(10., 0.05)})
    {
      double shortest = 0., longest = 0.;
      for (int i = 0; i < 2000; ++i)
        {
          const Vector<3> any = random_point<3>(engine, {{{-1., -1., -1.}}, {{1., 1., 1.}}});
          const double d      = sphere.surface_distance((r / norm(any)) * any).distance;
          shortest            = std::min(shortest, d - (r - 1.));
          longest             = std::max(longest, d - (r - 1.));
        }
      INFO("at " << r << " too long by " << longest);
      CHECK(shortest > -1e-3);
      CHECK(longest < margin * (r - 1.));
    }
}

TEST_CASE("Distances from a mesh with edges, a gap and a cavity are VTK's", "[geometry]")
{
  // A cube with a coarse ball as a cavity and another beside it, so that there are convex and concave
  // edges and gaps: contains() is the sign of VTK's distance at every point, and sampled distances err
  // by less than the spacing, most in the middle between two walls, less near the surface.
  const TriangleMesh mesh = joined(joined(moved(unit_cube(), 1., {{0., 0., 0.}}),
                                          moved(unit_sphere(2), 0.4, {{1.7, 0.5, 0.5}})),
                                   turned_over(moved(unit_sphere(1), 0.3, {{0.5, 0.5, 0.5}})));
  const MeshShape shape(mesh, 0.06);
  VtkDistance exact(mesh);
  std::mt19937 engine(1);
  int n_wrong  = 0;
  double error = 0., error_near = 0.;
  const int n = 4000;
  for (int i = 0; i < n; ++i)
    {
      const Vector<3> x     = random_point(engine, grown(shape.bounding_box(), 0.15));
      const double expected = exact.at(x);
      n_wrong += (expected < 0.) != shape.contains(x);
      const double difference = std::abs(shape.surface_distance(x).distance - expected);
      error                   = std::max(error, difference);
      if (std::abs(expected) < 0.06)
        error_near = std::max(error_near, difference);
    }
  INFO("largest error " << error << ", near the surface " << error_near);
  CHECK(n_wrong == 0);
  CHECK(error < 0.6 * 0.06);
  CHECK(error_near < 0.4 * 0.06);
  check_surface_points(shape, 0.2, 0.4 * 0.06);
}
