// Written fields, read back by VTK, which ParaView reads with.

#include <magmpm/base/constants.h>
#include <magmpm/results/field_output.h>

#include "../test_folder.h"
#include "catch.h"
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <verification/magnetostatics/sampled_setup.h>
#include <verification/magnetostatics/sources.h>

#include <cmath>
#include <filesystem>
#include <map>

using namespace magmpm;

namespace
{
  constexpr double spacing     = 0.01;
  constexpr double outer_field = 1e5;
  constexpr double chi         = 2.;

  /** The fields at one point of a written frame. */
  struct PointFields
  {
    Vector<3> position, self_field, field, magnetization, flux_density;
    double potential, number_density;
  };

  PointFields
  fields_at(vtkUnstructuredGrid *grid, const vtkIdType point)
  {
    PointFields fields;
    grid->GetPoint(point, fields.position.values);
    const auto read = [&](const char *name, double *values) {
      grid->GetPointData()->GetArray(name)->GetTuple(point, values);
    };
    read("H_int [A/m]", fields.self_field.values);
    read("H [A/m]", fields.field.values);
    read("M [A/m]", fields.magnetization.values);
    read("B [T]", fields.flux_density.values);
    read("potential [A]", &fields.potential);
    read("number_density [1/m^3]", &fields.number_density);
    return fields;
  }

  /** That the fields of a frame fit together, and the solution for a sphere. */
  template <int dim>
  void
  check_fields(vtkUnstructuredGrid *grid, const Vector<dim> &centre, const double radius)
  {
    Vector<3> outer;
    outer[0]      = outer_field;
    double inside = 0., n_inside = 0., worst_sum = 0., worst_flux = 0., worst_far = 0.;
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
      {
        const PointFields at = fields_at(grid, p);
        worst_sum            = std::max(worst_sum, norm(at.field - at.self_field - outer));
        worst_flux           = std::max(
          worst_flux,
          norm(at.flux_density - constants::vacuum_permeability * (at.field + at.magnetization)));
        double square = 0.;
        for (int d = 0; d < dim; ++d)
          square += std::pow(at.position[d] - centre[d], 2);
        if (square < 0.25 * radius * radius)
          {
            n_inside += 1.;
            inside += at.field[0];
            // The density is that of the volume's correction, uneven by less than a percent.
            CHECK(at.number_density == Approx(1.).epsilon(6e-3));
            CHECK(at.magnetization[0] ==
                  Approx(chi * at.number_density * at.field[0]).epsilon(6e-3));
          }
        if (square > 4. * radius * radius)
          worst_far = std::max(worst_far, norm(at.magnetization));
      }
    CHECK(worst_sum < 1e-6 * outer_field); // single precision
    CHECK(worst_flux < 1e-6 * constants::vacuum_permeability * outer_field);
    CHECK(worst_far == 0.);
    CHECK(inside / n_inside == Approx(outer_field / (1. + chi / dim)).epsilon(0.02));
  }
} // namespace

// A linear sphere in a uniform field, written and read back: H is H_int plus the uniform field, B is
// mu_0 (H + M), and H in the sphere is H_0/(1 + chi_0/dim), to the accuracy of the coarse one. Vectors have three components in 2D too.
TEMPLATE_TEST_CASE_SIG("written fields are read back by VTK",
                       "[results][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  const std::string folder = testing::fresh_folder("field_output-" + std::to_string(dim) + "d");
  MagneticsParameters<dim> parameters;
  parameters.law = MagnetizationLaw::linear;
  verification::SampledSetup<dim> scene(24, spacing, 2., parameters);
  Vector<dim> centre, outer;
  for (int d = 0; d < dim; ++d)
    centre[d] = 12. * spacing;
  outer[0]            = outer_field;
  const double radius = 7. * spacing;
  scene.set_bodies({verification::sphere<dim>(centre, radius, {1., chi})});
  const ExternalField<dim> sources({verification::uniform_source<dim>(outer)});
  scene.problem.solve(scene.content, sources);

  FieldOutput<dim> output(MPI_COMM_WORLD, folder, names_of(field_quantities<dim>()));
  output.write_frame(7, 0.25, scene.problem, sources);

  if (testing::this_rank() == 0)
    {
      CHECK(std::filesystem::exists(folder + "/fields/fields_0007.0.vtu"));
      CHECK(testing::contents(folder + "/fields.pvd").find("fields/fields_0007.pvtu") !=
            std::string::npos);
      vtkNew<vtkXMLPUnstructuredGridReader> reader;
      reader->SetFileName((folder + "/fields/fields_0007.pvtu").c_str());
      reader->Update();
      vtkUnstructuredGrid *grid = reader->GetOutput();
      CHECK(grid->GetPointData()->GetNumberOfArrays() == 6);
      if (grid->GetPointData()->GetNumberOfArrays() == 6)
        check_fields<dim>(grid, centre, radius);
    }
  MPI_Barrier(MPI_COMM_WORLD);
}

// H_int has one value at every place: a stream tracer then draws continuous field lines. Cells share
// their points, apart from hanging nodes, which the cells on both sides number for themselves: the
// values of such points are compared with those at the same place.
TEST_CASE("the written field is continuous", "[results]")
{
  const std::string folder = testing::fresh_folder("field_output-continuous");
  MagneticsParameters<2> parameters;
  verification::SampledSetup<2> scene(24, spacing, 2., parameters);
  scene.set_bodies({verification::sphere<2>({{0.12, 0.12}}, 0.05, {1e5, chi})});
  const ExternalField<2> sources({verification::uniform_source<2>({{outer_field, 0.}})});
  scene.problem.solve(scene.content, sources);
  FieldOutput<2> output(MPI_COMM_WORLD, folder, {"H_int"});
  output.write_frame(0, 0., scene.problem, sources);

  vtkNew<vtkXMLPUnstructuredGridReader> reader;
  reader->SetFileName((folder + "/fields/fields_0000.pvtu").c_str());
  reader->Update();
  vtkUnstructuredGrid *grid = reader->GetOutput();
  CHECK(grid->GetPointData()->GetNumberOfArrays() == 1);
  vtkDataArray *field = grid->GetPointData()->GetArray("H_int [A/m]");
  CHECK(field != nullptr);
  if (field == nullptr)
    return;

  std::map<std::pair<long, long>, Vector<3>> seen;
  double worst = 0.;
  int n_shared = 0;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      double x[3];
      Vector<3> value;
      grid->GetPoint(p, x);
      field->GetTuple(p, value.values);
      const auto place = std::make_pair(std::lround(1e4 * x[0]), std::lround(1e4 * x[1]));
      if (!seen.emplace(place, value).second)
        {
          ++n_shared;
          worst = std::max(worst, norm(value - seen[place]));
        }
    }
  CHECK(n_shared > 20);
  CHECK(n_shared < 0.1 * grid->GetNumberOfPoints());
  CHECK(worst < 1e-6 * outer_field);
}

// B - mu_0 H is mu_0 M, of the material as of the magnets: here of a rectangle beside a disc, inside of
// which that is known at every node, and of nothing where neither is. Its faces belong to the outside.
TEST_CASE("the written B counts the magnetization of magnets", "[results]")
{
  const std::string folder = testing::fresh_folder("field_output-magnets");
  MagneticsParameters<2> parameters;
  verification::SampledSetup<2> scene(24, spacing, 2., parameters);
  scene.set_bodies({verification::sphere<2>({{0.12, 0.12}}, 0.05, {1e5, chi})});
  SourceParameters<2> rectangle;
  rectangle.kind = CuboidParameters<2>{Vector<2>{{1e5, 2e5}}, {{0.06, 0.04}}};
  rectangle.pose = Pose<2>{{{0.12, 0.21}}};
  const ExternalField<2> sources({rectangle});
  scene.problem.solve(scene.content, sources);
  FieldOutput<2> output(MPI_COMM_WORLD, folder, {"H", "B"});
  output.write_frame(0, 0., scene.problem, sources);

  vtkNew<vtkXMLPUnstructuredGridReader> reader;
  reader->SetFileName((folder + "/fields/fields_0000.pvtu").c_str());
  reader->Update();
  vtkUnstructuredGrid *grid = reader->GetOutput();
  vtkDataArray *H           = grid->GetPointData()->GetArray("H [A/m]"),
               *B           = grid->GetPointData()->GetArray("B [T]");
  REQUIRE(H != nullptr);
  REQUIRE(B != nullptr);
  int n_inside = 0;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      double x[3], h[3], b[3];
      grid->GetPoint(p, x);
      H->GetTuple(p, h);
      B->GetTuple(p, b);
      if (std::hypot(x[0] - 0.12, x[1] - 0.12) < 0.08)
        continue;
      const bool inside = std::abs(x[0] - 0.12) < 0.0299 && std::abs(x[1] - 0.21) < 0.0199;
      n_inside += inside;
      for (int d = 0; d < 2; ++d)
        CHECK(b[d] / constants::vacuum_permeability - h[d] ==
              Approx(inside ? 1e5 * (d + 1) : 0.).margin(1.));
    }
  CHECK(n_inside > 4);
}

// The message lists all that there are, in their order.
TEST_CASE("an unknown field quantity is an input error", "[results]")
{
  CHECK_THROWS_WITH(FieldOutput<2>(MPI_COMM_WORLD, ".", {"H", "flux"}),
                    "The field quantity 'flux' is unknown. Allowed are: potential, H_int, H, M, B, "
                    "number_density.");
}
