// Reading meshes: three formats, what is mended, and the wording of what is refused.

#include "../catch.h"

#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/mesh_file.h>
#include <magmpm/geometry/mesh_interior.h>

#include "../test_folder.h"
#include "test_meshes.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  std::string
  message_on(const std::string &file)
  {
    try
      {
        read_closed_mesh(file);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  /** The message on a mesh, without the name of the file in front. */
  std::string
  message_on(const TriangleMesh &mesh)
  {
    const std::string file = fresh_folder("mesh_file-message") + "/mesh.stl";
    write_stl(file, mesh);
    const std::string message = message_on(file);
    CHECK((message.empty() || message.rfind(file + ": ", 0) == 0));
    return message.empty() ? "" : message.substr(file.size() + 2);
  }

  TriangleMesh
  read_back(const TriangleMesh &mesh)
  {
    const std::string file = fresh_folder("mesh_file-read_back") + "/mesh.obj";
    write_obj(file, mesh);
    return read_closed_mesh(file);
  }

  const std::string repair =
    " Repair it, for instance in MeshLab (Filters > Cleaning and Repairing) or Blender (3D-Print "
    "Toolbox > Make Manifold).";
} // namespace

TEST_CASE("STL, OBJ and PLY files of a mesh are the same mesh", "[geometry]")
{
  // A sphere of 1,280 triangles in each format, ending in capitals or not. An STL file has each corner
  // six times, with seven digits, which must become one again; numbers in a PLY file are floats.
  const std::string folder = fresh_folder("mesh_file-formats");
  const TriangleMesh mesh  = moved(unit_sphere(3), 0.3, {{0.1, 0.2, -0.4}});
  write_stl(folder + "/sphere.STL", mesh);
  write_obj(folder + "/sphere.obj", mesh);
  write_ply(folder + "/sphere.ply", mesh);
  for (const char *name : {"sphere.STL", "sphere.obj", "sphere.ply"})
    {
      const TriangleMesh found = read_closed_mesh(folder + "/" + name);
      CHECK(found.points.size() == mesh.points.size());
      CHECK(found.triangles.size() == mesh.triangles.size());
      CHECK(volume_moments(found).volume == Approx(volume_moments(mesh).volume).epsilon(1e-5));
    }
}

TEST_CASE("A polygon of an OBJ file becomes triangles", "[geometry]")
{
  // The unit cube in six squares with corners of texture, as modelling programs write it.
  const std::string file = fresh_folder("mesh_file-polygons") + "/cube.obj";
  std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
                         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                         "f 1/1 3/2 4/3 2/4\nf 5/1 6/2 8/3 7/4\nf 1/1 2/2 6/3 5/4\n"
                         "f 3/1 7/2 8/3 4/4\nf 1/1 5/2 7/3 3/4\nf 2/1 4/2 8/3 6/4\n";
  const TriangleMesh cube = read_closed_mesh(file);
  CHECK(cube.points.size() == 8);
  CHECK(cube.triangles.size() == 12);
  CHECK(volume_moments(cube).volume == Approx(1.));
}

TEST_CASE("Whichever way its triangles are turned, a mesh encloses its inside", "[geometry]")
{
  // A cube inside out, with every third triangle turned over, and two cubes of which one is inside
  // out: positive volumes. A cube inside a cube is a cavity, one in the cavity is full, whatever way
  // the file has them: 27 - 8 + 1.
  CHECK(volume_moments(read_back(turned_over(unit_cube()))).volume == Approx(1.));
  TriangleMesh mixed = unit_cube();
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 3)
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  CHECK(volume_moments(read_back(mixed)).volume == Approx(1.));
  const TriangleMesh beside = turned_over(moved(unit_cube(), 1., {{2., 0., 0.}}));
  CHECK(volume_moments(read_back(joined(unit_cube(), beside))).volume == Approx(2.));

  const TriangleMesh outer  = moved(unit_cube(), 3., {{-1., -1., -1.}});
  const TriangleMesh middle = moved(unit_cube(), 2., {{-0.5, -0.5, -0.5}});
  for (const TriangleMesh &cavity : {middle, turned_over(middle)})
    {
      const TriangleMesh shells = read_back(joined(joined(unit_cube(), cavity), outer));
      CHECK(volume_moments(shells).volume == Approx(20.));
      const MeshInterior interior(shells);
      CHECK(interior.contains({{0.5, 0.5, 0.5}}));
      CHECK_FALSE(interior.contains({{-0.25, 0.5, 0.5}}));
      CHECK(interior.contains({{-0.75, 0.5, 0.5}}));
      CHECK_FALSE(interior.contains({{-1.25, 0.5, 0.5}}));
    }
}

TEST_CASE("Messages on meshes that are not closed", "[geometry]")
{
  // A cube without one triangle has three free edges, around the hole; with a triangle there twice,
  // three edges of three triangles; with a wing on an edge, one edge of three triangles and two free
  // ones. Where the first of them is, the user is told too.
  TriangleMesh open = unit_cube();
  open.triangles.pop_back();
  CHECK(message_on(open) == "the mesh is not closed. Of its 11 triangles, 3 edges belong to one "
                            "triangle only (a hole or a slit; one is at (1, 0, 1))." +
                              repair);
  TriangleMesh winged = unit_cube();
  winged.points.push_back({{2., -1., 0.5}});
  winged.triangles.push_back({1, 5, 8});
  CHECK(
    message_on(winged) ==
    "the mesh is not closed. Of its 13 triangles, 2 edges belong to one triangle only (a hole or "
    "a slit; one is at (1, 0, 1)), and 1 edge belongs to more than two (faces that are there "
    "twice or cross; one is at (1, 0, 0))." +
      repair);
  CHECK(message_on(joined(unit_cube(), moved(unit_cube(), 1., {{1., 0., 0.}})))
          .find("to more than two (faces that are there twice or cross") != std::string::npos);
  CHECK(message_on(joined(unit_cube(), moved(unit_cube(), 1., {{0.5, 0.5, 0.5}}))) ==
        "the mesh consists of parts that are closed each but cross one another. Unite them to one "
        "surface (Blender: Boolean > Union).");
  CHECK(message_on(unit_cube()).empty());
}

// A file that is missing, one of no known kind, and ones of words: what a user reads names the
// file and what is allowed.
TEST_CASE("Messages on files that hold no mesh", "[geometry]")
{
  const std::string folder = fresh_folder("mesh_file-files");
  CHECK(message_on(folder + "/none.stl") ==
        folder + "/none.stl: cannot read the mesh: No such file or directory.");
  CHECK(message_on(folder + "/cube.step") ==
        folder +
          "/cube.step: cannot tell the format of a mesh from '.step'; files that end in .stl, "
          ".obj and .ply can be read.");
  for (const std::string name : {"/text.stl", "/text.obj", "/text.ply"})
    {
      std::ofstream(folder + name) << "these are not the triangles that you are looking for\n";
      CHECK(message_on(folder + name) ==
            folder + name +
              ": there is no triangle in this mesh. Is it whole, and really in the format that its "
              "name says?");
    }
}
