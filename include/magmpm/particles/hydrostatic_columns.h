#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/seeding.h>

#include <memory>
#include <vector>

namespace magmpm
{
  /**
   * Pressure at the lower end of a layer of a fluid at rest. With the density rho_0/J and p = K (1 - J),
   * dp = (rho_0/J) g dz gives J^2 = (1 - p_top/K)^2 - 2 rho_0 g h/K.
   *
   * @param upper_pressure  p_top at its upper end [Pa].
   * @param weight          rho_0 g h [Pa].
   * @param bulk_modulus    K [Pa]. The pressure is at most K, where J = 0.
   */
  double
  pressure_below(const double upper_pressure, const double weight, const double bulk_modulus);

  /**
   * What has to be added to the pressure of a particle near the floor for the lattice to be in equilibrium.
   * Images stand for what is missing behind the floor (see WallImages), but the image of a particle has the
   * particle's pressure, and not the one that would go on linearly, which is larger by 2 t rho g dx. On the first
   * node above the floor, where the image has the weight N(1 + t) and the distance 1 + t, that is missing from
   * the force; what is added acts there with N(1 - t) (1 - t) + N(1 + t) (1 + t) = 1/4, and on no other node
   * that moves.
   *
   * @param distance  t, from the floor, over dx.
   * @return 4 t (1 + t) (1/2 - t)^2, to be multiplied by rho g dx; 0 from 1/2 on.
   */
  double
  floor_excess(const double distance);

  /** What the weight does to the particles of a body. */
  struct Compression
  {
    static constexpr double least_ratio = 0.5; ///< J that is allowed

    double smallest_ratio = 1.; ///< J
    double largest_weight = 0.; ///< on particles with less, were their fluid incompressible [Pa]
  };

  /**
   * Fluids at rest under gravity: at a place in one, the pressure is the weight of the column of material
   * above it, per area across gravity, up to its free surface. That is where nothing follows over more than dx. In
   * the column count:
   * - hydrostatic fluids, compressed by what is above them, in layers with exact ends (pressure_below());
   * - other bodies, solids too, with their undeformed density;
   * - instead of rigid bodies what they displace: the fluid below, up to the height of its highest point. So
   *   the pressure in a pool with a level surface depends on the height alone, and bodies in it float.
   * Layers thinner than dx/2 may be missed. Bodies of points have no shape and do not count.
   *
   * A function of shapes alone, the same on all ranks.
   */
  template <int dim>
  class HydrostaticColumns
  {
  public:
    /**
     * @param parameters    of @p bodies, one each.
     * @param gravity       not 0 [m/s^2].
     * @param rigid_bodies  where they are at the start.
     */
    HydrostaticColumns(const std::vector<BodyParameters<dim>> &parameters,
                       const std::vector<Body<dim>> &bodies,
                       const Vector<dim> &gravity,
                       const Lattice<dim> &lattice,
                       const std::vector<Obstacle<dim>> &rigid_bodies);

    /**
     * Pressure in a body [Pa].
     *
     * @param place             in it, or a little outside, as some particles are: then by the nearest place inside
     *                          and the weight of the body's material between their heights.
     * @param without_yielding  as if the body's fluid were incompressible.
     */
    double
    pressure(const std::size_t body,
             const Vector<dim> &place,
             const bool without_yielding = false) const;

    /**
     * Compresses undeformed particles of a fluid where they are: J = 1 - p/K, with the floor_excess() at walls that
     * gravity points to, and V_0 and mass become V_0/J and rho_0 V_0/J, so that they fill what they filled.
     * Those that would be below the least ratio stay undeformed.
     */
    Compression
    compress(const std::size_t body, ParticleSet<dim> &particles) const;

  private:
    /** What a column meets in a body. */
    struct Content
    {
      std::unique_ptr<Shape<dim>> shape; ///< none of a list of points
      double density;                    ///< undeformed [kg/m^3]
      double bulk_modulus;               ///< K [Pa]; 0 of what weight does not compress
      double highest;                    ///< of the shape, along up [m]
    };

    struct Layer
    {
      int body; ///< nothing: -1
      double thickness;
    };

    std::vector<Content> contents;
    Lattice<dim> lattice;
    Vector<dim> gravity; ///< [m/s^2]
    Vector<dim> up;      ///< of length 1
    std::vector<Obstacle<dim>> rigid_bodies;

    /** The body at a place. @param below  that below it, which a rigid body displaces. @return -1: none. */
    int
    body_at(const Vector<dim> &place, const int below) const;

    /** What walls below ask for at a place [Pa]. */
    double
    excess_at_walls(const double density, const Vector<dim> &place) const;

    /** Upward from a place in a body. */
    std::vector<Layer>
    layers_above(const int body, const Vector<dim> &place) const;
  };
} // namespace magmpm
