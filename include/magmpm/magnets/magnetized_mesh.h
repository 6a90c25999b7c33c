#pragma once

#include <magmpm/geometry/triangle_mesh.h>
#include <magmpm/magnets/source_parts.h>

namespace magmpm
{
  /** Of a closed triangle mesh. */
  struct MagnetizedMeshParameters
  {
    static constexpr Interior interior = Interior::may_be_solid;

    TimeFunction<Vector<3>> magnetization; ///< in its own frame [A/m]
    std::string file;                      ///< STL, OBJ or PLY
    double scale = 1.;                     ///< of the lengths in the file
  };

  /**
   * The inside of a closed triangle mesh with uniform magnetization M of any direction. A triangle with
   * the outward normal n has the charge sigma = M.n, whose field is
   *   H = sigma/(4 pi) [Omega n + sum over its sides of L m]
   * (Wilton et al., IEEE Trans. Antennas Propag. 32, 276 (1984)): Omega is the solid angle that it is
   * seen under (van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30, 125 (1983)), m the direction in its
   * plane outward across a side, L the integral of 1/r along it,
   *   L = ln((r_1 + r_2 + l)/(r_1 + r_2 - l)).
   * The gradient is their derivative, a sum over sides alone. Sides between triangles of one plane do not
   * count. It takes the time of a logarithm for each other side and of an arctangent for each triangle.
   * The error is some 1e-14 of M, which far away is (r/a)^3 of H.
   *
   * The surface belongs to the outside: within 1e-9 of the size of the mesh from a triangle's plane the
   * field is that on its outer side; H.n jumps there by M.n. At an edge H grows like the logarithm of the
   * distance and its gradient like the inverse; the distance is never taken as less than 1e-5 of the size
   * of the mesh, so both are finite everywhere.
   */
  class MagnetizedMesh : public SourceField<3>
  {
  public:
    /** @param mesh  closed, with its triangles turned outward. */
    explicit MagnetizedMesh(const TriangleMesh &mesh);

    Vector<3>
    field(const Vector<3> &magnetization, const Vector<3> &point) const override;

    Matrix<3>
    field_gradient(const Vector<3> &magnetization, const Vector<3> &point) const override;

    bool
    is_inside(const Vector<3> &point) const override;

    /** M, which the field comes near to at the surface [A/m]. */
    Vector<3>
    strength(const Vector<3> &magnetization) const override;

    bool
    is_axisymmetric(const Vector<3> &magnetization) const override;

    double
    reach() const override;

    /**
     * By a grid of at most 12 cubes along the longest edge of the bounding box, those whose middles are
     * inside, made to have the volume of the mesh together.
     */
    std::optional<ForceAndTorque<3>>
    force_and_torque(const Vector<3> &magnetization, const ActingField<3> &acting) const override;

  private:
    struct Triangle
    {
      std::array<int, 3> corners;
      Vector<3> normal; ///< outward, of length 1
      double twice_area;
    };

    /** A side of one or more triangles, from one corner to another. */
    struct Side
    {
      int from, to;
      double length;
      Matrix<3> across; ///< times M: the sum of sigma m of its triangles
      struct Turn
      {
        Vector<3> normal;
        double sign; ///< whether it goes round the triangle along or against the side
      };
      std::vector<Turn> triangles;
    };

    void
    make_sides();

    /** Of all points of the mesh from @p point [m]. */
    std::vector<double>
    distances(const Vector<3> &point) const;

    /** Of a triangle, positive on its outer side. */
    double
    solid_angle(const Triangle &triangle,
                const Vector<3> &point,
                const std::vector<double> &distances) const;

    std::vector<VolumeElement<3>>
    make_elements() const;

    double size; ///< diagonal of the bounding box [m]
    BoundingBox<3> box;
    VolumeMoments<3> moments;
    std::vector<Vector<3>> points;
    std::vector<Triangle> triangles;
    std::vector<Side> sides;
    mutable std::vector<VolumeElement<3>> elements; ///< made when first needed
  };

  /** @throw InputError  as read_closed_mesh() does. */
  SourceParts<3>
  make_parts(const MagnetizedMeshParameters &parameters, const std::string &name);
} // namespace magmpm
