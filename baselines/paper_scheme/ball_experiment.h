#pragma once

#include <baselines/paper_scheme/paper_scheme.h>

namespace magmpm::paper_scheme
{
  /**
   * A magnetizable ball (2D: a cylinder across its axis) in the middle of a cubic box, in a uniform
   * field or near a dipole: what the scheme is measured with, as both have exact solutions.
   *
   * The ball is made of jittered particles, of equal volume and the ball's in sum; its
   * centre lies at a random place within the cell in the middle of the box.
   */
  template <int dim>
  struct BallExperiment
  {
    int cells_per_radius    = 8;    ///< R/dx
    double half_width       = 3.;   ///< of the box, in radii
    double radius           = 0.05; ///< R [m]
    MagnetizationLaw law    = MagnetizationLaw::linear;
    MagneticContent content = {82e3, 0.91};
    int particles_per_edge  = dim == 2 ? 3 : 2; ///< of a cell
    unsigned int seed       = 0;

    /** Deviations from the exact solution, relative to it. */
    struct Errors
    {
      double moment;          ///< component along the field, with sign
      double field_rms;       ///< of H on the nodes within 0.7 R
      double virial_trace;    ///< of the traction mu_0/2 M_n^2, with sign
      double virial_deviator; ///< with sign
      double net_force;       ///< over mu_0 M^2 V, though it is zero
    };

    double
    spacing() const
    {
      return radius / cells_per_radius;
    }

    /** All fields are along this. */
    static Vector<dim>
    direction();

    Vector<dim>
    centre() const;

    std::vector<Particle<dim>>
    particles() const;

    /** The box has its lower corner at the origin. */
    PaperScheme<dim>
    scheme(Parameters parameters) const;

    /** Field far away [A/m] that makes the field in the ball @p inner_field: H_0 = H + M(H)/dim. */
    double
    outer_field(const double inner_field) const;

    ExternalField<dim>
    uniform_field(const double strength) const;

    /** A magnet whose field outside is a dipole's, @p distance from the centre, in radii. */
    ExternalField<dim>
    dipole(const double distance) const;

    /** Errors of a @p scheme solved in the uniform_field(outer_field(@p inner_field)). */
    Errors
    errors(const PaperScheme<dim> &scheme,
           const ExternalField<dim> &sources,
           const double inner_field,
           const ForceRegion region = ForceRegion::reached_nodes) const;

    /** Force of the dipole on a ball of the linear law, towards it [N]; in 2D [N/m]. */
    double
    exact_dipole_force(const double distance) const;

    /** |F - F_exact|/|F_exact| of a @p scheme solved in the field of the dipole(). */
    double
    dipole_force_error(const PaperScheme<dim> &scheme,
                       const ExternalField<dim> &sources,
                       const double distance,
                       const ForceRegion region = ForceRegion::reached_nodes) const;

  private:
    static constexpr double magnet_radius        = 0.5; ///< in radii of the ball
    static constexpr double magnet_magnetization = 1e6; ///< [A/m]

    double
    volume(const double ball_radius) const;
  };
} // namespace magmpm::paper_scheme
