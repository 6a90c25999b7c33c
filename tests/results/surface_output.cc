// The surface around particles, as ParaView reads it.

#include "catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/results/surface_output.h>

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkFeatureEdges.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "../test_folder.h"

#include <cmath>
#include <map>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  constexpr double dx = 0.1;

  template <int dim>
  Lattice<dim>
  lattice()
  {
    Lattice<dim> lattice;
    lattice.spacing = dx;
    lattice.n_cells.fill(32);
    return lattice;
  }

  /** This rank's share of a sphere of that radius in dx; none if it is 0. */
  template <int dim>
  Body<dim>
  sphere(const double radius, const double centre)
  {
    BodyParameters<dim> parameters;
    parameters.name         = "sphere";
    parameters.density      = 1000.;
    parameters.shape.type   = ShapeType::sphere;
    parameters.shape.radius = radius * dx;
    for (int d = 0; d < dim; ++d)
      parameters.shape.centre[d] = (centre + 0.3 * d) * dx;
    MaterialParameters material;
    material.law           = MechanicalLaw::neo_hookean;
    material.shear_modulus = 1.;
    Body<dim> body(parameters, material);
    if (radius > 0.)
      seed_particles(parameters, lattice<dim>(), 0, this_rank(), n_ranks(), body);
    return body;
  }

  template <int dim>
  void
  write(const std::string &folder,
        const std::vector<Body<dim>> &bodies,
        const std::size_t n_nodes_at_once = 1 << 23)
  {
    SurfaceOutput<dim> output(MPI_COMM_WORLD, folder, lattice<dim>(), n_nodes_at_once);
    output.write_frame(7, 0.25, bodies);
  }

  vtkSmartPointer<vtkPolyData>
  read(const std::string &folder)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder + "/surface/surface_0007.vtp").c_str());
    reader->Update();
    return reader->GetOutput();
  }

  vtkIdType
  open_edges(vtkPolyData *surface)
  {
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(surface);
    edges->BoundaryEdgesOn();
    edges->NonManifoldEdgesOn();
    edges->FeatureEdgesOff();
    edges->ManifoldEdgesOff();
    edges->Update();
    return edges->GetOutput()->GetNumberOfLines();
  }
} // namespace

TEST_CASE("The surface of a sphere has its area and encloses its volume", "[results][mpi]")
{
  // A sphere of radius 8 dx, on any number of ranks, beside a body without particles. Splines of width
  // s^2 = dx^2/4 draw the half level of a curved surface inward by s^2/R, 1/256 of the radius here: 1.2 %
  // of the volume, 0.8 % of the area. Flat triangles between nodes cut off as much again. No edge is
  // open, so nothing is missing where ranks meet.
  const std::string folder = fresh_folder("surface_output-sphere");
  write<3>(folder, {sphere<3>(8., 15.3), sphere<3>(0., 0.)});
  if (this_rank() > 0)
    return;
  const vtkSmartPointer<vtkPolyData> surface = read(folder);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(surface);
  const double radius = 8. * dx;
  CHECK(mass->GetVolume() == Approx(4. / 3. * constants::pi * std::pow(radius, 3)).epsilon(0.03));
  CHECK(mass->GetSurfaceArea() == Approx(4. * constants::pi * radius * radius).epsilon(0.02));
  CHECK(open_edges(surface) == 0);
  double smallest = 1e9, largest = 0.;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double x[3];
      surface->GetPoint(i, x);
      const Vector<3> r = {{x[0] - 15.3 * dx, x[1] - 15.6 * dx, x[2] - 15.9 * dx}};
      smallest          = std::min(smallest, norm(r));
      largest           = std::max(largest, norm(r));
    }
  CHECK(smallest > radius - 0.3 * dx);
  CHECK(largest < radius + 0.3 * dx);
  CHECK(contents(folder + "/surface.pvd").find("timestep=\"0.25\"") != std::string::npos);
  CHECK(contents(folder + "/surface.pvd").find("surface/surface_0007.vtp") != std::string::npos);
}

TEST_CASE("In 2D the surface is a closed line", "[results][mpi]")
{
  // A disc of radius 8 dx: the lines add up to its circumference, and every point is the end of two
  // segments.
  const std::string folder = fresh_folder("surface_output-disc");
  write<2>(folder, {sphere<2>(8., 15.3)});
  if (this_rank() > 0)
    return;
  const vtkSmartPointer<vtkPolyData> line = read(folder);
  double length                           = 0.;
  std::map<vtkIdType, int> ends;
  for (vtkIdType c = 0; c < line->GetNumberOfCells(); ++c)
    {
      vtkCell *cell = line->GetCell(c);
      for (vtkIdType i = 0; i + 1 < cell->GetNumberOfPoints(); ++i)
        {
          double a[3], b[3];
          line->GetPoint(cell->GetPointId(i), a);
          line->GetPoint(cell->GetPointId(i + 1), b);
          length += std::hypot(a[0] - b[0], a[1] - b[1]);
          ++ends[cell->GetPointId(i)];
          ++ends[cell->GetPointId(i + 1)];
        }
    }
  CHECK(length == Approx(2. * constants::pi * 8. * dx).epsilon(0.02));
  CHECK(std::all_of(ends.begin(), ends.end(), [](const auto &end) { return end.second == 2; }));
}

TEST_CASE("Bodies of a surface are told apart, and no particles make an empty file",
          "[results][mpi]")
{
  // Spheres of 3 and 5 dx that do not touch, between them an empty body: cells of the numbers 0 and 2
  // alone, on the side where each sphere is.
  const std::string folder = fresh_folder("surface_output-bodies");
  write<3>(folder, {sphere<3>(3., 6.), sphere<3>(0., 0.), sphere<3>(5., 20.)});
  if (this_rank() == 0)
    {
      const vtkSmartPointer<vtkPolyData> surface = read(folder);
      vtkDataArray *body                         = surface->GetCellData()->GetArray("body [-]");
      REQUIRE(body != nullptr);
      int n_wrong = 0;
      std::map<int, int> cells;
      for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
        {
          double x[3];
          surface->GetPoint(surface->GetCell(c)->GetPointId(0), x);
          const int number = static_cast<int>(body->GetTuple1(c));
          ++cells[number];
          n_wrong += number != (x[0] < 12. * dx ? 0 : 2);
        }
      CHECK(n_wrong == 0);
      CHECK(cells.size() == 2);
    }
  write<3>(folder, {sphere<3>(0., 0.)});
  if (this_rank() == 0)
    CHECK(read(folder)->GetNumberOfCells() == 0);
}

TEMPLATE_TEST_CASE_SIG("The surface is the same however much of the lattice is held at once",
                       "[results][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A sphere of 16 cells across in slabs of one layer of blocks each, and in one: the contours of the
  // slabs meet in the same points, and come in the same order, so that the files are equal to the byte.
  std::string written[2];
  for (const bool in_slabs : {false, true})
    {
      const std::string folder = fresh_folder("surface_output-slabs-" + std::to_string(dim) + "d" +
                                              std::to_string(in_slabs));
      write<dim>(folder, {sphere<dim>(8., 15.3)}, in_slabs ? 1 : 1 << 23);
      written[in_slabs] = contents(folder + "/surface/surface_0007.vtp");
    }
  if (this_rank() == 0)
    {
      CHECK(written[0].size() > 1000);
      CHECK(written[0] == written[1]);
    }
}
