// Written particles, read back by VTK. VTK is what ParaView reads with, so what it finds is what a
// user sees: as many vertices as all ranks have particles, with the values they were given.

#include <magmpm/results/particle_output.h>

#include "../test_folder.h"
#include "catch.h"
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>

using namespace magmpm;

namespace
{
  /** A fluid whose particles have values that can be told from the position: v = 2 x, J = x + 3 y. */
  template <int dim>
  std::vector<Body<dim>>
  body_on_a_curve(const int n, const int rank)
  {
    BodyParameters<dim> parameters;
    parameters.density = 1000.;
    MaterialParameters material;
    material.law = MechanicalLaw::viscoelastic_fluid;
    std::vector<Body<dim>> bodies(1, Body<dim>(parameters, material));
    ParticleSet<dim> &particles = bodies[0].particles;
    particles.resize(n);
    for (int p = 0; p < n; ++p)
      {
        Vector<dim> x;
        for (int d = 0; d < dim; ++d)
          {
            x[d] = std::sin(1. + p + 100 * rank + 10 * d);
            particles.component(ParticleProperty::position, d)[p] = x[d];
            particles.component(ParticleProperty::velocity, d)[p] = 2. * x[d];
          }
        particles.component(ParticleProperty::deformation, 0)[p] = x[0] + 3. * x[1];
      }
    return bodies;
  }

  template <int dim>
  ParticleOutput<dim>
  output_into(const std::string &folder)
  {
    return {MPI_COMM_WORLD, folder, {"velocity", "J"}, MagnetizationLaw::linear};
  }

  /** Counts the errors that VTK would print (a reader does not pass on those of its pieces). */
  class ErrorCounter : public vtkOutputWindow
  {
  public:
    static ErrorCounter *
    New()
    {
      return new ErrorCounter;
    }

    void
    DisplayErrorText(const char *text) override
    {
      UNSCOPED_INFO(text);
      ++n_errors;
    }

    int n_errors = 0;
  };

  vtkNew<vtkXMLPUnstructuredGridReader>
  read_frame(const std::string &path)
  {
    vtkNew<ErrorCounter> errors;
    vtkOutputWindow::SetInstance(errors);
    vtkNew<vtkXMLPUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkOutputWindow::SetInstance(nullptr);
    CHECK(errors->n_errors == 0);
    return reader;
  }

  template <int dim>
  void
  check_that_values_fit_positions(vtkUnstructuredGrid *grid)
  {
    vtkDataArray *velocity = grid->GetPointData()->GetArray("velocity [m/s]");
    vtkDataArray *J        = grid->GetPointData()->GetArray("J [-]");
    CHECK(velocity != nullptr);
    CHECK(J != nullptr);
    if (velocity == nullptr || J == nullptr)
      return; // no REQUIRE: the other ranks would wait for this one
    CHECK(J->GetNumberOfComponents() == 1);
    CHECK(velocity->GetNumberOfComponents() == 3);
    if (velocity->GetNumberOfComponents() != 3)
      return;

    double worst = 0.;
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
      {
        double x[3];
        grid->GetPoint(p, x);
        for (int d = 0; d < 3; ++d)
          worst = std::max(worst, std::abs(velocity->GetComponent(p, d) - 2. * x[d]));
        worst = std::max(worst, std::abs(J->GetComponent(p, 0) - (x[0] + 3. * x[1])));
      }
    CHECK(worst < 1e-6); // single precision of values up to 4
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("written particles are read back by VTK",
                       "[results][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Each rank writes particles with values that follow from their positions, the last rank of
  // several none at all. VTK must find all of them in one file, with real vectors in 2D too.
  const int rank = testing::this_rank(), n_ranks = testing::n_ranks();
  const bool is_empty      = (n_ranks > 1 && rank == n_ranks - 1);
  const std::string folder = testing::fresh_folder("particle_output-" + std::to_string(dim) + "d");

  const auto bodies = body_on_a_curve<dim>(is_empty ? 0 : 7 + rank, rank);
  output_into<dim>(folder).write_frame(3, 0.006, bodies);

  int n_particles = bodies[0].particles.size();
  MPI_Allreduce(MPI_IN_PLACE, &n_particles, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  if (rank == 0)
    {
      CHECK(std::filesystem::exists(folder + "/particles/particles_0003.0.vtu"));
      const auto reader         = read_frame(folder + "/particles/particles_0003.pvtu");
      vtkUnstructuredGrid *grid = reader->GetOutput();
      CHECK(grid->GetNumberOfPoints() == n_particles);
      CHECK(grid->GetNumberOfCells() == n_particles);
      check_that_values_fit_positions<dim>(grid);
    }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_CASE("a frame without any particle is a file that VTK reads", "[results][mpi]")
{
  // All particles have left the box: no rank has any. VTK must read an empty grid that still
  // names its quantities, and say nothing.
  const std::string folder = testing::fresh_folder("particle_output-empty");
  output_into<3>(folder).write_frame(0, 0., body_on_a_curve<3>(0, testing::this_rank()));

  if (testing::this_rank() == 0)
    {
      const auto reader         = read_frame(folder + "/particles/particles_0000.pvtu");
      vtkUnstructuredGrid *grid = reader->GetOutput();
      CHECK(grid->GetNumberOfPoints() == 0);
      CHECK(grid->GetPointData()->GetArray("velocity [m/s]") != nullptr);
      CHECK(grid->GetPointData()->GetArray("J [-]") != nullptr);
    }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_CASE("particles.pvd lists all frames so far", "[results][mpi]")
{
  // After each frame the record names that frame and all before it, with their times to ten
  // digits at least, and no half-written record lies beside it.
  const std::string folder = testing::fresh_folder("particle_output-pvd");
  const auto bodies        = body_on_a_curve<3>(2, testing::this_rank());
  auto output              = output_into<3>(folder);
  output.write_frame(0, 0., bodies);
  output.write_frame(1, 0.00200000001, bodies);

  if (testing::this_rank() == 0)
    {
      const std::string record = testing::contents(folder + "/particles.pvd");
      CHECK(record.find("timestep=\"0\"") != std::string::npos);
      CHECK(record.find("file=\"particles/particles_0000.pvtu\"") != std::string::npos);
      CHECK(record.find("timestep=\"0.00200000001\"") != std::string::npos);
      CHECK(record.find("file=\"particles/particles_0001.pvtu\"") != std::string::npos);
      CHECK_FALSE(std::filesystem::exists(folder + "/particles.pvd.unfinished"));
    }
  MPI_Barrier(MPI_COMM_WORLD);
}
