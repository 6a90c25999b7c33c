// How far volume, centroid and inertia of seeded bodies are from those of their shapes, and how far particles lie
// outside of these, at random places of the lattice and turned at random.

#include <magmpm/base/constants.h>
#include <magmpm/parallel/error_report.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/particles/undeformed_moments.h>

#include <deal.II/base/mpi.h>

#include <shared/command_line.h>
#include <shared/stopwatch.h>
#include <verification/particles/random_bodies.h>
#include <verification/program/paths.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>

using namespace magmpm;
using namespace magmpm::benchmarks;
using namespace magmpm::verification;

namespace
{
  struct Errors
  {
    double volume   = 0.; ///< relative
    double inertia  = 0.; ///< relative, the largest of those about the axes
    double centroid = 0.; ///< over dx
    double outside  = 0.; ///< how far a particle lies outside of the shape, over dx

    void
    take(const Errors &other)
    {
      volume   = std::max(volume, other.volume);
      inertia  = std::max(inertia, other.inertia);
      centroid = std::max(centroid, other.centroid);
      outside  = std::max(outside, other.outside);
    }
  };

  /** dx is 1, and the box large enough for all bodies. */
  template <int dim>
  Lattice<dim>
  unit_lattice()
  {
    Lattice<dim> lattice;
    lattice.spacing = 1.;
    for (int d = 0; d < dim; ++d)
      {
        lattice.lower_corner[d] = -200.;
        lattice.n_cells[d]      = 400;
      }
    return lattice;
  }

  template <int dim>
  Errors
  errors_of(const BodyParameters<dim> &parameters, const VolumeMoments<dim> &exact)
  {
    Body<dim> body = empty_body<dim>(MechanicalLaw::neo_hookean, false);
    seed_particles(parameters, unit_lattice<dim>(), 0, 0, 1, body);
    const Vector<dim> &origin      = exact.centroid;
    const VolumeMoments<dim> found = about_centroid(undeformed_moments(body.particles, origin),
                                                    origin);
    Errors errors                  = {
                       std::abs(found.volume / exact.volume - 1.), 0., norm(found.centroid - exact.centroid), 0.};
    const std::unique_ptr<Shape<dim>> shape = make_shape(parameters.shape);
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      errors.outside = std::max(errors.outside,
                                shape->surface_distance(body.particles.position(p)).distance);
    for (int d = 0; d < dim; ++d)
      {
        // About axis d; in 2D only about the one across the plane.
        const auto about = [d](const VolumeMoments<dim> &moments) {
          return trace(moments.second) - (dim == 3 ? moments.second(d, d) : 0.);
        };
        errors.inertia = std::max(errors.inertia, std::abs(about(found) / about(exact) - 1.));
      }
    return errors;
  }

  class Report
  {
  public:
    Report(const bool is_csv, const int n_places)
      : is_csv(is_csv)
      , n_places(n_places)
    {
    }

    /** @param make  a shape at a random place; its exact moments are those of the shape, or @p exact's. */
    template <int dim>
    void
    measure(
      const std::string &name,
      const Errors &limits,
      const std::function<ShapeParameters<dim>(Random &)> &make,
      const int particles_per_edge = 2,
      const std::function<VolumeMoments<dim>(const ShapeParameters<dim> &)> &exact =
        [](const ShapeParameters<dim> &shape) { return make_shape(shape)->volume_moments(); })
    {
      Random random(17);
      Errors worst;
      for (int i = 0; i < n_places; ++i)
        {
          BodyParameters<dim> body;
          body.density            = 1.;
          body.particles_per_edge = particles_per_edge;
          body.shape              = make(random);
          worst.take(errors_of(body, exact(body.shape)));
        }
      const std::string start = name + (dim == 2 ? " 2D" : "");
      line(start + " volume", worst.volume, limits.volume);
      line(start + " inertia", worst.inertia, limits.inertia);
      line(start + " centroid [dx]", worst.centroid, limits.centroid);
      line(start + " outside [dx]", worst.outside, limits.outside);
    }

    void
    line(const std::string &name, const double value, const double limit)
    {
      std::printf(
        is_csv ? "%s,%.3g,%.3g\n" : "%-40s %10.2e   limit %8.1e\n", name.c_str(), value, limit);
      std::fflush(stdout);
    }

  private:
    const bool is_csv;
    const int n_places;
  };

  const Errors exact_limits = {1e-12, 1e-12, 1e-12, 1e-12};
  const Errors round_limits = {1e-3, 5e-3, 0.01, 0.3};
  const Errors mesh_limits  = {5e-3, 5e-3, 0.01, 0.4};
  // Limbs that pass through the same cell share its particles; and distances from meshes err by half a cell here.
  const Errors limb_limits = {5e-3, 5e-3, 0.01, 1.};

  template <int dim>
  Vector<dim>
  random_vector(Random &random, const double reach)
  {
    Vector<dim> vector;
    for (int d = 0; d < dim; ++d)
      vector[d] = random.between(-reach, reach);
    return vector;
  }

  template <int dim>
  ShapeParameters<dim>
  box(Random &random, const double least, const double most)
  {
    ShapeParameters<dim> shape;
    shape.lower_corner = random_vector<dim>(random, 20.);
    for (int d = 0; d < dim; ++d)
      shape.upper_corner[d] = shape.lower_corner[d] + random.between(least, most);
    return shape;
  }

  /** At a random place, its axis in a random direction. */
  template <int dim>
  ShapeParameters<dim>
  round_shape(Random &random,
              const ShapeType type,
              const double radius,
              const double inner  = 0.,
              const double length = 0.)
  {
    ShapeParameters<dim> shape;
    shape.type         = type;
    shape.centre       = random_vector<dim>(random, 20.);
    shape.axis         = random_vector<dim>(random, 1.);
    shape.radius       = radius;
    shape.inner_radius = inner;
    shape.length       = length;
    return shape;
  }

  ShapeParameters<3>
  turned_mesh(Random &random, const std::string &file, const double scale)
  {
    ShapeParameters<3> shape;
    shape.type        = ShapeType::mesh;
    shape.file        = file;
    shape.scale       = scale;
    shape.rotation    = random_vector<3>(random, 3.);
    shape.translation = random_vector<3>(random, 10.);
    return shape;
  }

  /** A file with a box around the origin. */
  std::string
  plate_file(const double length, const double width, const double thickness)
  {
    const std::string name =
      (std::filesystem::temp_directory_path() / "seeding_accuracy.obj").string();
    ShapeParameters<3> plate;
    plate.upper_corner         = 0.5 * Vector<3>{{length, width, thickness}};
    plate.lower_corner         = -1. * plate.upper_corner;
    const SurfaceMesh<3> faces = make_shape(plate)->surface_mesh(1.);
    std::ofstream file(name);
    file.precision(17);
    for (const Vector<3> &point : faces.points)
      file << "v " << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
    for (const auto &[a, b, c] : faces.facets)
      file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    return name;
  }

  /** A cylinder of radius 6 dx without one of radius 5 dx: a dish 3 dx deep with a bottom of 1 dx. */
  ShapeParameters<3>
  dish(Random &random)
  {
    const ShapeParameters<3> outer = round_shape<3>(random, ShapeType::cylinder, 6., 0., 4.);
    ShapeParameters<3> inner       = outer;
    inner.radius                   = 5.;
    inner.centre += (1. / norm(outer.axis)) * outer.axis;
    ShapeParameters<3> shape;
    shape.type   = ShapeType::difference;
    inner.length = 4.;
    shape.parts  = {outer, inner};
    return shape;
  }

  /** By the formulas of cylinders: the inner one is 3 dx long where it is in the outer one. */
  VolumeMoments<3>
  moments_of_dish(const ShapeParameters<3> &shape)
  {
    const ShapeParameters<3> &outer = shape.parts[0];
    ShapeParameters<3> pit          = shape.parts[1];
    pit.length                      = 3.;
    pit.centre                      = outer.centre + (0.5 / norm(outer.axis)) * outer.axis;
    const auto moments              = [&](const ShapeParameters<3> &part) {
      return about_point(make_shape(part)->volume_moments(), outer.centre);
    };
    return about_centroid(moments(outer) - moments(pit), outer.centre);
  }

  /** A square without a disc over a corner of it. */
  ShapeParameters<2>
  bitten_square(Random &random)
  {
    ShapeParameters<2> square = box<2>(random, 6., 6.1), disc;
    disc.type                 = ShapeType::sphere;
    disc.centre               = square.upper_corner;
    disc.radius               = 3.;
    ShapeParameters<2> shape;
    shape.type  = ShapeType::difference;
    shape.parts = {square, disc};
    return shape;
  }

  VolumeMoments<2>
  moments_of_bitten_square(const ShapeParameters<2> &shape)
  {
    // A quarter of a disc about its corner: pi R^2/4, R^3/3, pi R^4/16 and R^4/8.
    const double radius = shape.parts[1].radius;
    RegionMoments<2> quarter;
    quarter.volume = constants::pi * radius * radius / 4.;
    for (int d = 0; d < 2; ++d)
      {
        quarter.first[d]     = -std::pow(radius, 3) / 3.;
        quarter.second(d, d) = constants::pi * std::pow(radius, 4) / 16.;
      }
    quarter.second(0, 1) = quarter.second(1, 0) = std::pow(radius, 4) / 8.;
    const Vector<2> &corner                     = shape.parts[1].centre;
    return about_centroid(
      about_point(make_shape(shape.parts[0])->volume_moments(), corner) - quarter, corner);
  }

  void
  measure_round(Report &report)
  {
    for (const double radius : {2., 4.})
      {
        const std::string name = radius == 2. ? "2 dx" : "4 dx";
        report.measure<2>("disc of " + name, round_limits, [=](Random &random) {
          return round_shape<2>(random, ShapeType::sphere, radius);
        });
        report.measure<3>("sphere of " + name, round_limits, [=](Random &random) {
          return round_shape<3>(random, ShapeType::sphere, radius);
        });
      }
    report.measure<2>("ring", round_limits, [](Random &random) {
      return round_shape<2>(random, ShapeType::ring, 6., 4.5);
    });
    report.measure<3>("ring", round_limits, [](Random &random) {
      return round_shape<3>(random, ShapeType::ring, 6., 2.);
    });
    report.measure<3>("cylinder", round_limits, [](Random &random) {
      return round_shape<3>(random, ShapeType::cylinder, 4., 0., 6.);
    });
    report.measure<3>("tube", mesh_limits, [](Random &random) {
      return round_shape<3>(random, ShapeType::tube, 5., 4., 8.);
    });
    report.measure<3>("dish", mesh_limits, dish, 2, moments_of_dish);
    report.measure<2>("bitten square", round_limits, bitten_square, 2, moments_of_bitten_square);
  }

  void
  measure_meshes(Report &report)
  {
    for (const double thickness : {0.6, 1., 1.7, 2.8})
      {
        const std::string file = plate_file(12., 9., thickness);
        char name[40];
        std::snprintf(name, sizeof(name), "plate of %.1f dx", thickness);
        report.measure<3>(name, mesh_limits, [&](Random &random) {
          return turned_mesh(random, file, 1.);
        });
        std::filesystem::remove(file);
      }
    const std::string meshes = source_folder() + "/meshes/";
    for (const std::string name : {"dragon", "surfer"})
      report.measure<3>(name, limb_limits, [&](Random &random) {
        return turned_mesh(random, meshes + name + ".obj", 130.);
      });
  }

  /** A dragon as large as those of parameter_files/two_dragons.prm. */
  void
  time_dragon(Report &report)
  {
    Random random(1);
    BodyParameters<3> body;
    body.density      = 1.;
    body.shape        = turned_mesh(random, source_folder() + "/meshes/dragon.obj", 3.2 * 128.);
    Body<3> particles = empty_body<3>(MechanicalLaw::neo_hookean, false);
    const Stopwatch stopwatch;
    seed_particles(body, unit_lattice<3>(), 0, 0, 1, particles);
    report.line("dragon of two_dragons.prm [s]", stopwatch.seconds(), 2.);
  }

  void
  run_program(const std::vector<std::string> &arguments)
  {
    bool is_csv     = false;
    double n_places = 12.;
    CommandLine command_line("seeding_accuracy");
    command_line.add_switch("--csv", is_csv);
    command_line.add_number("--places", n_places);
    command_line.read(arguments);

    Report report(is_csv, static_cast<int>(n_places));
    report.measure<2>("box", exact_limits, [](Random &random) { return box<2>(random, 0.6, 9.); });
    report.measure<3>("box", exact_limits, [](Random &random) { return box<3>(random, 0.6, 9.); });
    report.measure<3>(
      "box 3 an edge", exact_limits, [](Random &random) { return box<3>(random, 0.6, 9.); }, 3);
    measure_round(report);
    measure_meshes(report);
    time_dragon(report);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(parallel::report_errors(MPI_COMM_SELF, std::cerr, [&]() {
    run_program(std::vector<std::string>(argv + 1, argv + argc));
  }));
}
