#pragma once

#include <verification/magnetostatics/jittered_points.h>
#include <verification/magnetostatics/particle_setup.h>

#include <string>
#include <vector>

namespace magmpm::verification
{
  struct NamedError
  {
    std::string name;
    double value; ///< relative
  };

  /** What one case gives. */
  using Errors = std::vector<NamedError>;

  /** The error of a name. */
  double
  find_error(const Errors &errors, const std::string &name);

  /** What a body is made of, how fine the lattice is, and where in its cells the body lies. */
  struct AccuracyCase
  {
    double resolution   = 8.; ///< radius (or what stands for it) over dx
    unsigned int offset = 0;  ///< number of the random offset from the lattice, and of the jitter
    MaterialIndicator indicator = MaterialIndicator::sharp;
    int cell_edge               = 2;    ///< of mesh cells at material, in dx
    double susceptibility       = 0.91; ///< chi_0
    double argument             = 0.;   ///< a inside, Langevin law; 0: linear law
    double stretch              = 1.;   ///< F(0,0), how much the body was stretched along x
    double box_factor           = 2.;   ///< potential box over mechanical box
    MPI_Comm communicator       = MPI_COMM_WORLD;

    MagnetizationLaw
    law() const
    {
      return argument > 0. ? MagnetizationLaw::langevin : MagnetizationLaw::linear;
    }

    /** Of the body as it is, in full material. */
    MagneticContent
    content() const;
  };

  /** dx [m] of all cases. */
  inline constexpr double case_spacing = 1. / 128.;

  /** k2 = mu_0 m/(k_B T) of all Langevin media, that of Sun et al. 2021 [m/A]. */
  inline constexpr double argument_per_field = 3.31e-5;

  /**
   * The lattice and the magnetics of a case: a box of n cells, somewhere near its middle the centre
   * of what is looked at.
   */
  template <int dim>
  class CaseSetup
  {
  public:
    /** @param width  of the mechanical box at least, in dx; made a multiple of 8. */
    CaseSetup(const AccuracyCase &accuracy_case, const double width);

    /** Jittered particles in a region, 2^3 a cell (3^2 in 2D), of exactly its volume. */
    PointBody<dim>
    body(const Region<dim> &region, const double volume);

    /** The same of a sphere, stretched as the case says: a sphere is what it is after that. */
    PointBody<dim>
    sphere(const Vector<dim> &sphere_centre, const double radius);

    const AccuracyCase accuracy_case;
    const Lattice<dim> lattice;
    RandomNumbers random;
    const Vector<dim> centre; ///< the middle of the box, moved by up to dx along each axis [m]
    ParticleSetup<dim> magnetics;
  };

  /** A direction oblique to the lattice, a unit vector. */
  template <int dim>
  Vector<dim>
  oblique_direction();

  /** Another one. */
  template <int dim>
  Vector<dim>
  second_direction();

  /** |a - b|/|b|. */
  template <int dim>
  double
  relative_error(const Vector<dim> &a, const Vector<dim> &b)
  {
    return norm(a - b) / norm(b);
  }
} // namespace magmpm::verification
