#pragma once

#include <magmpm/geometry/region_moments.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace magmpm
{
  /** The nearest point of a surface, seen from a point. */
  template <int dim>
  struct SurfaceDistance
  {
    double distance;    ///< negative inside [m]
    Vector<dim> normal; ///< of length 1, outward, at the nearest point
  };

  /** A place just outside of a shape that a point inside may leave it to. */
  template <int dim>
  struct WayOut
  {
    Vector<dim> place;
    double weight; ///< of this place among all; they sum to 1
  };

  /**
   * The ways out of a point inside by several faces: @p depths [m] below each, weights depth^-2. Close to
   * a face it alone counts.
   */
  template <int dim>
  std::vector<WayOut<dim>>
  ways_by_faces(const std::vector<Vector<dim>> &places,
                const std::vector<double> &depths,
                const double least_depth);

  /** A surface for pictures: points and triangles (in 2D lines) between them, turned outward. */
  template <int dim>
  struct SurfaceMesh
  {
    std::vector<Vector<dim>> points; ///< [m]
    std::vector<std::array<int, dim>> facets;
  };

  /** How often a lattice cell is halved where a surface crosses it: 1/16, in 2D 1/128 of its edge. */
  template <int dim>
  inline constexpr int cell_depth = (dim == 2 ? 7 : 4);

  /**
   * A closed region of space: a body is seeded in it, a magnet or a rigid body has it. All points
   * are in the frame of the shape, which whoever holds it places in the world (Pose).
   */
  template <int dim>
  class Shape
  {
  public:
    virtual ~Shape() = default;

    /** Exact, and quick. */
    virtual bool
    contains(const Vector<dim> &point) const = 0;

    /**
     * Exact but for a mesh (MeshShape) and for shapes made of others (CombinedShape), and quick: to be
     * asked in each step.
     */
    virtual SurfaceDistance<dim>
    surface_distance(const Vector<dim> &point) const = 0;

    /**
     * Of a point inside: places just outside, with weights. What is continuous outside, taken there and
     * averaged, goes on continuously inside, and has the same values on both sides of the surface. That is
     * the nearest place where it changes smoothly with the point; at a shape with edges it jumps, and the
     * faces take turns.
     */
    virtual std::vector<WayOut<dim>>
    ways_out(const Vector<dim> &point) const;

    virtual BoundingBox<dim>
    bounding_box() const = 0;

    virtual VolumeMoments<dim>
    volume_moments() const = 0;

    /**
     * Moments, about the middle of @p box, of the part of the shape in it.
     *
     * Exact for boxes and meshes. Otherwise the box is halved along all axes until the surface in it is
     * as good as flat, at most @p depth times, and then cut by the plane nearest to the distances of
     * the surface at its Gauss points: the mean of these takes the curvature in, so that what remains
     * is a part of about (edge/R)^4 of a smooth cut, and (edge/2^depth)^2 per length of an edge of the
     * surface.
     *
     * @param box    its edges longer than 0.
     * @param depth  0: cuts the box as it is.
     */
    virtual RegionMoments<dim>
    moments_within(const BoundingBox<dim> &box, const int depth = cell_depth<dim>) const;

    /**
     * Points all over the surface, edges and corners among them, neighbours at most @p spacing [m]
     * apart. Some may be there twice.
     */
    virtual std::vector<Vector<dim>>
    surface_points(const double spacing) const = 0;

    /** The surface; what is round has edges of about @p spacing [m]. Empty if there is none to show. */
    virtual SurfaceMesh<dim>
    surface_mesh(const double /*spacing*/) const
    {
      return {};
    }
  };

  enum class ShapeType
  {
    box,
    sphere,       ///< a disc in 2D
    cylinder,     ///< 3D only
    tube,         ///< a cylinder with a cylindrical hole along its axis, 3D only
    ring,         ///< a torus; in 2D a disc with a round hole in its middle
    mesh,         ///< the inside of a closed triangle mesh, 3D only
    union_of,     ///< what any of ShapeParameters::parts holds
    difference,   ///< what the first of them holds and no other
    intersection, ///< what all of them hold
    points        ///< no region but a list of particles (PointCloudShape): of bodies only
  };

  /** A shape as a parameter file gives it. */
  template <int dim>
  struct ShapeParameters
  {
    ShapeType type = ShapeType::box;
    Vector<dim> lower_corner, upper_corner; ///< box [m]
    Vector<dim> centre;       ///< of what is round (cylinder, tube: middle of the axis) [m]
    double radius       = 0.; ///< of what is round, the outer one [m]
    double inner_radius = 0.; ///< tube, ring: of the hole [m]
    Vector<dim> axis;         ///< cylinder, tube, ring in 3D: its direction, any length
    double length = 0.;       ///< cylinder, tube [m]

    /** Mesh: STL, OBJ or PLY; points: CSV. Then scaled, rotated about its origin, translated. */
    std::string file;
    double scale = 1.;
    Vector<n_axial_components<dim>> rotation; ///< axis times angle [rad]
    Vector<dim> translation;                  ///< [m]

    std::vector<std::string> part_names; ///< union, difference, intersection: names of their parts
    std::vector<ShapeParameters> parts;  ///< the same, at least two

    double sample_spacing = 0.; ///< mesh: between the samples of its distance [m]; 0: derived
  };

  /**
   * @throw InputError  if a file cannot be read or a mesh is not closed (names the file, says what is
   *                    wrong and what to do), or if nothing is left of a difference or intersection.
   */
  template <int dim>
  std::unique_ptr<Shape<dim>>
  make_shape(const ShapeParameters<dim> &parameters);
} // namespace magmpm
