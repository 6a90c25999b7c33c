// Reading points, and the wording of what cannot be read.

#include "../catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/point_cloud_shape.h>

#include "../test_folder.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  template <int dim>
  ShapeParameters<dim>
  points_in(const std::string &text)
  {
    ShapeParameters<dim> parameters;
    parameters.type = ShapeType::points;
    parameters.file = fresh_folder("point_cloud") + "/points.csv";
    std::ofstream(parameters.file) << text;
    return parameters;
  }

  /** The message on a text, without the name of the file in front. */
  template <int dim>
  std::string
  message_on(const std::string &text)
  {
    const ShapeParameters<dim> parameters = points_in<dim>(text);
    try
      {
        read_point_cloud(parameters);
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        CHECK(message.rfind(parameters.file, 0) == 0);
        return message.substr(parameters.file.size());
      }
    return "";
  }
} // namespace

TEST_CASE("Points with and without heading, comments and volumes", "[geometry]")
{
  // The numbers of the text, with the lines that they stand in; then scaled by 2, by which a volume
  // grows eightfold, turned by 90 degrees about z and moved.
  ShapeParameters<3> parameters = points_in<3>("x [m], y [m], z [m], volume [m^3]\r\n"
                                               "# a comment\n\n"
                                               " 1, 2 ,3e0, 0.5\r\n-1,0,+.5,1e-3\n");
  PointCloud<3> cloud           = read_point_cloud(parameters);
  CHECK(cloud.lines == std::vector<int>{4, 5});
  CHECK(cloud.volumes == std::vector<double>{0.5, 1e-3});
  REQUIRE(cloud.points.size() == 2);
  CHECK(norm(cloud.points[0] - Vector<3>{{1., 2., 3.}}) == 0.);
  CHECK(norm(cloud.points[1] - Vector<3>{{-1., 0., 0.5}}) == 0.);

  parameters.scale       = 2.;
  parameters.rotation    = {{0., 0., 0.5 * constants::pi}};
  parameters.translation = {{10., 20., 30.}};
  cloud                  = read_point_cloud(parameters);
  CHECK(norm(cloud.points[0] - Vector<3>{{6., 22., 36.}}) < 1e-12);
  CHECK(cloud.volumes[0] == Approx(4.));

  const PointCloud<2> plane = read_point_cloud(points_in<2>("1,2\n3,4"));
  CHECK(plane.volumes.empty());
  REQUIRE(plane.points.size() == 2);
  CHECK(plane.points[1][1] == 4.);
}

// Files with one fault each; a message has the line and the value, and says what a point is.
TEST_CASE("Messages on points that cannot be read", "[geometry]")
{
  CHECK(message_on<3>("") == ": there is no point in this file.");
  CHECK(message_on<3>("x,y,z\n") == ": there is no point in this file.");
  CHECK(message_on<3>("1,2,3\n1,2,3x\n") ==
        ", line 2: '3x' is not a number; a point is x, y, z or x, y, z, volume.");
  CHECK(message_on<3>("1,2,nan\n") ==
        ", line 1: 'nan' is not a number; a point is x, y, z or x, y, z, volume.");
  CHECK(
    message_on<3>("x,y\n1,2\n") ==
    ", line 2: there are 2 columns; a point is x, y, z or x, y, z, volume, separated by commas.");
  CHECK(
    message_on<2>("1,2\n1,2,3\n") ==
    ", line 2: there are 3 columns, but 2 in the lines before. Give a volume in all lines or in "
    "none.");
  CHECK(message_on<2>("1,2,0\n") == ", line 1: the volume is 0; it must be greater than 0.");
  ShapeParameters<2> nowhere;
  nowhere.file = "no such file.csv";
  CHECK_THROWS_WITH(read_point_cloud(nowhere),
                    "no such file.csv: cannot read the points: No such file or directory.");
}

TEST_CASE("The moments of a list of points are sums over it", "[geometry]")
{
  // Two points of volumes 1 and 3 on the x axis: centroid at three quarters of the way, second moment
  // 1 (3/4)^2 + 3 (1/4)^2 = 3/4 along x.
  const PointCloudShape<3> shape({{{{0., 0., 0.}}, {{1., 0., 0.}}}, {1., 3.}, {1, 2}});
  CHECK(shape.volume_moments().volume == 4.);
  CHECK(shape.volume_moments().centroid[0] == 0.75);
  CHECK(shape.volume_moments().second(0, 0) == 0.75);
  CHECK(shape.surface_distance({{1., 3., 4.}}).distance == 5.);
  CHECK(shape.surface_points(0.1).size() == 2);
}
