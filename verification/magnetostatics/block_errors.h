#pragma once

#include <verification/magnetostatics/accuracy_case.h>

namespace magmpm::verification
{
  /** The shape of a block whose edges lie along the axes of the lattice, its faces anywhere. */
  template <int dim>
  struct BlockShape
  {
    Vector<dim> edges;     ///< over its last one, which is the case's resolution in dx
    bool is_round = false; ///< 3D: a disc or rod about the last axis, of diameter edges[0]
  };

  /**
   * A block of a linear medium in a uniform field along its last axis: "moment" along the field, against
   * magnetization_of_block(). Particles lie as a scene seeds them, 2^3 (3^2) a cell; those of round ones
   * are jittered.
   */
  template <int dim>
  class BlockErrors
  {
  public:
    explicit BlockErrors(const BlockShape<dim> &shape);

    Errors
    operator()(const AccuracyCase &accuracy_case);

  private:
    const BlockShape<dim> shape;
    double reference                   = 0.; ///< M/H_0; 0: not known yet
    double susceptibility_of_reference = 0.;

    double
    exact_magnetization(const double susceptibility) const;
  };
} // namespace magmpm::verification
